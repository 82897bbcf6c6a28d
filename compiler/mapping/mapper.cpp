// SPDX-License-Identifier: Apache-2.0
// From the cover of a network to operations. A kept value (a boundary of the cover) has one
// look-up; what needs it reads it from a device that it was written to, from N0 right behind it, or
// from a temporary bit. Actions of one condition share its look-up as far as they may change places
// with the actions between them.
#include <algorithm>
#include <cassert>
#include <map>

#include "mapping/cover.hpp"
#include "mapping/emit.hpp"
#include "mapping/mapping.hpp"

namespace rung::mapping {
namespace {

using logic::Action;
using logic::Logic;
using logic::Node;
using logic::NodeId;
using logic::NodeKind;

struct Range {
  std::int32_t first = 0;
  std::int32_t end = 0;
};

// Actions that run under one computation of their condition.
struct Segment {
  std::int32_t position = 0;  // it stands before this action in the order of the program
  std::vector<std::int32_t> actions;
};

// A boundary of the cover, and how its value is kept for those that read it later.
struct Kept {
  std::vector<NodeId> readers;      // look-ups that take it
  std::vector<Segment> segments;    // the first computes it, further ones restore it
  BitValue value;                   // where it is kept; None if nobody needs that
  NodeId chained = logic::kNoNode;  // or the one look-up that takes it as N0
  std::size_t unit = 0;             // where its first segment stands
  OpId op = kNoOp;
};

class NetworkMapper {
 public:
  NetworkMapper(const Logic& logic, const Options& options, Mapping& mapping, Range nodes,
                Range actions)
      : logic_(logic), options_(options), mapping_(mapping), nodes_(nodes), actions_(actions) {}

  void map() {
    std::vector<std::pair<NodeId, std::int32_t>> conditions;
    for (std::int32_t a = actions_.first; a < actions_.end; ++a) {
      conditions.emplace_back(logic_.actions[a].condition, a);
    }
    cover_ = cover_network(logic_, nodes_.first, nodes_.end - nodes_.first, conditions);
    find_latest();
    find_readers();
    for (auto& [node, kept] : kept_) split_segments(node, kept);
    for (auto& [node, kept] : kept_) decide_storage(node, kept);
    emit_all();
  }

 private:
  const Node& node(NodeId id) const { return logic_.nodes[id]; }
  bool is_leaf(NodeId id) const { return node(id).kind == NodeKind::Leaf; }
  std::int32_t lifetime(NodeId leaf) const {
    return logic_.overwritten(node(leaf).device, node(leaf).version);
  }
  // The look-up of `reader` takes the leaf from its device, not from where its value was kept.
  bool reads_device(NodeId leaf, NodeId reader) const {
    return leaf == reader || !cover_.is_boundary(leaf) || latest(reader) <= lifetime(leaf);
  }
  // The latest place in the order of the program at which the look-up of `id` may come to stand:
  // that of a boundary right before its first action, any other where those that take it stand.
  std::int32_t latest(NodeId id) const { return latest_[id - nodes_.first]; }
  bool is_inner(NodeId id) const {
    return !is_leaf(id) && cover_.is_chosen(id) && !cover_.is_boundary(id);
  }

  template <typename F>
  void for_signals(NodeId id, F&& f) const {
    const Cut& cut = cover_.cut(id);
    for (int i = 0; i < cut.size; ++i) f(cut.signals[i]);
  }

  void find_latest() {
    latest_.assign(nodes_.end - nodes_.first, 0);
    for (std::int32_t a = actions_.end; a-- > actions_.first;) {
      latest_[logic_.actions[a].condition - nodes_.first] = a;
    }
    for (NodeId id = nodes_.end; id-- > nodes_.first;) {
      std::int32_t& own = latest_[id - nodes_.first];
      own = std::max(own, node(id).epoch);
      if (!cover_.is_chosen(id)) continue;
      for_signals(id, [&](NodeId signal) {
        std::int32_t& below = latest_[signal - nodes_.first];
        if (!cover_.is_boundary(signal)) below = std::max(below, own);
      });
    }
  }

  void find_readers() {
    for (NodeId id = nodes_.first; id < nodes_.end; ++id) {
      if (cover_.is_boundary(id)) kept_[id];
    }
    for (NodeId id = nodes_.first; id < nodes_.end; ++id) {
      if (!cover_.is_chosen(id)) continue;
      for_signals(id, [&](NodeId signal) {
        if (!cover_.is_boundary(signal) || (is_leaf(signal) && reads_device(signal, id))) return;
        kept_[signal].readers.push_back(id);
      });
    }
  }

  // The first action that writes a contact of this node's look-ups: they must stand before it.
  std::int32_t cone_lifetime(NodeId id) const {
    std::int32_t last = logic::kNever;
    for_signals(id, [&](NodeId signal) {
      if (is_leaf(signal)) {
        if (signal == id || reads_device(signal, id)) last = std::min(last, lifetime(signal));
      } else if (is_inner(signal)) {
        last = std::min(last, cone_lifetime(signal));
      }
    });
    return last;
  }

  // --- Which actions share a computation of their condition ---

  static bool reads_word(const Action& action, Device device) {
    return std::any_of(action.operands.begin(), action.operands.end(), [&](const auto& operand) {
      return !operand.source.constant && operand.source.device == device;
    });
  }

  bool condition_reads(NodeId id, Device device) const {
    const Node& n = node(id);
    if (n.kind == NodeKind::Leaf) return n.device == device;
    if (condition_reads(n.left, device)) return true;
    return n.kind != NodeKind::NotLeaf && condition_reads(n.right, device);
  }

  // Action `later` may run before action `earlier` (whose condition may not even be known yet).
  bool may_pass(std::int32_t later, std::int32_t earlier) const {
    const Action& x = logic_.actions[later];
    const Action& j = logic_.actions[earlier];
    const auto targets = logic::written(j);
    for (const Device device : logic::written(x)) {
      if (std::find(targets.begin(), targets.end(), device) != targets.end()) return false;
      if (is_word(device) ? reads_word(j, device) : condition_reads(j.condition, device)) {
        return false;
      }
    }
    return std::none_of(targets.begin(), targets.end(),
                        [&](Device device) { return is_word(device) && reads_word(x, device); });
  }

  bool joins(const Segment& segment, std::int32_t action) const {
    const bool muldiv = is_muldiv(logic_.actions[action].op);
    const auto collides = [&](std::int32_t member) {
      return is_muldiv(logic_.actions[member].op) && (muldiv || !may_pass(action, member));
    };
    const auto is_member = [&](std::int32_t a) {
      return std::find(segment.actions.begin(), segment.actions.end(), a) != segment.actions.end();
    };
    for (std::int32_t a = segment.position; a < action; ++a) {
      if (is_member(a)) {
        // The slot holds one product or quotient at a time, and writes it some steps later.
        if (collides(a)) return false;
      } else if (!may_pass(action, a)) {
        return false;
      }
    }
    return true;
  }

  void split_segments(NodeId id, Kept& kept) {
    std::vector<std::int32_t> own;
    for (std::int32_t a = actions_.first; a < actions_.end; ++a) {
      if (logic_.actions[a].condition == id) own.push_back(a);
    }
    // The look-up stands where the source has it if others read it or its contacts change before
    // its first action, else right before that action.
    const bool early = own.empty() || !kept.readers.empty() || cone_lifetime(id) < own.front();
    kept.segments.push_back({early ? node(id).epoch : own.front(), {}});
    for (const std::int32_t action : own) {
      if (!joins(kept.segments.back(), action)) kept.segments.push_back({action, {}});
      kept.segments.back().actions.push_back(action);
    }
  }

  // --- How a kept value reaches those that need it ---

  // The device that an OUT of the first segment writes, if it still holds the value at every use.
  bool kept_by_coil(const Kept& kept, BitValue& value) const {
    const auto& actions = kept.segments.front().actions;
    for (const std::int32_t action : actions) {
      if (logic_.actions[action].op != Op::Out) continue;
      const Device device = logic_.actions[action].target;
      const std::int32_t end = logic_.overwritten(device, action);
      // An action of the same segment that writes it again does so before any reader.
      if (std::find(actions.begin(), actions.end(), end) != actions.end()) continue;
      const auto fine = [&](std::int32_t epoch) { return epoch <= end; };
      bool ok = std::all_of(kept.readers.begin(), kept.readers.end(),
                            [&](NodeId reader) { return fine(latest(reader)); });
      for (std::size_t i = 1; i < kept.segments.size(); ++i) ok &= fine(kept.segments[i].position);
      if (!ok) continue;
      value.kind = BitValue::Kind::Device;
      value.device = device;
      value.version = action;
      return true;
    }
    return false;
  }

  // The boundary whose look-ups contain `reader`, if they are one chain from `reader` up that takes
  // no other value that was computed after `id`.
  NodeId chain_owner(NodeId reader, NodeId id) const {
    for (NodeId at = reader;;) {
      bool plain = true;
      int inner = 0;
      for_signals(at, [&](NodeId signal) {
        inner += is_inner(signal) ? 1 : 0;
        if (cover_.is_boundary(signal) && !is_leaf(signal) && signal > id) plain = false;
      });
      if (!plain || inner > (at == reader ? 0 : 1)) return logic::kNoNode;
      if (cover_.is_boundary(at)) return at;
      NodeId above = logic::kNoNode;
      int takers = 0;
      for (NodeId n = at + 1; n < nodes_.end; ++n) {
        if (!cover_.is_chosen(n)) continue;
        for_signals(n, [&](NodeId signal) {
          if (signal != at) return;
          above = n;
          ++takers;
        });
      }
      // A look-up that several others take is computed once for each of them.
      if (takers != 1) return logic::kNoNode;
      at = above;
    }
  }

  bool has_muldiv(const Kept& kept) const {
    const auto& actions = kept.segments.front().actions;
    return std::any_of(actions.begin(), actions.end(),
                       [&](std::int32_t a) { return is_muldiv(logic_.actions[a].op); });
  }

  // The reader can follow in the same unit: nothing else of the program stands between the two.
  bool can_chain(NodeId id, const Kept& kept) const {
    if (kept.readers.size() != 1 || kept.segments.size() != 1) return false;
    const NodeId reader = kept.readers.front();
    if (chained_.count(reader) != 0) return false;
    const NodeId owner = chain_owner(reader, id);
    if (owner == logic::kNoNode) return false;
    const Kept& above = kept_.at(owner);
    if (has_muldiv(kept)) return false;
    const auto& own = kept.segments.front().actions;
    for (std::int32_t a = kept.segments.front().position; a < above.segments.front().position;
         ++a) {
      if (std::find(own.begin(), own.end(), a) == own.end()) return false;
    }
    return true;
  }

  void decide_storage(NodeId id, Kept& kept) {
    if (kept.readers.empty() && kept.segments.size() == 1) return;
    if (kept_by_coil(kept, kept.value)) return;
    if (can_chain(id, kept)) {
      kept.chained = kept.readers.front();
      chained_[kept.chained] = id;
      return;
    }
    kept.value = fresh_temporary();
  }

  BitValue fresh_temporary() {
    BitValue value;
    value.kind = BitValue::Kind::Temporary;
    value.temporary = mapping_.temporaries++;
    return value;
  }

  // --- Operations ---

  void emit_all() {
    struct Task {
      std::int32_t position;
      bool restores;
      NodeId node;
      std::size_t segment;
      auto operator<=>(const Task&) const = default;
    };
    std::vector<Task> tasks;
    for (const auto& [id, kept] : kept_) {
      for (std::size_t s = 0; s < kept.segments.size(); ++s) {
        tasks.push_back({kept.segments[s].position, s > 0, id, s});
      }
    }
    std::sort(tasks.begin(), tasks.end());
    for (const Task& task : tasks) {
      if (task.segment == 0) {
        emit_first(task.node);
      } else {
        emit_restored(kept_.at(task.node), task.segment);
      }
    }
  }

  void emit_first(NodeId id) {
    Kept& kept = kept_.at(id);
    Unit unit;
    std::size_t place = mapping_.units.size();
    const NodeId start = chain_start(id);
    if (start != logic::kNoNode) {
      place = kept_.at(start).unit;
      unit = std::move(mapping_.units[place]);
    }
    kept.op = emit_lookup(id, unit);
    finish(kept, unit);
    if (start == logic::kNoNode) {
      place = mapping_.units.size();
      mapping_.units.push_back(std::move(unit));
    } else {
      mapping_.units[place] = std::move(unit);
    }
    kept.unit = place;
  }

  // The kept value that the lowest look-up of this boundary's chain takes as N0.
  NodeId chain_start(NodeId id) const {
    for (NodeId at = id;;) {
      const auto found = chained_.find(at);
      if (found != chained_.end()) return found->second;
      NodeId below = logic::kNoNode;
      for_signals(at, [&](NodeId signal) {
        if (is_inner(signal)) below = signal;
      });
      if (below == logic::kNoNode) return below;
      at = below;
    }
  }

  // The actions of the first segment and the store of the value, the first possible one fused.
  void finish(const Kept& kept, Unit& unit) {
    const auto& actions = kept.segments.front().actions;
    const bool store = kept.value.kind == BitValue::Kind::Temporary;
    std::int32_t fused = -1;
    for (std::size_t i = 0; options_.fuse && i < actions.size() && fused < 0; ++i) {
      const bool first = std::all_of(actions.begin(), actions.begin() + static_cast<long>(i),
                                     [&](std::int32_t a) { return may_pass(actions[i], a); });
      if (first && fuse(kept.op, actions[i])) fused = actions[i];
    }
    bool stored = !store;
    if (store && fused < 0) stored = options_.fuse && fuse_store(kept.op, kept.value.temporary);
    order_inputs(mapping_.ops[kept.op]);
    if (!stored) append_store(unit, kept.op, kept.value.temporary);
    for (const std::int32_t action : actions) {
      if (action == fused) continue;
      append_action(mapping_, unit, logic_, action, kept.op, options_.split_muldiv);
    }
  }

  bool fuse(OpId lookup, std::int32_t action) {
    const Action& source = logic_.actions[action];
    if (!logic::is_bit_action(source.op)) return false;
    MappedOp& op = mapping_.ops[lookup];
    Destination destination;
    destination.kind = Destination::Kind::Device;
    destination.device = source.target;
    destination.version = action;
    if (!can_write(op.inputs, destination)) return false;
    op.destination = destination;
    op.action = action;
    op.opcode = source.op == Op::Out   ? isa::Opcode::Luto
                : source.op == Op::Set ? isa::Opcode::Luts
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
    for_signals(id, [&](NodeId signal) { devices += is_inner(signal) ? 0 : 1; });
    return devices == 3;
  }

  // The look-up of `id` and, before it, those that only it takes: one through N0 in the same unit,
  // the others in units of their own that leave their result in a temporary.
  OpId emit_lookup(NodeId id, Unit& unit) {
    NodeId main = logic::kNoNode;
    for_signals(id, [&](NodeId signal) {
      if (!is_inner(signal)) return;
      if (main == logic::kNoNode || reads_three_devices(signal) || !reads_three_devices(main)) {
        main = signal;
      }
    });
    std::map<NodeId, BitValue> inner;
    for_signals(id, [&](NodeId signal) {
      if (is_inner(signal) && signal != main) inner[signal] = emit_side(signal);
    });
    if (main != logic::kNoNode) {
      const OpId below = emit_lookup(main, unit);
      order_inputs(mapping_.ops[below]);
    }
    MappedOp op;
    op.opcode = isa::Opcode::Lut;
    op.function = cover_.cut(id).function;
    op.instruction = source_of(id);
    const Cut& cut = cover_.cut(id);
    const auto chained = chained_.find(id);
    for (int i = 0; i < cut.size; ++i) {
      const NodeId signal = cut.signals[i];
      if (signal == main || (chained != chained_.end() && chained->second == signal)) {
        op.inputs[i].kind = BitValue::Kind::N0;
      } else if (is_leaf(signal) && reads_device(signal, id)) {
        op.inputs[i] = {BitValue::Kind::Device, node(signal).device, node(signal).version, -1};
      } else if (is_inner(signal)) {
        op.inputs[i] = inner.at(signal);
      } else {
        op.inputs[i] = kept_.at(signal).value;
      }
    }
    return append(mapping_, unit, op);
  }

  BitValue emit_side(NodeId id) {
    Unit unit;
    const OpId op = emit_lookup(id, unit);
    const BitValue value = fresh_temporary();
    const bool stored = options_.fuse && fuse_store(op, value.temporary);
    order_inputs(mapping_.ops[op]);
    if (!stored) append_store(unit, op, value.temporary);
    mapping_.units.push_back(std::move(unit));
    return value;
  }

  // The source instruction of the contact that completes this node.
  std::size_t source_of(NodeId id) const { return node(id).instruction; }

  const Logic& logic_;
  const Options& options_;
  Mapping& mapping_;
  Range nodes_;
  Range actions_;
  Cover cover_;
  std::vector<std::int32_t> latest_;
  std::map<NodeId, Kept> kept_;
  std::map<NodeId, NodeId> chained_;  // look-up -> the kept value it takes as N0
};

}  // namespace

Mapping map_logic(const Logic& logic, const Program& program, const Options& options) {
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
