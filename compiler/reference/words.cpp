// SPDX-License-Identifier: Apache-2.0
// Word instructions that move, combine and compare words.
#include <array>

#include "reference/reference.hpp"

namespace rung {
namespace {

// Exchanges the bytes of each 16-bit word.
std::uint32_t swapped(std::uint32_t value) {
  return (value & 0x00FF00FFU) << 8 | (value >> 8 & 0x00FF00FFU);
}

}  // namespace

void Reference::execute_word(const Instruction& instruction) {
  const int width = instruction.width;
  const auto source = [&](std::size_t i) { return read_word(instruction.operand(i), width); };
  const auto combine = [&](auto operation) {
    const auto a = static_cast<std::uint32_t>(source(0));
    const auto b = static_cast<std::uint32_t>(source(1));
    write_word(instruction.operand(2), operation(a, b), width);
  };
  switch (instruction.op) {
    case Op::Wand:
      return combine([](std::uint32_t a, std::uint32_t b) { return a & b; });
    case Op::Wor:
      return combine([](std::uint32_t a, std::uint32_t b) { return a | b; });
    case Op::Wxor:
      return combine([](std::uint32_t a, std::uint32_t b) { return a ^ b; });
    case Op::Wxnr:
      return combine([](std::uint32_t a, std::uint32_t b) { return ~(a ^ b); });
    case Op::Cmp: {
      const std::int32_t a = source(0);
      const std::int32_t b = source(1);
      return write_relations(instruction.operand(2), {a > b, a == b, a < b});
    }
    case Op::Zcp: {
      const std::int32_t low = source(0);
      const std::int32_t high = source(1);
      const std::int32_t s = source(2);
      return write_relations(instruction.operand(3), {s < low, low <= s && s <= high, s > high});
    }
    case Op::Wsfl:
      return shift_between(instruction, true);
    case Op::Wsfr:
      return shift_between(instruction, false);
    case Op::Dsfl:
      return shift_by_one(instruction, true);
    case Op::Dsfr:
      return shift_by_one(instruction, false);
    case Op::Zrst:
      return reset_range(instruction);
    case Op::Mov:
    case Op::Cml:
    case Op::Xch:
    case Op::Swap:
    case Op::Bmov:
    case Op::Fmov:
      return execute_move(instruction);
    default:
      return execute_arithmetic(instruction);
  }
}

void Reference::execute_move(const Instruction& instruction) {
  const int width = instruction.width;
  const Operand& first = instruction.operand(0);
  const auto value = static_cast<std::uint32_t>(read_word(first, width));
  switch (instruction.op) {
    case Op::Mov:
      return write_word(instruction.operand(1), value, width);
    case Op::Cml:
      return write_word(instruction.operand(1), ~value, width);
    case Op::Swap:
      return write_word(first, swapped(value), width);
    case Op::Xch: {
      const Operand& second = instruction.operand(1);
      const auto other = static_cast<std::uint32_t>(read_word(second, width));
      // The lower device first, which two pairs that overlap show.
      const bool ascending = first.device < second.device;
      write_word(ascending ? first : second, ascending ? other : value, width);
      return write_word(ascending ? second : first, ascending ? value : other, width);
    }
    default:
      break;
  }
  // BMOV, FMOV
  std::vector<std::uint32_t> values;
  for (int i = 0; i < instruction.operand(2).value; ++i) {
    const bool block = instruction.op == Op::Bmov;
    values.push_back(block ? static_cast<std::uint32_t>(read_word(element(first, i, width), width))
                           : value);
  }
  for (int i = 0; i < instruction.operand(2).value; ++i) {
    write_word(element(instruction.operand(1), i, width), values[static_cast<std::size_t>(i)],
               width);
  }
}

void Reference::write_relations(const Operand& head, std::array<bool, 3> relations) {
  for (int i = 0; i < 3; ++i) {
    write_bit(element(head, i, 16), relations[static_cast<std::size_t>(i)]);
  }
}

}  // namespace rung
