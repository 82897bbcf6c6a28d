// SPDX-License-Identifier: Apache-2.0
// From the plan of a network to operations. What needs a kept value reads it from a device that it
// was written to, from N0 right behind it, or from a temporary bit.
#include <algorithm>
#include <map>

#include "mapping/emit.hpp"
#include "mapping/mapping.hpp"
#include "mapping/plan.hpp"

namespace rung::mapping {
namespace {

using logic::Action;
using logic::Logic;
using logic::NodeId;

class NetworkMapper {
 public:
  NetworkMapper(const Logic& logic, const Options& options, Mapping& mapping, Range nodes,
                Range actions)
      : logic_(logic),
        options_(options),
        mapping_(mapping),
        actions_(actions),
        plan_(logic, nodes, actions, mapping.temporaries) {}

  // Adds the network's units to the mapping.
  void map() {
    struct Task {
      std::int32_t position;
      bool restores;
      NodeId node;
      std::size_t segment;
      auto operator<=>(const Task&) const = default;
    };
    std::vector<Task> tasks;
    for (std::int32_t a = actions_.first; a < actions_.end; ++a) {
      // What always runs is a unit of its own, after whatever must be looked up before it.
      if (logic_.actions[a].condition == logic::kNoNode)
        tasks.push_back({a, true, logic::kNoNode, 0});
    }
    for (const auto& [id, kept] : plan_.kept()) {
      for (std::size_t s = 0; s < kept.segments.size(); ++s) {
        tasks.push_back({kept.segments[s].position, s > 0, id, s});
      }
    }
    std::sort(tasks.begin(), tasks.end());
    for (const Task& task : tasks) {
      if (task.node == logic::kNoNode) {
        Unit unit;
        append_action(mapping_, unit, logic_, task.position, kNoOp, options_.split_muldiv);
        mapping_.units.push_back(std::move(unit));
      } else if (task.segment == 0) {
        emit_first(task.node);
      } else {
        emit_restored(plan_.kept().at(task.node), task.segment);
      }
    }
  }

 private:
  void emit_first(NodeId id) {
    const Kept& kept = plan_.kept().at(id);
    Unit unit;
    std::size_t place = mapping_.units.size();
    const NodeId start = chain_start(id);
    if (start != logic::kNoNode) {
      place = unit_of_.at(start);
      unit = std::move(mapping_.units[place]);
    }
    const OpId lookup = emit_lookup(id, unit);
    finish(kept, lookup, unit);
    if (start == logic::kNoNode) {
      place = mapping_.units.size();
      mapping_.units.push_back(std::move(unit));
    } else {
      mapping_.units[place] = std::move(unit);
    }
    unit_of_[id] = place;
  }

  // The kept value that the lowest look-up of this boundary's chain takes as N0.
  NodeId chain_start(NodeId id) const {
    for (NodeId at = id;;) {
      const auto found = plan_.chained().find(at);
      if (found != plan_.chained().end()) return found->second;
      NodeId below = logic::kNoNode;
      plan_.for_signals(at, [&](NodeId signal) {
        if (plan_.is_inner(signal)) below = signal;
      });
      if (below == logic::kNoNode) return below;
      at = below;
    }
  }

  // The actions of the first segment and the store of the value, the first possible one fused.
  void finish(const Kept& kept, OpId lookup, Unit& unit) {
    const auto& actions = kept.segments.front().actions;
    const bool store = kept.value.kind == BitValue::Kind::Temporary;
    std::int32_t fused = -1;
    for (std::size_t i = 0; options_.fuse && i < actions.size() && fused < 0; ++i) {
      const bool first = std::all_of(actions.begin(), actions.begin() + static_cast<long>(i),
                                     [&](std::int32_t a) { return plan_.may_pass(actions[i], a); });
      if (first && fuse(lookup, actions[i])) fused = actions[i];
    }
    bool stored = !store;
    if (store && fused < 0) stored = options_.fuse && fuse_store(lookup, kept.value.temporary);
    order_inputs(mapping_.ops[lookup]);
    if (!stored) append_store(unit, lookup, kept.value.temporary);
    for (const std::int32_t action : actions) {
      if (action == fused) continue;
      append_action(mapping_, unit, logic_, action, lookup, options_.split_muldiv);
    }
  }

  bool fuse(OpId lookup, std::int32_t action) {
    const Action& source = logic_.actions[action];
    if (!core::is_coil(source.op)) return false;
    MappedOp& op = mapping_.ops[lookup];
    Destination destination;
    destination.kind = Destination::Kind::Device;
    destination.device = source.targets[0];
    destination.version = action;
    if (!can_write(op.inputs, destination)) return false;
    op.destination = destination;
    op.action = action;
    op.quiet = source.quiet;
    op.instruction = source.instruction;  // it is known by its coil
    op.opcode = source.op == core::Op::Out   ? isa::Opcode::Luto
                : source.op == core::Op::Set ? isa::Opcode::Luts
                                             : isa::Opcode::Lutr;
    return true;
  }

  bool fuse_store(OpId lookup, std::int32_t temporary) {
    MappedOp& op = mapping_.ops[lookup];
    Destination destination;
    destination.kind = Destination::Kind::Temporary;
    destination.temporary = temporary;
    if (!can_write(op.inputs, destination)) return false;
    op.destination = destination;
    op.opcode = isa::Opcode::Luto;
    return true;
  }

  void append_store(Unit& unit, OpId lookup, std::int32_t temporary) {
    MappedOp op;
    op.opcode = isa::Opcode::Out;
    op.destination.kind = Destination::Kind::Temporary;
    op.destination.temporary = temporary;
    op.condition = lookup;
    op.instruction = mapping_.ops[lookup].instruction;
    append(mapping_, unit, op);
  }

  void emit_restored(const Kept& kept, std::size_t segment) {
    Unit unit;
    MappedOp load;
    load.opcode = isa::Opcode::Ld;
    load.inputs[0] = kept.value;
    const auto& actions = kept.segments[segment].actions;
    load.instruction = logic_.actions[actions.front()].instruction;
    const OpId op = append(mapping_, unit, load);
    for (const std::int32_t action : actions) {
      append_action(mapping_, unit, logic_, action, op, options_.split_muldiv);
    }
    mapping_.units.push_back(std::move(unit));
  }

  bool reads_three_devices(NodeId id) const {
    int devices = 0;
    plan_.for_signals(id, [&](NodeId signal) { devices += plan_.is_inner(signal) ? 0 : 1; });
    return devices == 3;
  }

  // The look-up of `id` and, before it, those that only it takes: one through N0 in the same unit,
  // the others in units of their own that leave their result in a temporary.
  OpId emit_lookup(NodeId id, Unit& unit) {
    NodeId main = logic::kNoNode;
    plan_.for_signals(id, [&](NodeId signal) {
      if (!plan_.is_inner(signal)) return;
      if (main == logic::kNoNode || reads_three_devices(signal) || !reads_three_devices(main)) {
        main = signal;
      }
    });
    std::map<NodeId, BitValue> inner;
    plan_.for_signals(id, [&](NodeId signal) {
      if (plan_.is_inner(signal) && signal != main) inner[signal] = emit_side(signal);
    });
    if (main != logic::kNoNode) {
      const OpId below = emit_lookup(main, unit);
      order_inputs(mapping_.ops[below]);
    }
    MappedOp op;
    op.opcode = isa::Opcode::Lut;
    op.function = plan_.cut(id).function;
    op.instruction = source_of(id);
    const Cut& cut = plan_.cut(id);
    const auto chained = plan_.chained().find(id);
    for (int i = 0; i < cut.size; ++i) {
      const NodeId signal = cut.signals[i];
      if (signal == main || (chained != plan_.chained().end() && chained->second == signal)) {
        op.inputs[i].kind = BitValue::Kind::N0;
      } else if (plan_.is_leaf(signal) && plan_.reads_device(signal, id)) {
        op.inputs[i] = {BitValue::Kind::Device, logic_.nodes[signal].device,
                        logic_.nodes[signal].version, -1};
      } else if (plan_.is_inner(signal)) {
        op.inputs[i] = inner.at(signal);
      } else {
        op.inputs[i] = plan_.kept().at(signal).value;
      }
    }
    return append(mapping_, unit, op);
  }

  BitValue temporary() {
    BitValue value;
    value.kind = BitValue::Kind::Temporary;
    value.temporary = mapping_.temporaries++;
    return value;
  }

  BitValue emit_side(NodeId id) {
    Unit unit;
    const OpId op = emit_lookup(id, unit);
    const BitValue value = temporary();
    const bool stored = options_.fuse && fuse_store(op, value.temporary);
    order_inputs(mapping_.ops[op]);
    if (!stored) append_store(unit, op, value.temporary);
    mapping_.units.push_back(std::move(unit));
    return value;
  }

  // The source instruction of the contact that completes this node.
  std::size_t source_of(NodeId id) const { return logic_.nodes[id].instruction; }

  const Logic& logic_;
  const Options& options_;
  Mapping& mapping_;
  Range actions_;
  NetworkPlan plan_;
  std::map<NodeId, std::size_t> unit_of_;  // kept values that have been computed
};

}  // namespace

Mapping map_logic(const Logic& logic, const core::Program& program, const Options& options) {
  Mapping mapping;
  Range nodes;
  Range actions;
  const auto networks = static_cast<std::int32_t>(program.networks.size());
  const auto node_count = static_cast<std::int32_t>(logic.nodes.size());
  const auto action_count = static_cast<std::int32_t>(logic.actions.size());
  for (std::int32_t network = 0; network < networks; ++network) {
    nodes.first = nodes.end;
    actions.first = actions.end;
    while (nodes.end < node_count && logic.nodes[nodes.end].network == network) ++nodes.end;
    while (actions.end < action_count && logic.actions[actions.end].network == network) {
      ++actions.end;
    }
    if (actions.first != actions.end) NetworkMapper(logic, options, mapping, nodes, actions).map();
  }
  return mapping;
}

}  // namespace rung::mapping
