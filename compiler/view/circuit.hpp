// SPDX-License-Identifier: Apache-2.0
// A rung as a drawing has it: elements in series and in parallel between two rails, in place of the
// order in which a list names them.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "rungs/program.hpp"

namespace rung::view {

struct Node {
  enum class Kind : std::uint8_t {
    Element,   // `instruction`
    Series,    // `parts` from left to right; within another one a block that has its own result
    Parallel,  // `parts` from top to bottom, joined again at their right
    Fork,      // the same, not joined: outputs, and what stands before some of them
  };
  Kind kind = Kind::Element;
  std::size_t instruction = 0;
  std::vector<std::shared_ptr<const Node>> parts;
};
using NodePtr = std::shared_ptr<const Node>;

// INV, MEP and MEF, which turn a result into another one, that of a block since its LD.
bool changes_result(Op op);

// The circuit of a network. Where a list goes on from a result in a way that no drawing shows (OR
// behind an output), the contacts that made it are drawn again; both stand for the same
// instruction.
NodePtr circuit_of(const Program& program, const Network& network);

}  // namespace rung::view
