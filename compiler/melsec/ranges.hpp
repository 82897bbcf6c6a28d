// SPDX-License-Identifier: Apache-2.0
// Whether the devices that an instruction takes beside those it names are there: second words, the
// rest of a row, of a digit group.
#pragma once

#include "melsec/instructions.hpp"
#include "melsec/lexer.hpp"
#include "melsec/operands.hpp"

namespace rung {

// Checks counts and rows of an instruction whose operands fit their roles one by one; `words` are
// the operands as the source has them. False, with the errors, if something does not fit.
bool check_ranges(const Instruction& instruction, const SourceInstruction& row,
                  const std::vector<ListWord>& words, Dialect dialect, OperandReader& reader);

}  // namespace rung
