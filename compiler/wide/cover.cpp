// SPDX-License-Identifier: Apache-2.0
#include "wide/cover.hpp"

#include <algorithm>
#include <cassert>
#include <compare>

namespace rung::wide {
namespace {

using values::inverted;
using values::Node;
using values::node_of;
using values::NodeId;
using values::NodeKind;
using values::Values;

// A node far up a chain has many cuts; those kept are the cheapest.
constexpr std::size_t kMaxCuts = 12;
constexpr int kRounds = 3;

std::uint16_t full(int size) { return static_cast<std::uint16_t>((1U << (1U << size)) - 1); }

// The function of `cut` as one of the leaves of `wider`, which holds all of the cut's.
std::uint16_t over(const Cut& cut, const Cut& wider) {
  std::array<int, kMaxArity> place{};
  for (int i = 0; i < cut.size; ++i) {
    const auto* at = std::find(wider.leaves.begin(), wider.leaves.end(), cut.leaves[i]);
    place[i] = static_cast<int>(at - wider.leaves.begin());
  }
  unsigned table = 0;
  for (int address = 0; address < 1 << wider.size; ++address) {
    int own = 0;
    for (int i = 0; i < cut.size; ++i) {
      own |= (address >> (wider.size - 1 - place[i]) & 1) << (cut.size - 1 - i);
    }
    table |= (cut.table >> own & 1U) << address;
  }
  return static_cast<std::uint16_t>(table);
}

Cut trivial(NodeId node) {
  Cut cut;
  cut.leaves[0] = node;
  cut.size = 1;
  cut.table = 0b10;
  return cut;
}

// Leaves out inputs that do not matter.
Cut reduced(const Cut& cut) {
  Cut out;
  for (int i = 0; i < cut.size; ++i) {
    const int bit = 1 << (cut.size - 1 - i);
    bool matters = false;
    for (int address = 0; address < 1 << cut.size; ++address) {
      if ((cut.table >> address & 1) != (cut.table >> (address ^ bit) & 1)) matters = true;
    }
    if (matters) out.leaves[out.size++] = cut.leaves[i];
  }
  if (out.size == cut.size) return cut;
  unsigned table = 0;
  for (int address = 0; address < 1 << out.size; ++address) {
    int whole = 0;
    for (int i = 0; i < out.size; ++i) {
      const auto* at = std::find(cut.leaves.begin(), cut.leaves.end(), out.leaves[i]);
      const auto place = static_cast<int>(at - cut.leaves.begin());
      whole |= (address >> (out.size - 1 - i) & 1) << (cut.size - 1 - place);
    }
    table |= (cut.table >> whole & 1U) << address;
  }
  out.table = static_cast<std::uint16_t>(table);
  return out;
}

class Coverer {
 public:
  Coverer(const Values& values, int arity) : values_(values), arity_(arity) {
    cuts_.resize(values.nodes.size());
    references_.assign(values.nodes.size(), 0);
    flow_.assign(values.nodes.size(), 0);
    depth_.assign(values.nodes.size(), 0);
    stop_.assign(values.nodes.size(), false);
    open_.assign(values.nodes.size(), false);
    out_.cuts.resize(values.nodes.size());
    out_.captures.assign(values.nodes.size(), -1);
  }

  Cover run(const std::vector<NodeId>& roots, const std::vector<NodeId>& gates) {
    mark_live(roots, gates);
    mark_captures();
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t i = 0; i < values_.nodes.size(); ++i) {
        if (live_[i]) enumerate(static_cast<NodeId>(i));
      }
      choose(roots, gates);
    }
    return std::move(out_);
  }

 private:
  struct Cost {
    float flow = 0;
    int depth = 0;
    int size = 0;
    auto operator<=>(const Cost&) const = default;
  };

  const Node& node(NodeId id) const { return values_.nodes[id]; }

  void mark_live(const std::vector<NodeId>& roots, const std::vector<NodeId>& gates) {
    live_.assign(values_.nodes.size(), false);
    for (const NodeId id : roots) live_[id] = true, ++references_[id];
    for (const NodeId id : gates) live_[id] = true, ++references_[id];
    parents_.assign(values_.nodes.size(), {});
    for (std::size_t i = values_.nodes.size(); i-- > 0;) {
      if (!live_[i] || values_.nodes[i].kind != NodeKind::And) continue;
      for (const values::Literal side : {values_.nodes[i].left, values_.nodes[i].right}) {
        live_[node_of(side)] = true;
        ++references_[node_of(side)];
        parents_[node_of(side)].push_back(static_cast<NodeId>(i));
      }
    }
  }

  // The flag of a test is one bit that the next test of its unit replaces, so one look-up beside
  // the unit takes it: where it is chosen against the old value if it is, else at the next gate.
  void mark_captures() {
    for (std::size_t i = 0; i < values_.nodes.size(); ++i) {
      if (!live_[i] || values_.nodes[i].kind != NodeKind::Test) continue;
      NodeId at = static_cast<NodeId>(i);
      // A gate and what it is ORed with: three inputs at most, whatever they are.
      for (int up = 0; up < 2; ++up) {
        if (parents_[at].size() != 1 || references_[at] != 1) break;
        const NodeId parent = parents_[at][0];
        if (stop_[parent] || reads_flag(parent, at)) break;
        open_[at] = true;
        at = parent;
      }
      stop_[at] = true;
      out_.captures[at] = values_.nodes[i].operation;
    }
  }

  // The other side of `parent` is a test, or has one in front of anything that stops.
  bool reads_flag(NodeId parent, NodeId side) const {
    const Node& n = node(parent);
    const NodeId other = node_of(n.left) == side ? node_of(n.right) : node_of(n.left);
    return has_open_test(other, 0);
  }
  bool has_open_test(NodeId id, int deep) const {
    if (stop_[id]) return false;
    if (node(id).kind == NodeKind::Test) return true;
    if (node(id).kind != NodeKind::And) return false;
    // Deeper than a cut can reach nothing matters, but to look on is cheap and always right.
    if (deep > 6) return true;
    return has_open_test(node_of(node(id).left), deep + 1) ||
           has_open_test(node_of(node(id).right), deep + 1);
  }

  bool is_leaf(NodeId id) const { return node(id).kind != NodeKind::And; }

  Cost cost_of(const Cut& cut) const {
    Cost cost;
    cost.size = cut.size;
    for (int i = 0; i < cut.size; ++i) {
      const NodeId leaf = cut.leaves[i];
      if (is_leaf(leaf) && !stop_[leaf]) continue;
      cost.flow += flow_[leaf];
      cost.depth = std::max(cost.depth, depth_[leaf]);
    }
    return cost;
  }

  void enumerate(NodeId id) {
    std::vector<Cut> found;
    if (is_leaf(id)) {
      found = {trivial(id)};
      if (node(id).kind == NodeKind::False) found[0] = Cut{};
    } else {
      const Node& n = node(id);
      for (const Cut& left : cuts_[node_of(n.left)]) {
        for (const Cut& right : cuts_[node_of(n.right)]) {
          Cut merged;
          if (!merge(n, left, right, merged)) continue;
          if (std::find(found.begin(), found.end(), merged) == found.end()) found.push_back(merged);
        }
      }
    }
    std::vector<std::pair<Cost, Cut>> ranked;
    for (const Cut& cut : found) ranked.emplace_back(cost_of(cut), cut);
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    if (ranked.size() > kMaxCuts) ranked.resize(kMaxCuts);
    assert(!ranked.empty());
    out_.cuts[id] = ranked.front().second;
    const bool free = is_leaf(id) && !stop_[id];
    depth_[id] = free ? 0 : ranked.front().first.depth + 1;
    flow_[id] =
        free ? 0
             : (ranked.front().first.flow + 1) / static_cast<float>(std::max(1, references_[id]));
    cuts_[id].clear();
    if (stop_[id] || !(is_leaf(id) || open_[id])) cuts_[id].push_back(trivial(id));
    if (stop_[id]) return;
    for (const auto& [cost, cut] : ranked) cuts_[id].push_back(cut);
  }

  bool merge(const Node& n, const Cut& left, const Cut& right, Cut& out) const {
    std::array<NodeId, 2 * kMaxArity> all{};
    const auto* end =
        std::set_union(left.leaves.begin(), left.leaves.begin() + left.size, right.leaves.begin(),
                       right.leaves.begin() + right.size, all.begin());
    const auto size = static_cast<int>(end - all.begin());
    if (size > arity_) return false;
    Cut merged;
    merged.size = size;
    std::copy(all.begin(), all.begin() + size, merged.leaves.begin());
    const unsigned whole = full(size);
    const unsigned a = over(left, merged) ^ (inverted(n.left) ? whole : 0);
    const unsigned b = over(right, merged) ^ (inverted(n.right) ? whole : 0);
    merged.table = static_cast<std::uint16_t>(a & b);
    out = reduced(merged);
    return true;
  }

  // What the cuts chosen need, and how often: the next round's weights.
  void choose(const std::vector<NodeId>& roots, const std::vector<NodeId>& gates) {
    out_.look_up.assign(values_.nodes.size(), false);
    std::vector<int> used(values_.nodes.size(), 0);
    const auto use_leaves = [&](NodeId id) {
      const Cut& cut = out_.cuts[id];
      for (int k = 0; k < cut.size; ++k) {
        const NodeId leaf = cut.leaves[k];
        if (leaf == id && is_leaf(id)) continue;
        ++used[leaf];
        if (!is_leaf(leaf) || stop_[leaf]) out_.look_up[leaf] = true;
      }
    };
    for (const NodeId id : roots) {
      ++used[id];
      if (!is_leaf(id) || stop_[id]) out_.look_up[id] = true;
    }
    for (const NodeId id : gates) {
      ++used[id];
      // What takes a flag is computed once; its gates read it.
      if (stop_[id]) {
        out_.look_up[id] = true;
      } else {
        use_leaves(id);
      }
    }
    for (std::size_t i = values_.nodes.size(); i-- > 0;) {
      if (out_.look_up[i]) use_leaves(static_cast<NodeId>(i));
    }
    for (std::size_t i = 0; i < used.size(); ++i) references_[i] = std::max(1, used[i]);
  }

  const Values& values_;
  int arity_;
  std::vector<std::vector<Cut>> cuts_;
  std::vector<std::vector<NodeId>> parents_;
  std::vector<bool> live_;
  std::vector<bool> stop_;  // has a look-up of its own, and others read that
  std::vector<bool> open_;  // has none: it is on the way from a test to where its flag is taken
  std::vector<int> references_, depth_;
  std::vector<float> flow_;
  Cover out_;
};

}  // namespace

Cover cover(const Values& values, const std::vector<NodeId>& roots,
            const std::vector<NodeId>& gates, int arity) {
  return Coverer(values, arity).run(roots, gates);
}

}  // namespace rung::wide
