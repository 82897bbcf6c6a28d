// SPDX-License-Identifier: Apache-2.0
// `rung translate --to ld`: an LDmicro program in format 0.1, as LDmicro 2.3 loads it.
#pragma once

#include <optional>
#include <string>

#include "rungs/program.hpp"

namespace rung {

// The element of an LDmicro program as its line has it, names and numbers normalised. Not for
// COMMENT and what frames elements.
std::string to_ld(const Instruction& instruction, const Program& program);

// The whole file: ASCII, or in the code page that reads back as the same text, or else in UTF-8.
// Nothing, with errors, when it passes a limit of LDmicro 2.3.
std::optional<std::string> to_ld(const Program& program, Diagnostics& diagnostics);

}  // namespace rung
