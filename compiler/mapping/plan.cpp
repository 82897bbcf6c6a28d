// SPDX-License-Identifier: Apache-2.0
#include "mapping/plan.hpp"

#include <algorithm>

namespace rung::mapping {

using logic::Action;
using logic::Node;
using logic::NodeId;
using logic::NodeKind;

namespace {

bool action_reads(const Action& action, Device device) {
  return std::any_of(action.operands.begin(), action.operands.end(),
                     [&](const auto& operand) {
                       return !operand.source.constant && operand.source.device == device;
                     }) ||
         std::any_of(action.reads.begin(), action.reads.end(),
                     [&](const logic::Read& read) { return read.device == device; });
}

}  // namespace

NetworkPlan::NetworkPlan(const logic::Logic& logic, Range nodes, Range actions,
                         std::int32_t& temporaries)
    : logic_(logic), nodes_(nodes), actions_(actions) {
  std::vector<std::pair<NodeId, std::int32_t>> conditions;
  for (std::int32_t a = actions.first; a < actions.end; ++a) {
    if (logic.actions[a].condition == logic::kNoNode) continue;
    conditions.emplace_back(logic.actions[a].condition, a);
  }
  cover_ = cover_network(logic, nodes.first, nodes.end - nodes.first, conditions);
  find_latest();
  find_readers();
  for (auto& [node, kept] : kept_) split_segments(node, kept);
  for (auto& [node, kept] : kept_) decide_storage(node, kept, temporaries);
}

std::int32_t NetworkPlan::lifetime(NodeId leaf) const {
  return logic_.overwritten(node(leaf).device, node(leaf).version);
}
// The look-up of `reader` takes the leaf from its device, not from where its value was kept.
bool NetworkPlan::reads_device(NodeId leaf, NodeId reader) const {
  return leaf == reader || !cover_.is_boundary(leaf) || latest(reader) <= lifetime(leaf);
}
bool NetworkPlan::is_inner(NodeId id) const {
  return !is_leaf(id) && cover_.is_chosen(id) && !cover_.is_boundary(id);
}

void NetworkPlan::find_latest() {
  latest_.assign(nodes_.end - nodes_.first, 0);
  for (std::int32_t a = actions_.end; a-- > actions_.first;) {
    const NodeId condition = logic_.actions[a].condition;
    if (condition != logic::kNoNode) latest_[condition - nodes_.first] = a;
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

void NetworkPlan::find_readers() {
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
std::int32_t NetworkPlan::cone_lifetime(NodeId id) const {
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

bool NetworkPlan::condition_reads(NodeId id, Device device) const {
  const Node& n = node(id);
  if (n.kind == NodeKind::Leaf) return n.device == device;
  return condition_reads(n.left, device) ||
         (n.right != logic::kNoNode && condition_reads(n.right, device));
}

// Action `later` may run before action `earlier` (whose condition may not even be known yet).
bool NetworkPlan::may_pass(std::int32_t later, std::int32_t earlier) const {
  const Action& x = logic_.actions[later];
  const Action& j = logic_.actions[earlier];
  for (const Device device : x.targets) {
    if (std::find(j.targets.begin(), j.targets.end(), device) != j.targets.end()) return false;
    if (action_reads(j, device)) return false;
    if (j.condition != logic::kNoNode && condition_reads(j.condition, device)) return false;
  }
  return std::none_of(j.targets.begin(), j.targets.end(),
                      [&](Device device) { return action_reads(x, device); });
}

bool NetworkPlan::joins(const Segment& segment, std::int32_t action) const {
  const bool muldiv = core::is_muldiv(logic_.actions[action].op);
  const auto collides = [&](std::int32_t member) {
    return core::is_muldiv(logic_.actions[member].op) && (muldiv || !may_pass(action, member));
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

void NetworkPlan::split_segments(NodeId id, Kept& kept) {
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
bool NetworkPlan::kept_by_coil(const Kept& kept, BitValue& value) const {
  const auto& actions = kept.segments.front().actions;
  for (const std::int32_t action : actions) {
    if (logic_.actions[action].op != core::Op::Out) continue;
    const Device device = logic_.actions[action].targets[0];
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
NodeId NetworkPlan::chain_owner(NodeId reader, NodeId id) const {
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

bool NetworkPlan::has_muldiv(const Kept& kept) const {
  const auto& actions = kept.segments.front().actions;
  return std::any_of(actions.begin(), actions.end(),
                     [&](std::int32_t a) { return core::is_muldiv(logic_.actions[a].op); });
}

// The reader can follow in the same unit: nothing else of the program stands between the two.
bool NetworkPlan::can_chain(NodeId id, const Kept& kept) const {
  if (kept.readers.size() != 1 || kept.segments.size() != 1) return false;
  const NodeId reader = kept.readers.front();
  if (chained_.count(reader) != 0) return false;
  const NodeId owner = chain_owner(reader, id);
  if (owner == logic::kNoNode) return false;
  const Kept& above = kept_.at(owner);
  if (has_muldiv(kept)) return false;
  const auto& own = kept.segments.front().actions;
  for (std::int32_t a = kept.segments.front().position; a < above.segments.front().position; ++a) {
    if (std::find(own.begin(), own.end(), a) == own.end()) return false;
  }
  return true;
}

void NetworkPlan::decide_storage(NodeId id, Kept& kept, std::int32_t& temporaries) {
  if (kept.readers.empty() && kept.segments.size() == 1) return;
  if (kept_by_coil(kept, kept.value)) return;
  if (can_chain(id, kept)) {
    chained_[kept.readers.front()] = id;
    return;
  }
  kept.value.kind = BitValue::Kind::Temporary;
  kept.value.temporary = temporaries++;
}

}  // namespace rung::mapping
