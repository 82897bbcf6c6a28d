// SPDX-License-Identifier: Apache-2.0
// A case as byte code.
#pragma once

#include "agree/case.hpp"

namespace rung::tb {

// What the interpreter does. Throws std::runtime_error if the case cannot be byte code.
Behaviour run_as_bytecode(const Case& one);

}  // namespace rung::tb
