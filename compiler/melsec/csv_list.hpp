// SPDX-License-Identifier: Apache-2.0
// Programs that GX Works2, GX Works3 and GX Developer write as CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "melsec/statements.hpp"
#include "source/text_file.hpp"

namespace rung {

// A text that stands beside the program and takes program steps: a line statement or a note.
struct CsvText {
  std::size_t before = 0;  // how many statements stand before it
  std::string text;
  SourcePosition position;
};

struct CsvProgram {
  StatementList list;
  std::optional<Dialect> dialect;  // of the controller that the file names
  // Program steps that the file gives for each statement, -1 where it gives none; for END too.
  std::vector<int> steps;
  std::vector<CsvText> texts;
};

// True for such a file by its looks: quoted cells, or a row with a step number in the first column
// and an instruction in the third.
bool is_csv_program(const SourceText& source);

// Reads the rows by the position of their columns: step, line statement, instruction, operand,
// blank, PI statement, note. Rows before the first with a step are the title, the controller and
// the headers, in whatever language. A row without step and instruction is one more operand, which
// may stand in the instruction's column. An unknown controller is an error unless `dialect` is
// given.
CsvProgram read_csv_program(const SourceText& source, std::optional<Dialect> dialect,
                            Diagnostics& diagnostics);

// The front end for these files; as parse_list().
std::optional<Program> parse_csv(const SourceText& source, std::optional<Dialect> dialect,
                                 Diagnostics& diagnostics);

}  // namespace rung
