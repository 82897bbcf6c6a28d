// SPDX-License-Identifier: Apache-2.0
// Outputs on bits, and the instructions that shift them.
#include "reference/reference.hpp"

namespace rung {

// Those that write in every scan, executed or not.
void Reference::execute_coil(const Instruction& instruction) {
  const std::optional<Operand> located = locate(instruction.operand(0), 1);
  const bool on = condition();
  bool value = on;
  switch (instruction.op) {
    case Op::Outi:
      value = power() && !now_.result;
      break;
    case Op::Pls:
      value = !exchange_memory(on) && on;
      break;
    case Op::Plf:
      value = exchange_memory(on) && !on;
      break;
    default:
      break;
  }
  if (!located) return fail();
  if (instruction.op == Op::Out && transition(*located)) return;
  write_bit(*located, value);
}

void Reference::execute_bits(const Instruction& instruction) {
  const Operand& bit = instruction.operand(0);
  switch (instruction.op) {
    case Op::Set:
      if (!transition(bit)) write_bit(bit, true);
      return;
    case Op::Alt:
      return write_bit(bit, !read_bit(bit));
    case Op::Sft: {
      const Operand before = element(bit, -1, 16);
      const bool value = read_bit(before);
      write_bit(before, false);
      return write_bit(bit, value);
    }
    case Op::Sftl:
      return shift_between(instruction, true);
    case Op::Sftr:
      return shift_between(instruction, false);
    case Op::Bsfl:
      return shift_by_one(instruction, true);
    case Op::Bsfr:
      return shift_by_one(instruction, false);
    default:
      return;
  }
}

// SFTL SFTR WSFL WSFR: elements of a row move by some places, those of another one move in.
void Reference::shift_between(const Instruction& instruction, bool up) {
  const Operand& source = instruction.operand(0);
  const Operand& target = instruction.operand(1);
  const int length = instruction.operand(2).value;
  const int count = instruction.operand(3).value;
  const bool words = instruction.op == Op::Wsfl || instruction.op == Op::Wsfr;
  const auto read = [&](const Operand& head, int i) -> std::int32_t {
    const Operand each = element(head, i, 16);
    return words ? read_word(each, 16) : static_cast<std::int32_t>(read_bit(each));
  };
  std::vector<std::int32_t> moved;
  for (int i = 0; i < length; ++i) {
    if (up) {
      moved.push_back(i < count ? read(source, i) : read(target, i - count));
    } else {
      moved.push_back(i + count < length ? read(target, i + count)
                                         : read(source, i + count - length));
    }
  }
  for (int i = 0; i < length; ++i) {
    const Operand each = element(target, i, 16);
    const std::int32_t value = moved[static_cast<std::size_t>(i)];
    if (words) {
      write_word(each, static_cast<std::uint64_t>(value), 16);
    } else {
      write_bit(each, value != 0);
    }
  }
}

// BSFL BSFR DSFL DSFR: a row moves by one place, 0 moves in.
void Reference::shift_by_one(const Instruction& instruction, bool up) {
  const Operand& head = instruction.operand(0);
  const int length = instruction.operand(1).value;
  if (length <= 0) return;
  const bool words = instruction.op == Op::Dsfl || instruction.op == Op::Dsfr;
  std::vector<std::int32_t> row;
  for (int i = 0; i < length; ++i) {
    const Operand each = element(head, i, 16);
    row.push_back(words ? read_word(each, 16) : static_cast<std::int32_t>(read_bit(each)));
  }
  const std::int32_t left = up ? row.back() : row.front();
  if (up) {
    row.insert(row.begin(), 0);
    row.pop_back();
  } else {
    row.erase(row.begin());
    row.push_back(0);
  }
  for (int i = 0; i < length; ++i) {
    const Operand each = element(head, i, 16);
    const std::int32_t value = row[static_cast<std::size_t>(i)];
    if (words) {
      write_word(each, static_cast<std::uint64_t>(value), 16);
    } else {
      write_bit(each, value != 0);
    }
  }
  if (!words) set_carry(left != 0);
}

}  // namespace rung
