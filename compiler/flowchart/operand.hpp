// SPDX-License-Identifier: Apache-2.0
// Devices as a `.flow` text names them, and what may be done with each.
#pragma once

#include <string>

#include "flowchart/tokens.hpp"
#include "rungs/program.hpp"

namespace rung::flowchart {

// The bit, word, digit group or bit of a word that a token names. Throws a Refusal where it is no
// device of the dialect, or one that is the ladder's alone.
Operand read_operand(const Token& token, Dialect dialect);
// Whether it is a bit: a device, or a bit of a word.
bool is_bit(const Operand& operand);
// Refuses what a step cannot write.
void check_writable(const Token& token, const Operand& operand, Dialect dialect);

}  // namespace rung::flowchart
