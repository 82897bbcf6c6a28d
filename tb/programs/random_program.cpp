// SPDX-License-Identifier: Apache-2.0
#include "programs/random_program.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string_view>

#include "programs/random_source.hpp"

namespace rung {
namespace {

// Blocks and branches within one another stay this shallow; deeper ones are rare in real programs,
// and the depth limits have directed tests.
constexpr int kDeepestBlock = 4;
constexpr int kDeepestBranch = 4;
// Bounds for what a chance of 100 % would repeat for ever.
constexpr int kMostBlocks = 6;
constexpr int kMostOutputs = 6;
constexpr int kMostContinuations = 8;
constexpr int kMostBranchings = 8;

// Constants worth trying beside any other: where signs, carries and divisions go wrong.
constexpr std::array kCorners = {0, 1, -1, 2, -2, 3, 7, 10, 255, 256, 32767, -32768, -32767};

class Writer {
 public:
  Writer(std::uint64_t seed, const RandomProgramOptions& options)
      : random_(seed), options_(options) {}

  std::string write() {
    text_ = fmt::format("; dialect {}\n", dialect_name(options_.dialect));
    for (int i = 0; i < options_.networks; ++i) {
      continuations_ = 0;
      branchings_ = 0;
      logic(0);
      outputs(0);
    }
    return std::move(text_) + "END\n";
  }

 private:
  void line(std::string_view instruction) {
    if (random_.percent(options_.nop_percent)) text_ += "NOP\n";
    text_ += instruction;
    text_ += '\n';
  }

  void line(std::string_view name, const std::string& operands) {
    line(fmt::format("{} {}", name, operands));
  }

  std::string bit(DeviceKind kind, int count) {
    return device_name({kind, static_cast<std::uint32_t>(random_.below(count))}, options_.dialect);
  }

  std::string contact_device() {
    switch (random_.weighted(options_.contact_weights)) {
      case 0:
        return bit(DeviceKind::X, options_.inputs);
      case 1:
        return bit(DeviceKind::Y, options_.outputs);
      default:
        return bit(DeviceKind::M, options_.relays);
    }
  }

  std::string coil_device() {
    return random_.percent(50) ? bit(DeviceKind::Y, options_.outputs)
                               : bit(DeviceKind::M, options_.relays);
  }

  std::string word_device(int beyond = 0) {
    return fmt::format("D{}", random_.below(options_.words - beyond));
  }

  std::string constant() {
    const int value =
        random_.percent(60)
            ? kCorners[static_cast<std::size_t>(random_.below(static_cast<int>(kCorners.size())))]
            : random_.below(65536) - 32768;
    if (random_.percent(20)) return fmt::format("H{:X}", value & 0xFFFF);
    return fmt::format("K{}", value);
  }

  std::string word_source() { return random_.percent(35) ? constant() : word_device(); }

  // Contacts that change the current result.
  void series(int count) {
    static constexpr std::array kNames = {"AND", "ANI", "OR", "ORI"};
    for (int i = 0; i < count; ++i) {
      const char* const name = kNames[static_cast<std::size_t>(random_.below(4))];
      line(name, contact_device());
    }
  }

  // One block: a run, perhaps joined with further blocks.
  void logic(int depth) {
    const auto run = static_cast<int>(random_.weighted(options_.run_lengths));
    const char* const load = random_.percent(70) ? "LD" : "LDI";
    line(load, contact_device());
    series(run);
    if (depth + 1 == kDeepestBlock) return;
    for (int i = 0; i < kMostBlocks && random_.percent(options_.block_percent); ++i) {
      logic(depth + 1);
      line(random_.percent(50) ? "ANB" : "ORB");
      if (random_.percent(40)) series(1 + random_.below(2));
    }
  }

  // Outputs of the current result. Within `branches` open ones a block may follow an output, else
  // its LD would begin a new network.
  void outputs(int branches) {
    if (branches < kDeepestBranch && branchings_ < kMostBranchings &&
        random_.percent(options_.branch_percent)) {
      ++branchings_;
      line("MPS");
      branch(branches + 1);
      while (random_.percent(40)) {
        line("MRD");
        branch(branches + 1);
      }
      line("MPP");
      branch(branches);
      return;
    }
    output();
    for (int i = 1; i < kMostOutputs && random_.percent(options_.more_outputs_percent); ++i) {
      output();
    }
    if (continuations_ == kMostContinuations || !random_.percent(options_.continue_percent)) return;
    ++continuations_;
    if (branches > 0 && random_.percent(options_.block_percent)) {
      logic(1);
      line("ANB");
    } else {
      series(1 + random_.below(3));
    }
    outputs(branches);
  }

  // What stands behind one MPS, MRD or MPP: contacts, if any, and outputs.
  void branch(int branches) {
    if (random_.percent(options_.block_percent)) {
      logic(1);
      line(random_.percent(70) ? "ANB" : "ORB");
    } else if (random_.percent(75)) {
      series(1 + random_.below(3));
    }
    outputs(branches);
  }

  void output() {
    if (random_.percent(options_.word_percent)) return word_output();
    if (random_.percent(options_.set_reset_percent)) {
      const char* const name = random_.percent(50) ? "SET" : "RST";
      return line(name, coil_device());
    }
    line("OUT", coil_device());
  }

  void word_output() {
    const bool q = options_.dialect == Dialect::Q;
    const bool paper = options_.dialect == Dialect::Paper;
    if (options_.set_reset_percent > 0 && random_.percent(5)) return line("RST", word_device());
    if (!random_.percent(options_.multiply_percent)) {
      if (random_.percent(40)) {
        const std::string source = word_source();
        return line(paper ? "MV" : "MOV", fmt::format("{} {}", source, word_device()));
      }
      return arithmetic(random_.percent(50) ? (q ? "+" : "ADD") : (q ? "-" : "SUB"), 0);
    }
    // In fx and q the result takes a second word.
    arithmetic(random_.percent(50) ? (q ? "*" : "MUL") : (q ? "/" : "DIV"), paper ? 0 : 1);
  }

  void arithmetic(std::string_view name, int beyond) {
    const bool two = options_.dialect != Dialect::Fx && random_.percent(40);
    std::string sources = word_source();
    if (!two) {
      sources += ' ';
      sources += word_source();
    }
    line(name, fmt::format("{} {}", sources, word_device(beyond)));
  }

  RandomSource random_;
  const RandomProgramOptions& options_;
  std::string text_;
  int continuations_ = 0;  // in this network
  int branchings_ = 0;     // in this network
};

}  // namespace

RandomProgramOptions paper_options() {
  RandomProgramOptions options;
  options.dialect = Dialect::Paper;
  options.block_percent = 0;
  options.branch_percent = 0;
  options.set_reset_percent = 0;
  return options;
}

std::string random_program(std::uint64_t seed, const RandomProgramOptions& options) {
  return Writer(seed, options).write();
}

}  // namespace rung
