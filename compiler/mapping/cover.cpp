// SPDX-License-Identifier: Apache-2.0
#include "mapping/cover.hpp"

#include <algorithm>
#include <cassert>
#include <compare>
#include <limits>

namespace rung::mapping {
namespace {

using logic::kNoNode;
using logic::Node;
using logic::NodeId;
using logic::NodeKind;

// A node far up a chain has many cuts; those kept are the cheapest.
constexpr std::size_t kMaxCuts = 40;

struct Cost {
  int lookups = 0;
  int awkward = 0;  // look-ups that will need a step of their own to store their result
  int depth = 0;
  auto operator<=>(const Cost&) const = default;
};

constexpr std::uint8_t kFirstSignal = 0b11110000;

Cut signal_cut(NodeId signal, bool inverted) {
  Cut cut;
  cut.signals[0] = signal;
  cut.size = 1;
  cut.function = inverted ? static_cast<std::uint8_t>(~kFirstSignal) : kFirstSignal;
  return cut;
}

// The function of `cut` as one of the signals of `wider`, which holds all of the cut's.
std::uint8_t function_over(const Cut& cut, const Cut& wider) {
  std::uint8_t function = 0;
  for (int address = 0; address < 8; ++address) {
    int own = 0;
    for (int i = 0; i < cut.size; ++i) {
      const auto at = std::find(wider.signals.begin(), wider.signals.end(), cut.signals[i]);
      const auto place = static_cast<int>(at - wider.signals.begin());
      own |= (address >> (2 - place) & 1) << (2 - i);
    }
    function = static_cast<std::uint8_t>(function | (cut.function >> own & 1) << address);
  }
  return function;
}

bool depends(std::uint8_t function, int signal) {
  const int bit = 1 << (2 - signal);
  for (int address = 0; address < 8; ++address) {
    if ((function >> address & 1) != (function >> (address ^ bit) & 1)) return true;
  }
  return false;
}

// Leaves out signals that do not matter: X0 and (X0 or X1) is X0.
Cut reduced(const Cut& cut) {
  Cut out;
  for (int i = 0; i < cut.size; ++i) {
    if (depends(cut.function, i)) out.signals[out.size++] = cut.signals[i];
  }
  for (int address = 0; address < 8; ++address) {
    int full = 0;
    for (int i = 0; i < out.size; ++i) {
      const auto at = std::find(cut.signals.begin(), cut.signals.end(), out.signals[i]);
      const auto place = static_cast<int>(at - cut.signals.begin());
      full |= (address >> (2 - i) & 1) << (2 - place);
    }
    out.function = static_cast<std::uint8_t>(out.function | (cut.function >> full & 1) << address);
  }
  return out;
}

// The cut of an And or Or of two cuts; false if it has more than three signals.
bool merge(NodeKind kind, const Cut& left, const Cut& right, Cut& out) {
  std::array<NodeId, 6> all{};
  const auto end =
      std::set_union(left.signals.begin(), left.signals.begin() + left.size, right.signals.begin(),
                     right.signals.begin() + right.size, all.begin());
  if (end - all.begin() > 3) return false;
  Cut merged;
  merged.size = static_cast<int>(end - all.begin());
  std::copy(all.begin(), end, merged.signals.begin());
  const std::uint8_t a = function_over(left, merged);
  const std::uint8_t b = function_over(right, merged);
  merged.function = kind == NodeKind::And ? a & b : a | b;
  out = reduced(merged);
  return true;
}

class Coverer {
 public:
  Coverer(const logic::Logic& logic, NodeId first, std::size_t count)
      : logic_(logic),
        first_(first),
        count_(count),
        cuts_(count),
        best_(count),
        cost_(count),
        last_(count) {
    cover_.first = first;
    cover_.boundary.assign(count, false);
  }

  Cover run(const std::vector<std::pair<NodeId, std::int32_t>>& conditions) {
    std::vector<bool> fixed(count_, false);
    for (const auto& [node, epoch] : conditions) fixed[node - first_] = true;
    fix_stale(fixed);
    for (std::size_t i = 0; i < count_; ++i) {
      cover_.boundary[i] = fixed[i] || (node(i).uses > 1 && is_gate(node(i)));
    }
    int best = evaluate();
    assert(best != kInfeasible);
    // A shared node may be cheaper inside each of its readers than on its own.
    for (std::size_t i = 0; i < count_; ++i) {
      if (!cover_.boundary[i] || fixed[i]) continue;
      cover_.boundary[i] = false;
      const int without = evaluate();
      if (without <= best) {
        best = without;
      } else {
        cover_.boundary[i] = true;
      }
    }
    cover_.lookups = evaluate();
    choose();
    return std::move(cover_);
  }

 private:
  static constexpr int kInfeasible = std::numeric_limits<int>::max();

  static bool is_gate(const Node& node) {
    return node.kind == NodeKind::And || node.kind == NodeKind::Or || node.kind == NodeKind::Not;
  }
  const Node& node(std::size_t i) const { return logic_.nodes[first_ + i]; }
  bool boundary(NodeId id) const { return cover_.boundary[id - first_]; }

  // The last epoch at which node i can still be computed from what it reads: the first write to one
  // of its leaves ends it. A boundary's value is kept, so it never ends for those that read it.
  std::int32_t last_epoch(std::size_t i, const std::vector<bool>& kept) const {
    const Node& n = node(i);
    const auto of = [&](NodeId id) {
      return kept[id - first_] ? logic::kNever : last_[id - first_];
    };
    switch (n.kind) {
      case NodeKind::Leaf:
        return logic_.overwritten(n.device, n.version);
      case NodeKind::NotLeaf:
      case NodeKind::Not:
        return of(n.left);
      default:
        return std::min(of(n.left), of(n.right));
    }
  }

  // Marks nodes whose contacts are written before a later contact uses them: their value must be
  // looked up in time and kept.
  void fix_stale(std::vector<bool>& fixed) {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < count_; ++i) {
        // Children first: once one is kept, what is above it lives on.
        if (is_gate(node(i))) {
          for (const NodeId child : {node(i).left, node(i).right}) {
            if (child == kNoNode) continue;
            const std::size_t at = child - first_;
            if (!fixed[at] && node(i).epoch > last_[at]) fixed[at] = changed = true;
          }
        }
        last_[i] = last_epoch(i, fixed);
      }
    }
  }

  // All ways to bring `child` into a look-up at `epoch`: its own value, or what it is made of.
  std::vector<Cut> inputs(NodeId child, std::int32_t epoch) const {
    std::vector<Cut> result;
    const Node& n = logic_.nodes[child];
    const bool alive = epoch <= last_[child - first_];
    if (boundary(child) || (alive && n.kind != NodeKind::NotLeaf)) {
      result.push_back(signal_cut(child, false));
    }
    if (n.kind == NodeKind::Leaf || (boundary(child) && is_gate(n))) return result;
    for (const Cut& cut : cuts_[child - first_]) {
      const auto usable = [&](NodeId signal) {
        return boundary(signal) || epoch <= last_[signal - first_];
      };
      if (std::all_of(cut.signals.begin(), cut.signals.begin() + cut.size, usable)) {
        result.push_back(cut);
      }
    }
    return result;
  }

  Cost cost_of(const Cut& cut) const {
    Cost cost{1, 0, 1};
    int fed = 0;
    for (int i = 0; i < cut.size; ++i) {
      const NodeId signal = cut.signals[i];
      const Node& n = logic_.nodes[signal];
      if (n.kind == NodeKind::Leaf || boundary(signal)) continue;
      const std::size_t at = signal - first_;
      cost.lookups += cost_[at].lookups;
      cost.awkward += cost_[at].awkward;
      cost.depth = std::max(cost.depth, cost_[at].depth + 1);
      if (++fed > 1 && reads_three_devices(best_[at])) ++cost.awkward;
    }
    return cost;
  }

  bool reads_three_devices(const Cut& cut) const {
    return cut.size == 3 && std::all_of(cut.signals.begin(), cut.signals.end(), [&](NodeId s) {
             return logic_.nodes[s].kind == NodeKind::Leaf || boundary(s);
           });
  }

  // Look-ups of the network with the boundary as it is, or kInfeasible; fills cuts_, best_, cost_.
  int evaluate() {
    int total = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const Node& n = node(i);
      last_[i] = last_epoch(i, cover_.boundary);
      std::vector<Cut>& cuts = cuts_[i];
      cuts.clear();
      if (n.kind == NodeKind::Leaf) {
        cuts.push_back(signal_cut(static_cast<NodeId>(first_ + i), false));
      } else if (n.kind == NodeKind::NotLeaf) {
        cuts.push_back(signal_cut(n.left, true));
      } else if (n.kind == NodeKind::Not) {
        cuts = inputs(n.left, n.epoch);
        for (Cut& cut : cuts) cut.function = static_cast<std::uint8_t>(~cut.function);
        if (cuts.empty()) return kInfeasible;
      } else {
        const auto lefts = inputs(n.left, n.epoch);
        const auto rights = inputs(n.right, n.epoch);
        Cut merged;
        for (const Cut& left : lefts) {
          for (const Cut& right : rights) {
            if (!merge(n.kind, left, right, merged)) continue;
            if (std::find(cuts.begin(), cuts.end(), merged) == cuts.end()) cuts.push_back(merged);
          }
        }
        if (cuts.empty()) return kInfeasible;
      }
      std::vector<std::pair<Cost, Cut>> ranked;
      for (const Cut& cut : cuts) ranked.emplace_back(cost_of(cut), cut);
      std::stable_sort(ranked.begin(), ranked.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      if (ranked.size() > kMaxCuts) ranked.resize(kMaxCuts);
      cuts.clear();
      for (const auto& [cost, cut] : ranked) cuts.push_back(cut);
      best_[i] = cuts.front();
      cost_[i] = ranked.front().first;
      if (cover_.boundary[i]) total += cost_[i].lookups;
    }
    return total;
  }

  void choose() {
    cover_.chosen = cover_.boundary;
    cover_.cuts = best_;
    for (std::size_t i = count_; i-- > 0;) {
      if (!cover_.chosen[i]) continue;
      for (int k = 0; k < best_[i].size; ++k) {
        const NodeId signal = best_[i].signals[k];
        if (signal == static_cast<NodeId>(first_ + i)) continue;  // a leaf's own look-up
        if (logic_.nodes[signal].kind != NodeKind::Leaf) cover_.chosen[signal - first_] = true;
      }
    }
  }

  const logic::Logic& logic_;
  NodeId first_;
  std::size_t count_;
  std::vector<std::vector<Cut>> cuts_;
  std::vector<Cut> best_;
  std::vector<Cost> cost_;
  std::vector<std::int32_t> last_;
  Cover cover_;
};

}  // namespace

Cover cover_network(const logic::Logic& logic, logic::NodeId first, std::size_t count,
                    const std::vector<std::pair<logic::NodeId, std::int32_t>>& conditions) {
  return Coverer(logic, first, count).run(conditions);
}

}  // namespace rung::mapping
