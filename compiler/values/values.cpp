// SPDX-License-Identifier: Apache-2.0
#include "values/values.hpp"

#include <algorithm>

namespace rung::values {

Literal Values::land(Literal a, Literal b) {
  if (a > b) std::swap(a, b);
  if (a == kFalse || a == inverse(b)) return kFalse;
  if (a == kTrue || a == b) return b;
  const std::uint64_t key = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
  const auto [place, fresh] = ands.try_emplace(key, static_cast<NodeId>(nodes.size()));
  if (fresh) {
    Node node;
    node.kind = NodeKind::And;
    node.left = a;
    node.right = b;
    nodes.push_back(node);
  }
  return 2 * place->second;
}

Literal Values::start(Device device) {
  const auto [place, fresh] = starts.try_emplace(device, static_cast<NodeId>(nodes.size()));
  if (fresh) {
    Node node;
    node.kind = NodeKind::Start;
    node.device = device;
    nodes.push_back(node);
  }
  return 2 * place->second;
}

Literal Values::test(std::int32_t operation) {
  Node node;
  node.kind = NodeKind::Test;
  node.operation = operation;
  nodes.push_back(node);
  return 2 * static_cast<NodeId>(nodes.size() - 1);
}

}  // namespace rung::values
