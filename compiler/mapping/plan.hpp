// SPDX-License-Identifier: Apache-2.0
// What becomes of one network before any operation is made: which look-ups cover it, which of their
// values are kept and where, and which actions share a computation of their condition.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "logic/logic.hpp"
#include "mapping/cover.hpp"
#include "mapping/mapping.hpp"

namespace rung::mapping {

// Numbers from `first` to before `end`.
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
  std::vector<logic::NodeId> readers;  // look-ups that take it
  std::vector<Segment> segments;       // the first computes it, further ones restore it
  BitValue value;  // the coil or temporary that holds it; None if nobody needs it, or it is chained
};

class NetworkPlan {
 public:
  // Plans the network that has these nodes and actions of `logic`; at least one action. Temporaries
  // are numbered from `temporaries` on.
  NetworkPlan(const logic::Logic& logic, Range nodes, Range actions, std::int32_t& temporaries);

  // The boundaries of the cover.
  const std::map<logic::NodeId, Kept>& kept() const { return kept_; }
  // Look-ups that take a kept value as N0, right behind it in the same unit -> that value.
  const std::map<logic::NodeId, logic::NodeId>& chained() const { return chained_; }
  const Cut& cut(logic::NodeId id) const { return cover_.cut(id); }
  // A look-up whose value only the look-ups above it take.
  bool is_inner(logic::NodeId id) const;
  bool is_leaf(logic::NodeId id) const { return node(id).kind == logic::NodeKind::Leaf; }
  // The look-up of `reader` takes the leaf from its device, not from where its value was kept.
  bool reads_device(logic::NodeId leaf, logic::NodeId reader) const;
  // Action `later` may run before action `earlier`, which stands above it.
  bool may_pass(std::int32_t later, std::int32_t earlier) const;

  // Calls f with each signal of the look-up of `id`.
  template <typename F>
  void for_signals(logic::NodeId id, F&& f) const {
    const Cut& cut = cover_.cut(id);
    for (int i = 0; i < cut.size; ++i) f(cut.signals[i]);
  }

 private:
  const logic::Node& node(logic::NodeId id) const { return logic_.nodes[id]; }
  std::int32_t lifetime(logic::NodeId leaf) const;
  // The latest place in the order of the program at which the look-up of `id` may come to stand:
  // that of a boundary right before its first action, any other where those that take it stand.
  std::int32_t latest(logic::NodeId id) const { return latest_[id - nodes_.first]; }
  std::int32_t cone_lifetime(logic::NodeId id) const;
  bool condition_reads(logic::NodeId id, Device device) const;
  bool joins(const Segment& segment, std::int32_t action) const;
  bool kept_by_coil(const Kept& kept, BitValue& value) const;
  logic::NodeId chain_owner(logic::NodeId reader, logic::NodeId id) const;
  bool has_muldiv(const Kept& kept) const;
  bool can_chain(logic::NodeId id, const Kept& kept) const;

  void find_latest();
  void find_readers();
  void split_segments(logic::NodeId id, Kept& kept);
  void decide_storage(logic::NodeId id, Kept& kept, std::int32_t& temporaries);

  const logic::Logic& logic_;
  Range nodes_;
  Range actions_;
  Cover cover_;
  std::vector<std::int32_t> latest_;
  std::map<logic::NodeId, Kept> kept_;
  std::map<logic::NodeId, logic::NodeId> chained_;
};

}  // namespace rung::mapping
