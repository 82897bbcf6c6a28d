// SPDX-License-Identifier: Apache-2.0
// `rung translate --to il`: a program as a plain instruction list.
#pragma once

#include <string>

#include "rungs/program.hpp"

namespace rung {

// One instruction in the dialect's own words, without padding; constants decimal.
std::string to_list(const Instruction& instruction, Dialect dialect);

// The whole list: one instruction a line, a blank line between networks, END at the end. A comment
// on top names the dialect; read with that dialect, the list gives the same program.
std::string to_list(const Program& program);

}  // namespace rung
