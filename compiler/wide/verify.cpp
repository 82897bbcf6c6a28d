// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "wide/assemble.hpp"

namespace rung::wide {
namespace {

using values::NodeKind;
using values::Values;
using values::Word;

// What a place holds, by name: a result of this scan, or what was there before it.
struct Symbol {
  enum class Kind : std::uint8_t { Unknown, Zero, Start, Computed, Flag };
  Kind kind = Kind::Unknown;
  Device device;              // Start
  std::int32_t made = kNone;  // Computed: look-up, or group; Flag: the test's operation
  std::int32_t word = kNone;  // Computed: place in its group
  bool operator==(const Symbol&) const = default;
};

class Checker {
 public:
  Checker(const Code& code, const Schedule& schedule, const Work& work, const Values& values,
          const Machine& machine)
      : code_(code), schedule_(schedule), work_(work), values_(values), machine_(machine) {
    bits_.assign(code.steps.size(), std::vector<Symbol>(machine.slots));
    words_.assign(code.steps.size(), std::vector<Symbol>(machine.units));
  }

  std::string run() {
    for (const auto& check :
         {&Checker::fill_places, &Checker::check_sizes, &Checker::check_functions,
          &Checker::check_look_ups, &Checker::check_groups, &Checker::check_homes}) {
      std::string problem = (this->*check)();
      if (!problem.empty()) return problem;
    }
    return {};
  }

 private:
  // ---- who computes what where ----
  std::string fill_places() {
    for (const auto& [device, address] : code_.addresses) {
      (is_word(device) ? start_words_ : start_bits_)[address] = device;
    }
    for (std::size_t i = 0; i < work_.look_ups.size(); ++i) {
      const Place& at = schedule_.look_ups[i];
      if (!inside(at, machine_.slots)) return fmt::format("look-up {} has no place", i);
      Symbol& symbol = bits_[at.step][at.lane];
      if (symbol.kind != Symbol::Kind::Unknown) return fmt::format("two look-ups at {}", text(at));
      symbol.kind = Symbol::Kind::Computed;
      symbol.made = static_cast<std::int32_t>(i);
    }
    for (std::size_t g = 0; g < work_.groups.size(); ++g) {
      tests_[work_.groups[g].test] = static_cast<std::int32_t>(g);
      for (std::size_t k = 0; k < work_.groups[g].words.size(); ++k) {
        const Place at = place(static_cast<std::int32_t>(g), static_cast<std::int32_t>(k));
        if (!inside(at, machine_.units)) return fmt::format("group {} has no place", g);
        Symbol& symbol = words_[at.step][at.lane];
        if (symbol.kind != Symbol::Kind::Unknown) return fmt::format("two words at {}", text(at));
        symbol.kind = Symbol::Kind::Computed;
        symbol.made = static_cast<std::int32_t>(g);
        symbol.word = static_cast<std::int32_t>(k);
      }
    }
    return {};
  }

  bool inside(const Place& at, int lanes) const {
    return at.step >= 0 && at.step < static_cast<int>(code_.steps.size()) && at.lane >= 0 &&
           at.lane < lanes;
  }
  static std::string text(const Place& at) { return fmt::format("step {}.{}", at.step, at.lane); }
  static std::string text(const Symbol& symbol) {
    static constexpr const char* kKinds[] = {"unknown", "zero", "start", "computed", "flag"};
    return fmt::format("{} {}.{} {}.{}", kKinds[static_cast<int>(symbol.kind)],
                       static_cast<int>(symbol.device.kind), symbol.device.number, symbol.made,
                       symbol.word);
  }
  Place place(std::int32_t group, std::int32_t word) const {
    return schedule_.word(work_, {group, word});
  }

  // Every device has a place of its own, unless they always hold the same.
  std::string check_sizes() {
    for (const auto& [device, address] : code_.addresses) {
      if (is_word(device)) {
        if (start_words_.at(address) != device) return "two words share a place";
        continue;
      }
      const Device other = start_bits_.at(address);
      if (other == device) continue;
      if (values_.starts.contains(device) || values_.starts.contains(other) ||
          values_.bits.at(device) != values_.bits.at(other)) {
        return "two bits share a place that somebody reads";
      }
    }
    return {};
  }

  // ---- functions: all nodes and all look-ups on random values ----
  std::string check_functions() {
    std::mt19937_64 random(1);
    std::vector<std::uint64_t> node(values_.nodes.size(), 0);
    for (std::size_t i = 0; i < node.size(); ++i) {
      const values::Node& n = values_.nodes[i];
      if (n.kind == NodeKind::Start || n.kind == NodeKind::Test) node[i] = random();
      if (n.kind == NodeKind::And) node[i] = of(node, n.left) & of(node, n.right);
    }
    for (std::size_t i = 0; i < work_.look_ups.size(); ++i) {
      const LookUp& look_up = work_.look_ups[i];
      if (look_up.gather) continue;
      std::uint64_t result = 0;
      for (int bit = 0; bit < 64; ++bit) {
        unsigned address = 0;
        for (int k = 0; k < look_up.cut.size; ++k) {
          const std::int32_t from = work_.provider[look_up.cut.leaves[k]];
          const NodeId leaf = look_up.cut.leaves[k];
          const bool computed = from != kNone && from != static_cast<std::int32_t>(i);
          const std::uint64_t value = computed ? of(node, work_.look_ups[from].value) : node[leaf];
          address = address << 1 | (value >> bit & 1U);
        }
        result |= static_cast<std::uint64_t>(look_up.cut.table >> address & 1U) << bit;
      }
      if (result != of(node, look_up.value)) return fmt::format("look-up {} is wrong", i);
    }
    return {};
  }
  static std::uint64_t of(const std::vector<std::uint64_t>& node, Literal literal) {
    const std::uint64_t value = node[values::node_of(literal)];
    return values::inverted(literal) ? ~value : value;
  }

  // ---- operands ----
  // What `operand` means for a reader in `lane` at `step`, of bits or of words.
  Symbol read(const Operand& operand, int step, int lane, bool word) const {
    Symbol symbol;
    const auto& made = word ? words_ : bits_;
    const int lanes = word ? machine_.units : machine_.slots;
    if (!is_near(operand)) return from_memory(operand, step, word);
    const int code = operand.row - kSpecialRow;
    if (code == constant::near_zero) {
      symbol.kind = Symbol::Kind::Zero;
    } else if (code == constant::near_flag) {
      if (!word) symbol = flag(step, lane / 2);
    } else {
      const int from = step - code;
      const int at = code >= constant::near_bus_first ? operand.lane : lane;
      if (from >= 0) return made[from][at];
      if (!word) return latched(from, at, lanes);
    }
    return symbol;
  }

  Symbol latched(int step, int lane, int lanes) const {
    for (int row = 0; row < code_.latch_rows; ++row) {
      if (work_.latch.step_of_row(row) == step) {
        return start((code_.first_latch_row + row) * lanes + lane, false);
      }
    }
    return {};
  }

  Symbol start(int address, bool word) const {
    Symbol symbol;
    const auto& all = word ? start_words_ : start_bits_;
    const auto found = all.find(address);
    if (found == all.end()) return symbol;
    symbol.kind = Symbol::Kind::Start;
    symbol.device = found->second;
    return symbol;
  }

  Symbol from_memory(const Operand& at, int step, bool word) const {
    const int lanes = word ? machine_.units : machine_.slots;
    if (at.lane >= lanes) return {};
    int written = at.row;
    const int behind = at.row - code_.first_latch_row;
    const bool latch = !word && behind >= 0 && behind < code_.latch_rows;
    if (latch) written = work_.latch.step_of_row(behind);
    const int distance = step - written;
    const Symbol old = start(at.row * lanes + at.lane, word);
    if (latch) return distance >= constant::distance_memory ? old : Symbol{};
    if (at.row >= static_cast<int>(code_.steps.size())) return old;
    if (distance >= constant::distance_memory) return (word ? words_ : bits_)[at.row][at.lane];
    return distance <= constant::distance_old ? old : Symbol{};
  }

  // The last test of the unit that a look-up at `step` sees.
  Symbol flag(int step, int unit) const {
    Symbol symbol;
    for (int from = step - constant::distance_flag; from >= 0; --from) {
      const Symbol& word = words_[from][unit];
      const Opcode opcode = code_.steps[from].words[unit].opcode;
      const bool test = opcode >= Opcode::Eq && opcode <= Opcode::Tb;
      if (!test || word.kind != Symbol::Kind::Computed) continue;
      symbol.kind = Symbol::Kind::Flag;
      symbol.made = word.made;
      return symbol;
    }
    return symbol;
  }

  std::string check_look_ups() {
    for (std::size_t i = 0; i < work_.look_ups.size(); ++i) {
      const LookUp& look_up = work_.look_ups[i];
      const Place& at = schedule_.look_ups[i];
      const BitInstruction& code = code_.steps[at.step].bits[at.lane];
      for (int k = 0; k < look_up.cut.size; ++k) {
        const Symbol got = read(code.inputs[k], at.step, at.lane, false);
        const Symbol meant = expected(look_up.cut.leaves[k], static_cast<std::int32_t>(i));
        if (got != meant) {
          return fmt::format("look-up {} at {}: input {} is {} instead of {}", i, text(at), k,
                             text(got), text(meant));
        }
      }
      const int unused = machine_.arity - look_up.cut.size;
      for (int address = 0; !look_up.gather && address < 1 << machine_.arity; ++address) {
        if ((code.table >> address & 1) != (look_up.cut.table >> (address >> unused) & 1)) {
          return fmt::format("look-up {} at {}: its table is another one", i, text(at));
        }
      }
    }
    return {};
  }

  Symbol expected(NodeId leaf, std::int32_t reader) const {
    Symbol symbol;
    const std::int32_t from = work_.provider[leaf];
    if (from != kNone && from != reader) {
      symbol.kind = Symbol::Kind::Computed;
      symbol.made = from;
      return symbol;
    }
    const values::Node& node = values_.nodes[leaf];
    if (node.kind == NodeKind::Start) {
      symbol.kind = Symbol::Kind::Start;
      symbol.device = start_bits_.at(code_.addresses.at(node.device));
    } else if (node.kind == NodeKind::Test) {
      symbol.kind = Symbol::Kind::Flag;
      symbol.made = tests_.at(node.operation);
    } else {
      symbol.kind = Symbol::Kind::Zero;
    }
    return symbol;
  }

  Symbol expected(const Word& word) const {
    Symbol symbol;
    if (word.kind == Word::Kind::Start) {
      symbol.kind = Symbol::Kind::Start;
      symbol.device = word.device;
    } else {
      const Work::Made& made = work_.made[word.operation][word.output];
      symbol.kind = Symbol::Kind::Computed;
      symbol.made = made.group;
      symbol.word = made.word;
    }
    return symbol;
  }

  // ---- groups ----
  std::string check_groups() {
    for (std::size_t g = 0; g < work_.groups.size(); ++g) {
      const Group& group = work_.groups[g];
      for (std::size_t k = 0; k < group.words.size(); ++k) {
        const Place at = place(static_cast<std::int32_t>(g), static_cast<std::int32_t>(k));
        std::string problem = check_word(group, group.words[k], at);
        if (problem.empty()) problem = check_collected(group, group.words[k], at);
        if (!problem.empty()) return fmt::format("group {} at {}: {}", g, text(at), problem);
      }
    }
    return {};
  }

  std::string check_word(const Group& group, const WordWork& work, const Place& at) const {
    const WordInstruction& code = code_.steps[at.step].words[at.lane];
    if (code.opcode != work.opcode) return "another instruction stands there";
    const Word& first = code.kind == 2 ? work.s2 : work.s1;
    const Word& second = code.kind == 2 ? work.s1 : work.s2;
    if (first.kind != Word::Kind::Constant &&
        read(code.s1, at.step, at.lane, true) != expected(first)) {
      return "its s1 is another value";
    }
    if (second.kind != Word::Kind::Constant) {
      if (code.kind != 0) return "it has a constant";
      if (read(code.s2, at.step, at.lane, true) != expected(second)) {
        return "its s2 is another value";
      }
    } else if (code.kind != 0 && code.constant != static_cast<std::uint16_t>(second.value)) {
      return "its constant is another one";
    }
    if ((group.divides && at.lane >= machine_.dividers) || (group.wide && at.lane != 0)) {
      return "its unit cannot do that";
    }
    if (!work.writes) return {};
    if (work.gate == kNone) {
      if (!code.always) return "it always runs";
    } else {
      const Place& gate = schedule_.look_ups[work.gate];
      if (code.always || gate.step != at.step - constant::distance_gate ||
          gate.lane != 2 * at.lane) {
        return "its gate is not before it";
      }
      const values::WordOp& op = values_.operations[work.operation];
      if (work_.look_ups[work.gate].value != op.gate) return "its gate is another value";
    }
    if (!work.keeps) return {};
    if (read(code.keep, at.step, at.lane, true) != expected(work.keep)) {
      return "it keeps another value";
    }
    const Symbol kept = expected(work.keep);
    const bool own = kept.kind == Symbol::Kind::Start
                         ? code_.addresses.at(kept.device) % machine_.units == at.lane
                         : schedule_.groups[kept.made].lane == at.lane;
    return own ? "" : "what it keeps is in another lane";
  }

  // The instruction that `work` goes on from.
  std::string check_collected(const Group& group, const WordWork& work, const Place& at) const {
    const auto stands = [&](int distance, std::initializer_list<Opcode> opcodes) {
      const int from = at.step - distance;
      if (from < 0 || words_[from][at.lane].made != words_[at.step][at.lane].made) return false;
      const Opcode opcode = code_.steps[from].words[at.lane].opcode;
      return std::find(opcodes.begin(), opcodes.end(), opcode) != opcodes.end();
    };
    const int wide = group.words.size() > 1 && group.words[1].opcode == Opcode::Muld
                         ? constant::distance_mul32
                         : constant::distance_div32;
    bool found = true;
    switch (work.opcode) {
      case Opcode::Adc:
        found = stands(constant::distance_carry, {Opcode::Add});
        break;
      case Opcode::Sbc:
        found = stands(constant::distance_carry, {Opcode::Sub});
        break;
      case Opcode::Ltc:
        found = stands(constant::distance_carry, {Opcode::Ltu});
        break;
      case Opcode::Mull:
        found = stands(machine_.mul, {Opcode::Mul});
        break;
      case Opcode::Mulh:
        found = stands(machine_.mul + 1, {Opcode::Mul});
        break;
      case Opcode::Quo:
        found = stands(machine_.div, {Opcode::Div});
        break;
      case Opcode::Rem:
        found = stands(machine_.div + 1, {Opcode::Div});
        break;
      case Opcode::Muld:
      case Opcode::Divd:
        found = stands(1, {Opcode::Ldh});
        break;
      case Opcode::Mw0:
      case Opcode::Mw1:
      case Opcode::Mw2:
      case Opcode::Mw3:
        found = stands(wide + static_cast<int>(work.opcode) - static_cast<int>(Opcode::Mw0),
                       {Opcode::Muld, Opcode::Divd});
        break;
      case Opcode::Mva:
        found = stands(constant::distance_accumulator, {Opcode::Get}) &&
                code_.steps[at.step - 1].words[at.lane].opcode != Opcode::Get;
        break;
      case Opcode::Get: {
        const Place& beside = schedule_.look_ups[work.gather];
        if (beside.step != at.step || beside.lane != 2 * at.lane) return "its bits are elsewhere";
        found = work.clear || stands(1, {Opcode::Get});
        break;
      }
      default:
        break;
    }
    return found ? "" : "what it goes on from is not there";
  }

  // ---- devices ----
  std::string check_homes() {
    for (const auto& [device, look_up] : work_.bit_home) {
      const Place& at = schedule_.look_ups[look_up];
      if (code_.addresses.at(device) != at.step * machine_.slots + at.lane ||
          work_.look_ups[look_up].value != values_.bits.at(device)) {
        return "a bit does not hold its last value";
      }
    }
    for (const auto& [device, made] : work_.word_home) {
      const Place at = place(made.group, made.word);
      if (code_.addresses.at(device) != at.step * machine_.units + at.lane) {
        return "a word does not hold its last value";
      }
      const WordWork& last = work_.groups[made.group].words[made.word];
      const Word& value = values_.words.at(device);
      const bool same = last.operation == value.operation && last.output == value.output;
      const bool copied = last.opcode == Opcode::Mv && last.gate == kNone && last.s2 == value;
      if (!same && !copied) return "a word does not hold its last value";
    }
    return {};
  }

  const Code& code_;
  const Schedule& schedule_;
  const Work& work_;
  const Values& values_;
  const Machine& machine_;
  std::vector<std::vector<Symbol>> bits_, words_;   // by step and lane
  std::map<std::int32_t, std::int32_t> tests_;      // operation -> its group
  std::map<int, Device> start_bits_, start_words_;  // by address
};

}  // namespace

std::string verify(const Code& code, const Schedule& schedule, const Work& work,
                   const Values& values, const Machine& machine) {
  return Checker(code, schedule, work, values, machine).run();
}

}  // namespace rung::wide
