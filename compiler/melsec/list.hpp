// SPDX-License-Identifier: Apache-2.0
// The front end for plain MELSEC instruction lists.
#pragma once

#include <optional>

#include "rungs/program.hpp"
#include "source/text_file.hpp"

namespace rung {

// Parses a plain list. `dialect` is what the user asked for; without it the list decides: paper if
// it has MV, or ADD SUB MUL DIV with two operands; else q if it has + - * /; else fx. A list must
// end with END unless its name ends in .esc (LadderDrive). Nothing, with all its errors in
// `diagnostics`, when it is refused.
std::optional<Program> parse_list(const SourceText& source, std::optional<Dialect> dialect,
                                  Diagnostics& diagnostics);

}  // namespace rung
