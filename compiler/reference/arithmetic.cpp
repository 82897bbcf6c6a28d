// SPDX-License-Identifier: Apache-2.0
// Word instructions that calculate: arithmetic, decimal numbers, rotates and shifts.
#include <optional>

#include "reference/reference.hpp"

namespace rung {
namespace {

// The low `width` bits (16 or 32).
std::uint64_t low_bits(std::int64_t value, int width) {
  return static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << width) - 1);
}

// The decimal digits of `value` as groups of four bits, or nothing if there are too many.
std::optional<std::uint32_t> to_bcd(std::int32_t value, int width) {
  if (value < 0 || value > (width == 32 ? 99999999 : 9999)) return std::nullopt;
  std::uint32_t digits = 0;
  for (int shift = 0; shift < width; shift += 4) {
    digits |= static_cast<std::uint32_t>(value % 10) << shift;
    value /= 10;
  }
  return digits;
}

// The reverse; nothing if a group of four bits is no decimal digit.
std::optional<std::uint32_t> from_bcd(std::int32_t digits, int width) {
  std::uint32_t value = 0;
  for (int shift = width - 4; shift >= 0; shift -= 4) {
    const std::uint32_t digit = static_cast<std::uint32_t>(digits) >> shift & 0xF;
    if (digit > 9) return std::nullopt;
    value = 10 * value + digit;
  }
  return value;
}

}  // namespace

void Reference::execute_arithmetic(const Instruction& instruction) {
  const int width = instruction.width;
  const auto source = [&](std::size_t i) -> std::int64_t {
    return read_word(instruction.operand(i), width);
  };
  const auto target = [&](std::size_t i, std::int64_t value) {
    write_word(instruction.operand(i), static_cast<std::uint64_t>(value), width);
  };
  switch (instruction.op) {
    case Op::Add:
    case Op::Sub: {
      const std::int64_t a = source(0);
      const std::int64_t b = source(1);
      const std::int64_t exact = instruction.op == Op::Add ? a + b : a - b;
      target(2, exact);
      return set_flags(exact, width);
    }
    case Op::Mul: {
      const std::int64_t product = source(0) * source(1);
      return write_word(instruction.operand(2), static_cast<std::uint64_t>(product),
                        instruction.double_width ? 2 * width : width);
    }
    case Op::Div:
      return divide(instruction, source(0), source(1));
    case Op::Inc:
      return target(0, source(0) + 1);
    case Op::Dec:
      return target(0, source(0) - 1);
    case Op::Neg:
      return target(0, -source(0));
    case Op::Bcd:
    case Op::Bin:
      return decimal(instruction);
    default:
      return rotate(instruction);
  }
}

void Reference::divide(const Instruction& instruction, std::int64_t a, std::int64_t b) {
  if (b == 0) {
    error_ = true;
    return fail();
  }
  // C++ divides toward zero, the remainder having the sign of the dividend, as MELSEC does; in 64
  // bits there is room for the quotient of the lowest value and -1.
  const int width = instruction.width;
  const std::uint64_t quotient = low_bits(a / b, width);
  if (!instruction.double_width) return write_word(instruction.operand(2), quotient, width);
  const std::uint64_t remainder = low_bits(a % b, width);
  write_word(instruction.operand(2), remainder << width | quotient, 2 * width);
}

// After ADD and SUB on an FX, from the result as it is without any limit.
void Reference::set_flags(std::int64_t exact, int width) {
  if (program_.dialect != Dialect::Fx) return;
  const std::int64_t most = (std::int64_t{1} << (width - 1)) - 1;
  for (const Device flag : zero_) change(flag, low_bits(exact, width) == 0 ? 1 : 0);
  for (const Device flag : borrow_) change(flag, exact < -most - 1 ? 1 : 0);
  set_carry(exact > most);
}

void Reference::set_carry(bool value) {
  for (const Device flag : carry_) change(flag, value ? 1 : 0);
}

void Reference::decimal(const Instruction& instruction) {
  const int width = instruction.width;
  const std::int32_t value = read_word(instruction.operand(0), width);
  const std::optional<std::uint32_t> converted =
      instruction.op == Op::Bcd ? to_bcd(value, width) : from_bcd(value, width);
  if (!converted) return fail();
  write_word(instruction.operand(1), *converted, width);
}

// Bit by bit: as many times as the instruction says, the bit that leaves goes into carry and, of
// the rotates, comes in again at the other end; through carry it is the old carry that comes in.
void Reference::rotate(const Instruction& instruction) {
  const int width = instruction.width;
  const Op op = instruction.op;
  const bool up = op == Op::Rol || op == Op::Rcl || op == Op::Sfl;
  const bool shift = op == Op::Sfl || op == Op::Sfr;
  const bool through_carry = op == Op::Rcl || op == Op::Rcr;
  const int count = instruction.operand(1).value;
  if (count == 0 && !shift) return;

  auto value =
      static_cast<std::uint32_t>(low_bits(read_word(instruction.operand(0), width), width));
  bool carry = through_carry && !carry_.empty() && get(carry_.front()) != 0;
  const int top = width - 1;
  for (int i = 0; i < count; ++i) {
    const bool leaves = (value >> (up ? top : 0) & 1) != 0;
    const bool enters = !shift && (through_carry ? carry : leaves);
    const auto bit = std::uint32_t{enters};
    value = up ? value << 1 | bit : value >> 1 | bit << top;
    value = static_cast<std::uint32_t>(low_bits(value, width));
    carry = leaves;
  }
  write_word(instruction.operand(0), value, width);
  set_carry(carry);
}

}  // namespace rung
