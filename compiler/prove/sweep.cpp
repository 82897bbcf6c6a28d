// SPDX-License-Identifier: Apache-2.0
#include "prove/sweep.hpp"

#include <algorithm>
#include <span>

namespace rung::prove {
namespace {

// Of one value: what is the same in all starts that were simulated is tried so often, and so often
// a start is learned that tells the value from another one.
constexpr int kLessons = 8;
// All with what is near them, few with more, since nearly all that are equal are so at once.
struct Look {
  std::size_t candidates;
  NodeId nodes;  // before the candidate, that are no free values
};
constexpr NodeId kAll = 0xffffffff;
constexpr Look kLooks[] = {{32, 0}, {4, 200}, {2, kAll}};

}  // namespace

Sweep::Sweep(Terms& terms, Solver& solver)
    : terms_(terms), solver_(solver), end_(static_cast<NodeId>(terms.size())) {
  sort();
}

void Sweep::sort() {
  by_simulation_.clear();
  for (NodeId node = 1; node < end_; ++node) by_simulation_[key_of(node << 1)].push_back(node);
}

std::uint64_t Sweep::key_of(Bit bit) const {
  const Terms::Patterns patterns = terms_.simulated(bit);
  const std::uint64_t inverted = (patterns[0] & 1U) != 0 ? ~std::uint64_t{0} : 0;
  std::uint64_t key = 0;
  for (const std::uint64_t word : patterns) {
    key = (key ^ word ^ inverted) * 0x9e3779b97f4a7c15;
    key ^= key >> 29;
  }
  return key;
}

Bit Sweep::represent(Bit bit) {
  const NodeId node = node_of(bit);
  const Bit sign = bit & 1U;
  if (node < end_) {
    if (node != 0 && !terms_.is_variable(node)) solver_.cut(bit);
    return bit;
  }
  const auto [place, fresh] = represented_.try_emplace(node, node << 1);
  if (!fresh) return place->second ^ sign;
  bool again = true;
  for (int lesson = 0; lesson < kLessons && again; ++lesson) {
    again = false;
    if (find(node, again)) return represented_.at(node) ^ sign;
  }
  return bit;
}

NodeId Sweep::newest_of(NodeId node) const {
  constexpr std::size_t kNodes = 64;
  NodeId newest = 0;
  std::vector<NodeId> open{node};
  for (std::size_t i = 0; i < open.size() && i < kNodes; ++i) {
    if (open[i] < end_) {
      newest = std::max(newest, open[i]);
    } else if (!terms_.is_variable(open[i])) {
      open.push_back(node_of(terms_.left(open[i])));
      open.push_back(node_of(terms_.right(open[i])));
    }
  }
  return newest;
}

bool Sweep::find(NodeId node, bool& again) {
  const Bit bit = node << 1;
  const auto found = by_simulation_.find(key_of(bit));
  if (found == by_simulation_.end()) return false;
  // What is made of some values stands soon behind them.
  std::vector<NodeId> candidates = found->second;
  const auto first = std::upper_bound(candidates.begin(), candidates.end(), newest_of(node));
  std::reverse(candidates.begin(), first);
  std::rotate(candidates.begin(), first, candidates.end());
  for (const Look& look : kLooks) {
    const std::size_t count = std::min(look.candidates, candidates.size());
    for (const NodeId candidate : std::span(candidates).first(count)) {
      const Bit plain = candidate << 1;
      const Bit other = plain ^ ((terms_.simulated(bit)[0] ^ terms_.simulated(plain)[0]) & 1U);
      const Bit differ = terms_.differ(bit, other);
      const NodeId near = candidate > look.nodes ? candidate - look.nodes : 0;
      const NodeId free = look.nodes == 0 ? static_cast<NodeId>(terms_.size()) : near;
      const Answer answer = solver_.ask_quickly(differ, free);
      if (answer.verdict == Verdict::Never) {
        solver_.cut(other);
        represented_[node] = other;
        return true;
      }
      if (answer.verdict != Verdict::Possible) continue;
      terms_.learn(answer.model);
      sort();
      again = true;
      return false;
    }
  }
  return false;
}

Word Sweep::represent(const Word& word) {
  Word out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = represent(word[i]);
  return out;
}

}  // namespace rung::prove
