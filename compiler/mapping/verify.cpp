// SPDX-License-Identifier: Apache-2.0
// The check of a mapping, on its own terms: it evaluates logic and look-ups side by side on random
// values, 64 at a time, and knows nothing of cuts or of how the mapping was made.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "mapping/mapping.hpp"

namespace rung::mapping {
namespace {

using logic::Logic;
using logic::NodeKind;
using logic::Version;

using Word = std::uint64_t;

class Checker {
 public:
  Checker(const Mapping& mapping, const Logic& logic, const core::Program& program)
      : mapping_(mapping), logic_(logic), program_(program) {}

  std::string run() {
    if (std::string problem = find_units(); !problem.empty()) return problem;
    if (std::string problem = check_actions(); !problem.empty()) return problem;
    if (std::string problem = check_bound(); !problem.empty()) return problem;
    for (int round = 0; round < 4; ++round) {
      evaluate_logic();
      values_.assign(mapping_.ops.size(), 0);
      known_.assign(mapping_.ops.size(), false);
      for (std::size_t i = 0; i < mapping_.ops.size(); ++i) {
        const MappedOp& op = mapping_.ops[i];
        if (op.action < 0 || isa::info(op.opcode).gate == isa::Gate::Unit || op.always) continue;
        const OpId source = is_lookup(op.opcode) ? static_cast<OpId>(i) : op.condition;
        const Word expected = nodes_[logic_.actions[op.action].condition];
        if (value(source) != expected) {
          return fmt::format(
              "op {}: the condition of core instruction {} is not what its contacts say", i,
              op.instruction);
        }
      }
    }
    return {};
  }

 private:
  std::string find_units() {
    previous_exc_.assign(mapping_.ops.size(), kNoOp);
    std::vector<int> seen(mapping_.ops.size(), 0);
    for (const Unit& unit : mapping_.units) {
      OpId exc = kNoOp;
      for (const OpId id : unit.ops) {
        const MappedOp& op = mapping_.ops[id];
        ++seen[id];
        previous_exc_[id] = exc;
        if (isa::info(op.opcode).gate == isa::Gate::Exc || op.opcode == isa::Opcode::Out) {
          if (!op.always && op.condition != exc)
            return fmt::format("op {}: runs under a foreign condition", id);
        }
        if (writes_exc(op.opcode)) exc = id;
        if (op.destination.kind == Destination::Kind::Temporary) {
          if (!temporary_.emplace(op.destination.temporary, id).second) {
            return fmt::format("op {}: temporary t{} is written twice", id,
                               op.destination.temporary);
          }
        }
      }
      for (const OpId id : unit.collectors) ++seen[id];
    }
    const auto wrong = std::find_if(seen.begin(), seen.end(), [](int n) { return n != 1; });
    if (wrong == seen.end()) return {};
    return fmt::format("op {}: stands in {} units", wrong - seen.begin(), *wrong);
  }

  // Every device write of every action is done by exactly one operation.
  std::string check_actions() const {
    std::set<std::pair<std::int32_t, Device>> done;
    for (std::size_t i = 0; i < mapping_.ops.size(); ++i) {
      const MappedOp& op = mapping_.ops[i];
      std::vector<Device> written = op.window;
      if (op.destination.kind == Destination::Kind::Device) written = {op.destination.device};
      for (const Device device : written) {
        if (op.action < 0 || op.destination.version != op.action ||
            !done.emplace(op.action, device).second) {
          return fmt::format("op {}: writes for no action, or a second time", i);
        }
      }
    }
    std::size_t expected = 0;
    for (std::size_t a = 0; a < logic_.actions.size(); ++a) {
      for (const Device device : logic_.actions[a].targets) {
        ++expected;
        if (done.count({static_cast<std::int32_t>(a), device}) == 0) {
          return fmt::format("action {}: nothing writes {}{}", a, kind_name(device), device.number);
        }
      }
    }
    return done.size() == expected ? std::string() : "an operation writes what no action writes";
  }

  static std::string kind_name(Device device) {
    return fmt::format("kind {} number ", static_cast<int>(device.kind));
  }

  std::string check_bound() const {
    std::vector<int> lookups(program_.networks.size(), 0);
    for (const MappedOp& op : mapping_.ops) {
      if (!is_lookup(op.opcode)) continue;
      const auto after = std::upper_bound(
          program_.networks.begin(), program_.networks.end(), op.instruction,
          [](std::size_t i, const core::Network& network) { return i < network.first; });
      ++lookups[after - program_.networks.begin() - 1];
    }
    for (std::size_t n = 0; n < lookups.size(); ++n) {
      if (!is_plain(program_.networks[n])) continue;
      const int bound = lookup_bound(program_, program_.networks[n]);
      if (lookups[n] > bound) {
        return fmt::format("rung {}: {} look-ups where the formula allows {}", n, lookups[n],
                           bound);
      }
    }
    return {};
  }

  // The paper's formula speaks of rungs of contacts and outputs, not of what lowering makes of
  // others.
  bool is_plain(const core::Network& network) const {
    const auto first = program_.instructions.begin() + static_cast<std::ptrdiff_t>(network.first);
    return std::none_of(first, first + static_cast<std::ptrdiff_t>(network.count),
                        [](const core::Instruction& instruction) {
                          return instruction.always || instruction.op == core::Op::Inv ||
                                 instruction.op == core::Op::Pop ||
                                 std::any_of(instruction.targets.begin(), instruction.targets.end(),
                                             [](Device d) { return is_hidden(d.kind); });
                        });
  }

  // Random values for what the scan starts with; what actions write follows from them.
  void evaluate_logic() {
    bits_.clear();
    nodes_.assign(logic_.nodes.size(), 0);
    std::size_t action = 0;
    const auto act = [&](std::size_t a) {
      const auto& source = logic_.actions[a];
      if (!core::is_coil(source.op)) return;
      const Device target = source.targets[0];
      const auto number = static_cast<Version>(a);
      const Word condition =
          source.condition == logic::kNoNode ? ~Word{0} : nodes_[source.condition];
      const Word before = bit(target, logic_.current(target, number));
      const Word after = source.op == core::Op::Out   ? condition
                         : source.op == core::Op::Set ? before | condition
                                                      : before & ~condition;
      bits_[{target, number}] = after;
    };
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const logic::Node& node = logic_.nodes[i];
      while (action < static_cast<std::size_t>(node.epoch)) act(action++);
      switch (node.kind) {
        case NodeKind::Leaf:
          nodes_[i] = bit(node.device, node.version);
          break;
        case NodeKind::NotLeaf:
        case NodeKind::Not:
          nodes_[i] = ~nodes_[node.left];
          break;
        case NodeKind::And:
          nodes_[i] = nodes_[node.left] & nodes_[node.right];
          break;
        case NodeKind::Or:
          nodes_[i] = nodes_[node.left] | nodes_[node.right];
          break;
      }
    }
    while (action < logic_.actions.size()) act(action++);
  }

  Word bit(Device device, Version version) {
    const auto [place, fresh] = bits_.try_emplace({device, version}, 0);
    if (fresh) place->second = random_();
    return place->second;
  }

  Word value(OpId id) {
    if (known_[id]) return values_[id];
    const MappedOp& op = mapping_.ops[id];
    if (!writes_exc(op.opcode)) return value(op.condition);  // an OUT to a temporary
    Word inputs[3] = {};
    for (int i = 0; i < 3; ++i) {
      const BitValue& input = op.inputs[i];
      switch (input.kind) {
        case BitValue::Kind::None:
          inputs[i] = random_();  // must not matter
          break;
        case BitValue::Kind::N0:
          inputs[i] = previous_exc_[id] == kNoOp ? random_() : value(previous_exc_[id]);
          break;
        case BitValue::Kind::Device:
          inputs[i] = bit(input.device, input.version);
          break;
        case BitValue::Kind::Temporary:
          inputs[i] = value(temporary_.at(input.temporary));
          break;
      }
    }
    Word result = inputs[0];
    if (is_lookup(op.opcode)) {
      result = 0;
      for (int address = 0; address < 8; ++address) {
        if ((op.function >> address & 1) == 0) continue;
        result |= (address & 4 ? inputs[0] : ~inputs[0]) & (address & 2 ? inputs[1] : ~inputs[1]) &
                  (address & 1 ? inputs[2] : ~inputs[2]);
      }
    }
    known_[id] = true;
    return values_[id] = result;
  }

  const Mapping& mapping_;
  const Logic& logic_;
  const core::Program& program_;
  std::vector<OpId> previous_exc_;
  std::map<std::int32_t, OpId> temporary_;
  std::map<std::pair<Device, Version>, Word> bits_;
  std::vector<Word> nodes_;
  std::vector<Word> values_;
  std::vector<bool> known_;
  std::mt19937_64 random_{20130301};
};

}  // namespace

bool is_lookup(isa::Opcode opcode) {
  return opcode == isa::Opcode::Lut || opcode == isa::Opcode::Luto || opcode == isa::Opcode::Luts ||
         opcode == isa::Opcode::Lutr;
}

bool writes_exc(isa::Opcode opcode) { return is_lookup(opcode) || opcode == isa::Opcode::Ld; }

std::string verify(const Mapping& mapping, const Logic& logic, const core::Program& program) {
  return Checker(mapping, logic, program).run();
}

}  // namespace rung::mapping
