// SPDX-License-Identifier: Apache-2.0
// The units for MUL and DIV that stand behind a hard-wired program's module, in the same file.
#pragma once

#include <string>
#include <string_view>

#include "hardwired/plan.hpp"

namespace rung::hardwired {

// The module of a unit; its name is `prefix`, `_` and the unit's.
std::string unit_module(const Unit& unit, std::string_view prefix);

}  // namespace rung::hardwired
