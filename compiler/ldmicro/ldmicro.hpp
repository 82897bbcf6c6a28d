// SPDX-License-Identifier: Apache-2.0
// The front end for LDmicro programs (`.ld`). What is accepted: compiler/LDMICRO.md, Files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rungs/program.hpp"
#include "source/text_file.hpp"

namespace rung {

// `bytes` as text. Beside what decode_text knows, LDmicro writes the code page of its Windows, of
// which only the Japanese and the Western one are tried; and it escapes comments byte by byte, so
// that in the Japanese one a character's second byte may be a backslash that an escape begins with.
// In the text that comes out, every backslash in a comment begins an escape.
std::optional<SourceText> decode_ldmicro(std::string_view bytes, const std::string& file,
                                         Diagnostics& diagnostics);

// Parses a program of format 0.1, or of 0.2 as far as it says what 0.1 can say. Nothing, with all
// its errors in `diagnostics`, when it is refused.
std::optional<Program> parse_ldmicro(const SourceText& source, Diagnostics& diagnostics);

}  // namespace rung
