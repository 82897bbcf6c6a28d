// SPDX-License-Identifier: Apache-2.0
// LDmicro: tables. The target may be the index, and then later rows are compared with what earlier
// ones have given; written is what is there in the end.
#include "reference/reference.hpp"

namespace rung {
namespace {

// What LDmicro's 16-bit arithmetic makes of each intermediate result.
std::int16_t wrapped(std::int32_t value) { return static_cast<std::int16_t>(value); }

}  // namespace

void Reference::look_up(const Instruction& instruction) {
  if (!now_.result) return;
  const Operand& target = instruction.operand(0);
  const bool same = instruction.operand(1) == target;
  std::int16_t index = variable_of(instruction.operand(1));
  std::int16_t value = variable_of(target);
  for (std::size_t row = 0; row < instruction.table.size(); ++row) {
    if (index != static_cast<int>(row)) continue;
    value = wrapped(instruction.table[row]);
    if (same) index = value;
  }
  change(target.device, value);
}

void Reference::interpolate(const Instruction& instruction) {
  if (!now_.result) return;
  const Operand& target = instruction.operand(0);
  const bool same = instruction.operand(1) == target;
  const std::vector<std::int32_t>& table = instruction.table;
  std::int16_t index = variable_of(instruction.operand(1));
  std::int16_t value = variable_of(target);
  for (std::size_t point = table.size() / 2; point-- > 1;) {
    const std::int32_t x0 = table[2 * point - 2];
    const std::int32_t y0 = table[2 * point - 1];
    const std::int32_t x1 = table[2 * point];
    const std::int32_t y1 = table[2 * point + 1];
    if (index >= wrapped(x1 + 1)) continue;
    const std::int16_t product = wrapped(wrapped(index - x0) * std::int32_t{wrapped(y1 - y0)});
    value = wrapped(product / wrapped(x1 - x0) + y0);
    if (same) index = value;
  }
  change(target.device, value);
}

}  // namespace rung
