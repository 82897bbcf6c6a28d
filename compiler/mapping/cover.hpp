// SPDX-License-Identifier: Apache-2.0
// Which look-ups cover the logic of one network: three-input cuts of its nodes, chosen so that the
// look-ups are fewest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "logic/logic.hpp"

namespace rung::mapping {

// A way to compute some node with one look-up: the signals that it reads, leaves or other nodes,
// ascending, and its function of them: bit {s0,s1,s2}, s0 the highest. The function depends on
// every signal; a constant has none.
struct Cut {
  std::array<logic::NodeId, 3> signals{logic::kNoNode, logic::kNoNode, logic::kNoNode};
  int size = 0;
  std::uint8_t function = 0;
  bool operator==(const Cut&) const = default;
};

// The cover of one network. Nodes are numbered as in Logic; a vector below is indexed by
// node - first.
struct Cover {
  logic::NodeId first = 0;
  std::vector<bool> boundary;  // nodes that have a look-up of their own whose value is kept
  std::vector<bool> chosen;    // nodes that have a look-up, boundary or not
  std::vector<Cut> cuts;       // of chosen nodes
  int lookups = 0;

  bool is_boundary(logic::NodeId node) const { return boundary[node - first]; }
  bool is_chosen(logic::NodeId node) const { return chosen[node - first]; }
  const Cut& cut(logic::NodeId node) const { return cuts[node - first]; }
};

// Covers nodes [first, first + count) of `logic`, which are one network; `conditions` are the nodes
// under which actions stand, with the epoch at which each is last needed.
Cover cover_network(const logic::Logic& logic, logic::NodeId first, std::size_t count,
                    const std::vector<std::pair<logic::NodeId, std::int32_t>>& conditions);

}  // namespace rung::mapping
