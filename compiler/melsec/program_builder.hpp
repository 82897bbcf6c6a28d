// SPDX-License-Identifier: Apache-2.0
// Statements, from a list or a CSV, turned into a checked program.
#pragma once

#include <optional>
#include <string>

#include "melsec/statements.hpp"
#include "rungs/program.hpp"

namespace rung {

// The dialect that the statements themselves show: paper if there is MV, or ADD SUB MUL DIV with
// two operands; else q if there is + - * /; else fx.
Dialect dialect_of(const std::vector<Statement>& statements);

// The program of `list`; nothing, with all its errors in `diagnostics`, when something in it is
// refused. `whole`: the statements are all that the file has, so that their structure can be
// judged.
std::optional<Program> build_program(const StatementList& list, const std::string& file,
                                     Dialect dialect, bool whole, Diagnostics& diagnostics);

}  // namespace rung
