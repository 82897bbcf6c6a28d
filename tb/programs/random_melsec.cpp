// SPDX-License-Identifier: Apache-2.0
#include "programs/random_melsec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "programs/melsec_operands.hpp"
#include "programs/melsec_outputs.hpp"
#include "programs/random_source.hpp"

namespace rung {
namespace {

constexpr std::string_view kFamilyNames[] = {
    "bits",    "edges",   "timers",   "counters", "moves",  "arithmetic", "logic", "shifts",
    "rotates", "ranges",  "codes",    "compares", "digits", "wordbits",   "index", "wide",
    "pulse",   "special", "branches", "zones",    "states", "flow"};
static_assert(std::size(kFamilyNames) == kFamilies);

constexpr int kDeepestBlock = 3;
constexpr int kDeepestBranch = 3;
constexpr int kMostBlocks = 3;
constexpr int kMostOutputs = 3;
constexpr int kMostZones = 3;
constexpr int kMostLoops = 2;
constexpr int kMostRoutines = 3;
// The first pointers of jumps and of subroutines.
constexpr int kFirstLabel = 0;
constexpr int kFirstRoutine = 40;
constexpr int kEndLabel = 63;

// Where in the program something stands, and so what may stand there.
struct Place {
  int zones = 0;  // open MC zones
  int loops = 0;
  bool plain = true;   // not in a state: zones, loops and jumps may begin here
  bool states = true;  // on the outermost level of the main routine: states may begin here, and
                       // a jump to END
  int routine = 0;     // subroutines numbered from here on may be called
};

class Writer {
 public:
  Writer(std::uint64_t seed, const RandomMelsecOptions& options)
      : random_(seed),
        options_(options),
        operands_(random_, options_),
        outputs_(random_, options_, operands_) {}

  std::string write() {
    text_ = fmt::format("; dialect {}\n", dialect_name(options_.dialect));
    if (operands_.has(Family::Flow)) routines_ = random_.below(kMostRoutines + 1);
    parts(options_.networks, {});
    // A subroutine calls only later ones, so that none calls itself.
    if (std::find(called_.begin(), called_.end(), true) != called_.end()) line("FEND");
    for (int routine = 0; routine < routines_; ++routine) {
      if (!called_[static_cast<std::size_t>(routine)]) continue;
      line(fmt::format("P{}", kFirstRoutine + routine));
      Place place;
      place.states = false;
      place.routine = routine + 1;
      parts(1 + random_.below(3), place);
      line(operands_.fx() || random_.percent(50) ? "SRET" : "RET");
    }
    return std::move(text_) + "END\n";
  }

 private:
  void line(std::string_view instruction) {
    if (random_.percent(1)) text_ += "NOP\n";
    text_ += instruction;
    text_ += '\n';
  }

  void line(std::string_view name, const std::string& operands) {
    line(fmt::format("{} {}", name, operands));
  }

  // About `count` networks with what encloses them.
  void parts(int count, const Place& place) {
    const int end = networks_ + count;
    while (networks_ < end) part(place);
  }

  void part(const Place& place) {
    if (place.plain) {
      if (place.zones < kMostZones && operands_.chance(Family::Zones)) return zone(place);
      if (operands_.chance(Family::Flow)) return random_.percent(50) ? loop(place) : jump(place);
      if (place.states && operands_.fx() && operands_.chance(Family::States)) return states(place);
    }
    network(place);
  }

  void network(const Place& place) {
    ++networks_;
    logic(0);
    outputs(place, 0);
  }

  // MC ... MCR; at times two zones that one MCR closes.
  void zone(const Place& place) {
    Place inner = place;
    inner.states = false;
    const int depth = place.zones + 2 <= kMostZones && random_.percent(20) ? 2 : 1;
    for (int i = 0; i < depth; ++i) {
      ++networks_;
      logic(0);
      line("MC", fmt::format("N{} {}", inner.zones++, operands_.coil(false)));
    }
    parts(1 + random_.below(2), inner);
    line("MCR", fmt::format("N{}", place.zones));
  }

  void loop(const Place& place) {
    if (place.loops == kMostLoops) return network(place);
    line("FOR", fmt::format("K{}", 1 + random_.below(3)));
    Place inner = place;
    ++inner.loops;
    inner.states = false;
    parts(1 + random_.below(2), inner);
    line("NEXT");
  }

  void jump(const Place& place) {
    // On the outermost level of an fx program, P63 is END.
    const bool to_end = operands_.fx() && place.states && random_.percent(10);
    const int label = to_end ? kEndLabel : next_label_++;
    const auto leap = [&] {
      ++networks_;
      logic(0);
      if (random_.percent(30)) line(outputs_.output());
      line(operands_.chance(Family::Pulse) ? "CJP" : "CJ", fmt::format("P{}", label));
    };
    leap();
    if (to_end) return;
    parts(1 + random_.below(2), place);
    if (random_.percent(20)) {
      leap();
      network(place);
    }
    line(fmt::format("P{}", label));
  }

  // A chain of states; what begins it stands before.
  void states(const Place& place) {
    line(random_.percent(50) ? "LD M8002" : "LD X0");
    line("SET", operands_.state());
    Place inner = place;
    inner.plain = false;
    const int count = 1 + random_.below(3);
    for (int i = 0; i < count; ++i) {
      line("STL", operands_.state());
      if (random_.percent(15)) line("STL", operands_.state());
      // An output may stand right behind STL.
      if (random_.percent(50)) line(outputs_.output());
      const int networks = random_.below(2);
      for (int n = 0; n < networks; ++n) network(inner);
      ++networks_;
      logic(0);
      const int which = random_.below(100);
      line(which < 75 ? "SET" : which < 90 ? "OUT" : "RST", operands_.state());
    }
    line("RET");
  }

  // Contacts. `prefix` is LD, AND or OR.
  void contact(std::string_view prefix) {
    if (operands_.has(Family::Compares) && random_.percent(12)) {
      static constexpr const char* kRelations[] = {"=", "<>", "<", ">", "<=", ">="};
      const bool wide = operands_.chance(Family::Wide);
      const int width = wide ? 32 : 16;
      const char* const relation = kRelations[random_.below(6)];
      const std::string left = operands_.source(width);
      return line(fmt::format("{}{}{} {} {}", prefix, wide ? "D" : "", relation, left,
                              operands_.source(width)));
    }
    if (operands_.chance(Family::Edges)) {
      return line(fmt::format("{}{}", prefix, random_.percent(50) ? "P" : "F"),
                  operands_.contact(false));
    }
    const bool inverse = random_.percent(30);
    const std::string_view inverted = prefix == "LD" ? "LDI" : prefix == "AND" ? "ANI" : "ORI";
    line(inverse ? inverted : prefix, operands_.contact(true));
  }

  // Contacts and the like that change the current result.
  void series(int count) {
    for (int i = 0; i < count; ++i) contact(random_.percent(50) ? "AND" : "OR");
    if (operands_.has(Family::Edges) && random_.percent(12)) {
      static constexpr const char* kNames[] = {"INV", "MEP", "MEF"};
      line(kNames[random_.below(3)]);
    }
  }

  void logic(int depth) {
    static constexpr int kRuns[] = {5, 4, 2, 1};
    contact("LD");
    series(static_cast<int>(random_.weighted(kRuns)));
    if (depth + 1 == kDeepestBlock) return;
    for (int i = 0; i < kMostBlocks && random_.percent(15); ++i) {
      logic(depth + 1);
      line(random_.percent(50) ? "ANB" : "ORB");
      if (random_.percent(40)) series(1);
    }
  }

  void output(const Place& place) {
    if (operands_.has(Family::Flow) && place.routine < routines_ && random_.percent(10)) {
      const int routine = place.routine + random_.below(routines_ - place.routine);
      called_[static_cast<std::size_t>(routine)] = true;
      return line(operands_.chance(Family::Pulse) ? "CALLP" : "CALL",
                  fmt::format("P{}", kFirstRoutine + routine));
    }
    line(outputs_.output());
  }

  // Outputs of the current result. Within `branches` open ones a block may follow an output, else
  // its LD would begin a new network.
  void outputs(const Place& place, int branches) {
    if (branches < kDeepestBranch && operands_.chance(Family::Branches)) {
      line("MPS");
      branch(place, branches + 1);
      while (random_.percent(30)) {
        line("MRD");
        branch(place, branches + 1);
      }
      line("MPP");
      return branch(place, branches);
    }
    output(place);
    for (int i = 1; i < kMostOutputs && random_.percent(25); ++i) output(place);
    if (!random_.percent(10)) return;
    series(1);
    output(place);
  }

  void branch(const Place& place, int branches) {
    if (random_.percent(20)) {
      logic(1);
      line(random_.percent(70) ? "ANB" : "ORB");
    } else if (random_.percent(75)) {
      series(1 + random_.below(2));
    }
    outputs(place, branches);
  }

  RandomSource random_;
  const RandomMelsecOptions& options_;
  MelsecOperands operands_;
  MelsecOutputs outputs_;
  std::string text_;
  int networks_ = 0;
  int next_label_ = kFirstLabel;
  int routines_ = 0;
  std::array<bool, kMostRoutines> called_{};
};

// A program takes one of these: weights of outputs, chances of operands, forms and parts.
std::array<int, 5> weights_of(Family family) {
  if (family == Family::Wide || family == Family::Pulse) return {0, 10, 25, 50, 70};
  if (family >= Family::Branches) return {0, 0, 5, 10, 20};
  if (family >= Family::Digits) return {0, 0, 8, 20, 40};
  if (family >= Family::Moves) return {0, 3, 6, 10, 15};
  return {0, 0, 4, 9, 16};
}

}  // namespace

std::string_view family_name(Family family) {
  return kFamilyNames[static_cast<std::size_t>(family)];
}

std::optional<Family> find_family(std::string_view name) {
  const auto* const found = std::find(std::begin(kFamilyNames), std::end(kFamilyNames), name);
  if (found == std::end(kFamilyNames)) return std::nullopt;
  return static_cast<Family>(found - std::begin(kFamilyNames));
}

RandomMelsecOptions melsec_options(std::uint64_t seed) {
  RandomSource random(seed ^ 0x6D656C73);
  RandomMelsecOptions options;
  options.dialect = random.percent(50) ? Dialect::Fx : Dialect::Q;
  options.networks = 3 + random.below(7);
  options.inputs = 4 + random.below(8);
  options.outputs = 2 + random.below(8);
  options.relays = 4 + random.below(16);
  options.words = 4 + random.below(7);
  for (int i = 0; i < kFamilies; ++i) {
    const auto family = static_cast<Family>(i);
    options.weight(family) = weights_of(family)[static_cast<std::size_t>(random.below(5))];
  }
  options.weight(Family::Bits) = 8;
  return options;
}

std::string random_melsec(std::uint64_t seed, const RandomMelsecOptions& options) {
  return Writer(seed, options).write();
}

void MelsecCoverage::count(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.starts_with(';')) continue;
    const std::size_t blank = std::min(line.find(' '), line.size());
    const std::string name(line.substr(0, blank));
    ++counts_[name];
    const std::string_view operands = line.substr(blank);
    if (operands.empty()) continue;
    // The letters of the first operand: T of T0, D of D0Z0.
    std::string_view first = operands.substr(1);
    first = first.substr(0, first.find_first_of("0123456789-"));
    ++counts_[fmt::format("{} {}", name, first)];
    if (operands.find('.') != std::string_view::npos) ++counts_["word bit"];
    for (std::size_t i = 1; i + 1 < operands.size(); ++i) {
      const bool after_digit = std::isdigit(static_cast<unsigned char>(operands[i - 1])) != 0;
      if (!after_digit) continue;
      const char c = operands[i];
      if (c == 'Z' || c == 'V') ++counts_["index"];
      if (c == 'X' || c == 'Y' || c == 'M' || c == 'S') ++counts_["digits"];
    }
  }
}

std::uint64_t MelsecCoverage::of(const std::string& key) const {
  const auto found = counts_.find(key);
  return found == counts_.end() ? 0 : found->second;
}

}  // namespace rung
