// SPDX-License-Identifier: Apache-2.0
// Arithmetic on two constants, done once for all by the compiler.
#pragma once

#include <cstdint>
#include <optional>

#include "rungs/program.hpp"

namespace rung {

// The words that ADD, SUB, MUL or DIV of two constants writes: the result, and the high word of the
// product or the remainder.
struct Folded {
  std::int16_t low = 0;
  std::int16_t high = 0;
};

// Nothing for a division by 0, which has to raise the error flag when it runs.
std::optional<Folded> fold(Op op, std::int16_t first, std::int16_t second);

}  // namespace rung
