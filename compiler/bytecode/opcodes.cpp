// SPDX-License-Identifier: Apache-2.0
#include "bytecode/opcodes.hpp"

#include <iterator>

namespace rung::bytecode {
namespace {

constexpr CodeInfo kCodes[] = {
#define RUNG_OPCODE(name, code, operands, effect, meaning) \
  {#name, Code::name, operands, effect[0], meaning},
#include "bytecode/interpreter/rung_opcodes.h"
#undef RUNG_OPCODE
};

constexpr bool numbered() {
  for (std::size_t i = 0; i < std::size(kCodes); ++i) {
    if (static_cast<std::size_t>(kCodes[i].code) != i) return false;
  }
  return true;
}
static_assert(numbered(), "info() finds an instruction by its code");

}  // namespace

std::span<const CodeInfo> codes() { return kCodes; }

}  // namespace rung::bytecode
