// SPDX-License-Identifier: Apache-2.0
// The text of a COMMENT as its line in the file has it. All work byte by byte.
#pragma once

#include <string>
#include <string_view>

namespace rung {

// Escapes are \n, \r and \\; from any other the backslash is dropped.
std::string unescape_comment(std::string_view line);
std::string escape_comment(std::string_view text);

// The same for Instruction::note, in which \n alone parts the lines; in the file it is \r\n.
std::string ld_note(std::string_view line);
std::string ld_comment(std::string_view note);

}  // namespace rung
