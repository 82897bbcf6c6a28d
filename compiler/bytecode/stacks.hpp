// SPDX-License-Identifier: Apache-2.0
// The stacks of the lowered program, made strict: there every load pushes the result before it,
// which most of the time nobody wants back. Byte code pushes only what is popped again and used.
#pragma once

#include <cstddef>
#include <vector>

#include "core/program.hpp"

namespace rung::bytecode {

struct StackPlan {
  std::vector<bool> pushes;   // by instruction: a load that has to push
  std::vector<bool> dropped;  // a POP that gives nothing that is used
  int blocks = 0;             // greatest depths
  int branches = 0;
};

StackPlan plan_stacks(const core::Program& program);

}  // namespace rung::bytecode
