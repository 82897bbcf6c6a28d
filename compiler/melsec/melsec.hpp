// SPDX-License-Identifier: Apache-2.0
// The front end for MELSEC programs of every form.
#pragma once

#include <optional>

#include "rungs/program.hpp"
#include "source/text_file.hpp"

namespace rung {

// Parses a plain or step list, or a CSV that GX Works2, GX Works3 or GX Developer wrote; the text
// shows which. The dialect is `dialect` if given, else that of the controller that a CSV names,
// else what the instructions show (dialect_of). Nothing, with all its errors in `diagnostics`, when
// the program is refused.
std::optional<Program> parse_melsec(const SourceText& source, std::optional<Dialect> dialect,
                                    Diagnostics& diagnostics);

}  // namespace rung
