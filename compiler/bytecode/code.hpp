// SPDX-License-Identifier: Apache-2.0
// The lowered program as byte code.
#pragma once

#include <string>

#include "bytecode/layout.hpp"
#include "bytecode/stacks.hpp"

namespace rung::bytecode {

// Its code, END included.
std::string encode(const core::Program& program, const Layout& layout, const StackPlan& plan);

}  // namespace rung::bytecode
