// SPDX-License-Identifier: Apache-2.0
// The byte code's instructions, from interpreter/rung_opcodes.h.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace rung::bytecode {

enum class Code : std::uint8_t {
#define RUNG_OPCODE(name, code, operands, effect, meaning) name = code,
#include "bytecode/interpreter/rung_opcodes.h"
#undef RUNG_OPCODE
};

struct CodeInfo {
  std::string_view name;
  Code code;
  std::string_view operands;  // a letter each, as that file explains
  char effect;
  std::string_view meaning;
};

// All of them, by code.
std::span<const CodeInfo> codes();
inline const CodeInfo& info(Code code) { return codes()[static_cast<std::size_t>(code)]; }

}  // namespace rung::bytecode
