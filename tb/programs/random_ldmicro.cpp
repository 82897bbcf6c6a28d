// SPDX-License-Identifier: Apache-2.0
#include "programs/random_ldmicro.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>

#include "programs/ldmicro_elements.hpp"
#include "programs/random_source.hpp"

namespace rung {
namespace {

// Deeper nesting and longer series are rare in real programs, and their limits have directed tests.
constexpr int kDeepest = 3;
constexpr int kMostItems = 4;
constexpr int kMostBranches = 3;
// A program's elements: one that has passed this gets no further parallel branches.
constexpr int kManyElements = 50;

class Writer {
 public:
  Writer(std::uint64_t seed, const RandomLdmicroOptions& options)
      : random_(seed), options_(options), elements_(random_, options_) {}

  std::string write() {
    header();
    for (int i = 0; i < options_.rungs; ++i) rung();
    return std::move(text_);
  }

 private:
  void line(std::string_view text) {
    text_ += fmt::format("{:{}}{}\n", "", static_cast<int>(4 * indent_), text);
  }
  void begin(std::string_view text) {
    line(text);
    ++indent_;
  }
  void end() {
    --indent_;
    line("END");
  }

  void header() {
    text_ = fmt::format("LDmicro0.1\nCYCLE={}\nCRYSTAL=4000000\nBAUD=2400\n\nIO LIST\n",
                        options_.cycle_us);
    for (int i = 0; i < options_.inputs; ++i) text_ += fmt::format("    X{} at 0\n", i);
    for (int i = 0; i < options_.outputs; ++i) text_ += fmt::format("    Y{} at 0\n", i);
    text_ += "END\n\nPROGRAM\n";
  }

  void rung() {
    begin("RUNG");
    const int kind = random_.below(100);
    if (kind < 3) {
      line(R"(COMMENT made by rule\nsecond line)");
    } else if (kind < 92) {
      series(0);
      if (random_.percent(75)) element(elements_.coil());
    } else if (kind < 98 && options_.weight(LdmicroFamily::Relay) > 0) {
      if (random_.percent(80)) element(elements_.contact());
      element("MASTER_RELAY");
    }  // else a rung without elements
    end();
  }

  void element(const std::string& text) {
    line(text);
    ++count_;
  }

  // Items one behind the other. A contact comes first more often than not, so that what follows
  // meets a condition that goes on and off.
  void series(int depth) {
    if (random_.percent(depth == 0 ? 70 : 50)) element(elements_.contact());
    for (int items = 1 + random_.below(kMostItems - depth); items > 0; --items) item(depth);
  }

  void item(int depth) {
    if (depth < kDeepest && count_ < kManyElements &&
        random_.percent(options_.weight(LdmicroFamily::Parallels))) {
      return parallel(depth);
    }
    leaf();
  }

  void leaf() {
    const int kind = random_.below(100);
    element(kind < 12 ? elements_.contact() : kind < 27 ? elements_.coil() : elements_.other());
  }

  void parallel(int depth) {
    begin("PARALLEL");
    // Of one branch alone at times.
    int branches = random_.percent(4) ? 1 : 2 + random_.below(kMostBranches - 1);
    for (; branches > 0; --branches) {
      if (random_.percent(35)) {
        leaf();
        continue;
      }
      begin("SERIES");
      if (!random_.percent(4)) series(depth + 1);  // else a branch without elements
      end();
    }
    end();
  }

  RandomSource random_;
  const RandomLdmicroOptions& options_;
  LdmicroElements elements_;
  std::string text_;
  int indent_ = 0;
  int count_ = 0;
};

// A program takes one of these.
std::array<int, 5> weights_of(LdmicroFamily family) {
  switch (family) {
    case LdmicroFamily::Parallels:
      return {0, 10, 15, 20, 30};
    case LdmicroFamily::Shared:
      return {0, 0, 0, 8, 20};
    case LdmicroFamily::Wires:
    case LdmicroFamily::Relay:
    case LdmicroFamily::Lasting:
      return {0, 0, 1, 2, 4};
    case LdmicroFamily::Strings:
    case LdmicroFamily::Serial:
    case LdmicroFamily::Analogue:
      return {0, 0, 2, 5, 12};
    case LdmicroFamily::Registers:
      return {0, 0, 3, 6, 12};
    default:
      return {0, 2, 4, 9, 16};
  }
}

constexpr std::int64_t kCyclesUs[] = {100, 1'000, 5'000, 7'300, 10'000, 10'000, 20'000, 50'000};

}  // namespace

RandomLdmicroOptions ldmicro_options(std::uint64_t seed) {
  RandomSource random(seed ^ 0x6C6164646572);
  RandomLdmicroOptions options;
  options.rungs = 2 + random.below(6);
  options.inputs = 2 + random.below(5);
  options.outputs = 2 + random.below(3);
  options.relays = 2 + random.below(4);
  options.variables = 2 + random.below(5);
  options.cycle_us = kCyclesUs[random.below(static_cast<int>(std::size(kCyclesUs)))];
  for (int i = 0; i < kLdmicroFamilies; ++i) {
    const auto family = static_cast<LdmicroFamily>(i);
    options.weight(family) = weights_of(family)[static_cast<std::size_t>(random.below(5))];
  }
  return options;
}

std::string random_ldmicro(std::uint64_t seed, const RandomLdmicroOptions& options) {
  return Writer(seed, options).write();
}

}  // namespace rung
