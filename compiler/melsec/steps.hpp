// SPDX-License-Identifier: Apache-2.0
// Program steps: what an instruction takes of a maker's program memory, and so the step numbers
// that its tools show.
#pragma once

#include <string_view>
#include <vector>

#include "melsec/csv_list.hpp"
#include "rungs/program.hpp"

namespace rung {

// fx (and paper): as GX Works2 counts for an FX2N, beyond that an FX3U. q: as its exports show; of
// some instructions the makers' tools count one more, depending on the operands' range.
int program_steps(const Instruction& instruction, Dialect dialect);

// A line statement or note, whose bytes are those of Shift-JIS.
int text_steps(std::string_view text);

// The step number of each instruction of `program`, and at last that of END. `csv`: where it comes
// from, for the texts that stand between; null if there are none.
std::vector<int> step_numbers(const Program& program, const CsvProgram* csv);

}  // namespace rung
