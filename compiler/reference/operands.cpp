// SPDX-License-Identifier: Apache-2.0
// Operands: index registers, digit groups, bits of words, pairs of words.
#include <algorithm>
#include <utility>

#include "reference/reference.hpp"
#include "rungs/devices.hpp"

namespace rung {
namespace {

// How many devices the operand takes from its device on.
int devices_of(const Instruction& instruction, std::size_t i) {
  if (!is_word(instruction.operand(i).device)) return 1;
  const int words = instruction.width / 16;
  return instruction.double_width && i == 2 ? 2 * words : words;
}

}  // namespace

std::optional<Instruction> Reference::locate(const Instruction& instruction) const {
  Instruction located = instruction;
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    std::optional<Operand> operand = locate(instruction.operand(i), devices_of(instruction, i));
    if (!operand) return std::nullopt;
    located.operands[i] = *operand;
  }
  return located;
}

std::optional<Operand> Reference::locate(const Operand& operand, int devices) const {
  if (!operand.index) return operand;
  const auto window = std::find_if(windows_.begin(), windows_.end(), [&](const IndexWindow& each) {
    return each.kind == operand.device.kind;
  });
  if (window == windows_.end()) return std::nullopt;
  const std::int64_t first = std::int64_t{operand.device.number} + get(*operand.index);
  if (first < window->first || first + devices - 1 > window->last) return std::nullopt;
  Operand located = operand;
  located.device.number = static_cast<std::uint32_t>(first);
  located.index.reset();
  return located;
}

bool Reference::read_bit(const Operand& operand) const {
  const auto value = static_cast<std::uint16_t>(get(operand.device));
  if (operand.kind == Operand::Kind::WordBit) return (value >> operand.bit & 1) != 0;
  return value != 0;
}

void Reference::write_bit(const Operand& operand, bool value) {
  if (operand.kind != Operand::Kind::WordBit) return write(operand.device, value ? 1 : 0);
  const auto mask = static_cast<std::uint16_t>(1U << operand.bit);
  const auto word = static_cast<std::uint16_t>(get(operand.device));
  write(operand.device, static_cast<std::int16_t>(value ? word | mask : word & ~mask));
}

std::int32_t Reference::read_word(const Operand& operand, int width) const {
  std::uint32_t value = 0;
  switch (operand.kind) {
    case Operand::Kind::Digits: {
      const std::vector<Device> bits = digit_bits(operand);
      for (std::size_t i = 0; i < bits.size(); ++i) {
        if (get(bits[i]) != 0) value |= std::uint32_t{1} << i;
      }
      break;
    }
    case Operand::Kind::Device:
      value = static_cast<std::uint16_t>(get(operand.device));
      if (width == 32) {
        const Device high = high_word(operand.device, program_.dialect);
        value |= std::uint32_t{static_cast<std::uint16_t>(get(high))} << 16;
      }
      break;
    default:
      value = static_cast<std::uint32_t>(operand.value);
  }
  return width == 32 ? static_cast<std::int32_t>(value) : static_cast<std::int16_t>(value);
}

void Reference::write_word(const Operand& operand, std::uint64_t value, int width) {
  if (operand.kind == Operand::Kind::Digits) {
    for (const Device bit : digit_bits(operand)) {
      write(bit, static_cast<std::int16_t>(value & 1));
      value >>= 1;
    }
    return;
  }
  for (const Device word : words_of(operand.device, width, program_.dialect)) {
    write(word, static_cast<std::int16_t>(value));
    value >>= 16;
  }
}

void Reference::fail() {
  for (const Device relay : errors_) change(relay, 1);
}

}  // namespace rung
