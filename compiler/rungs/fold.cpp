// SPDX-License-Identifier: Apache-2.0
#include "rungs/fold.hpp"

#include <cassert>

namespace rung {

std::optional<Folded> fold(Op op, std::int16_t first, std::int16_t second) {
  const std::int32_t a = first;
  const std::int32_t b = second;
  const auto words = [](std::int32_t low, std::int32_t high) {
    return Folded{static_cast<std::int16_t>(low), static_cast<std::int16_t>(high)};
  };
  switch (op) {
    case Op::Add:
      return words(a + b, 0);
    case Op::Sub:
      return words(a - b, 0);
    case Op::Mul:
      return words(a * b, a * b >> 16);
    case Op::Div:
      if (b == 0) return std::nullopt;
      return words(a / b, a % b);
    default:
      assert(false && "not an arithmetic instruction");
      return std::nullopt;
  }
}

}  // namespace rung
