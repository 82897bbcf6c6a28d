// SPDX-License-Identifier: Apache-2.0
#include "melsec/ranges.hpp"

#include <fmt/format.h>

#include "rungs/devices.hpp"
#include "rungs/special.hpp"

namespace rung {
namespace {

using Kind = Operand::Kind;

// How many elements, of how many bits if they are words, operand `i` takes.
struct Extent {
  int elements = 1;
  int width = 16;
};

Extent extent_of(const Instruction& instruction, std::size_t i) {
  const auto count = [&](std::size_t at) { return instruction.operand(at).value; };
  const int width = instruction.width;
  switch (instruction.op) {
    case Op::Sftl:
    case Op::Sftr:
    case Op::Wsfl:
    case Op::Wsfr:
      return {count(i == 0 ? 3 : 2), 16};
    case Op::Bsfl:
    case Op::Bsfr:
    case Op::Dsfl:
    case Op::Dsfr:
      return {count(1), 16};
    case Op::Bmov:
      return {count(2), width};
    case Op::Fmov:
      return {i == 1 ? count(2) : 1, width};
    case Op::Mul:
    case Op::Div:
      return {1, i == 2 && instruction.double_width ? 2 * width : width};
    case Op::Cmp:
      return {i == 2 ? 3 : 1, width};
    case Op::Zcp:
      return {i == 3 ? 3 : 1, width};
    case Op::OutT:
      return {1, 16};
    default:
      return {1, width};
  }
}

// The number of the last device that the operand takes.
std::int64_t last_number(const Operand& operand, Extent extent) {
  const std::int64_t first = operand.device.number;
  if (operand.kind == Kind::Digits) return first + 4LL * operand.digits * extent.elements - 1;
  if (operand.kind == Kind::WordBit || !is_word(operand.device)) {
    return first + (operand.kind == Kind::WordBit ? 0 : extent.elements - 1);
  }
  return first + static_cast<std::int64_t>(extent.elements) * (extent.width / 16) - 1;
}

class RangeCheck {
 public:
  RangeCheck(const Instruction& instruction, const SourceInstruction& row,
             const std::vector<ListWord>& words, Dialect dialect, OperandReader& reader)
      : instruction_(instruction), row_(row), words_(words), dialect_(dialect), reader_(reader) {}

  bool check() {
    for (std::size_t i = 0; i < instruction_.operands.size(); ++i) {
      if (row_.roles[i] == Role::Count || row_.roles[i] == Role::Repeats) count(i);
    }
    if (!good_) return false;  // rows of such lengths would only repeat it
    for (std::size_t i = 0; i < instruction_.operands.size(); ++i) extent(i);
    preset();
    neighbours();
    return good_;
  }

 private:
  const ListWord& word(std::size_t i) const {
    // Two operands written for three: the first of the three is the last that was written.
    const bool two = instruction_.two_operand;
    return words_[two ? (i == 1 ? 0 : 1) : i];
  }

  void error(std::size_t i, const std::string& what, const std::string& mend) {
    good_ = false;
    reader_.error(word(i), what, mend);
  }

  void count(std::size_t i) {
    const CountRange range = row_.roles[i] == Role::Repeats
                                 ? CountRange{1, INT16_MAX}
                                 : count_range(instruction_.op, instruction_.width, dialect_);
    const int value = instruction_.operand(i).value;
    if (value < range.least || value > range.most) {
      error(i, "a count that this instruction does not take",
            fmt::format("write K{} to K{}", range.least, range.most));
    } else if (i == 3 && value > instruction_.operand(2).value) {
      error(i,
            fmt::format("shifts by more than the {} that there are", instruction_.operand(2).value),
            "the last count may be at most the one before it");
    }
  }

  void extent(std::size_t i) {
    const Operand& operand = instruction_.operand(i);
    if (operand.kind == Kind::Constant || operand.kind == Kind::Number) return;
    if (instruction_.two_operand && i == 0) return;  // the target again
    const Device device = operand.device;
    // A 32-bit counter has its own high word.
    if (is_32_bit_counter(device, dialect_) && is_word(device)) return;
    if (find_special(device, dialect_) != nullptr) return;
    std::uint32_t end = device_range(device.kind, dialect_).last;
    const bool narrow_counter = device.kind == DeviceKind::CN && dialect_ == Dialect::Fx;
    if (narrow_counter) end = 199;
    const std::int64_t last = last_number(operand, extent_of(instruction_, i));
    if (last <= static_cast<std::int64_t>(end)) return;
    const std::int64_t head = static_cast<std::int64_t>(end) - (last - device.number);
    error(i,
          fmt::format("takes more devices than there are: the last one is {}",
                      source_name({device.kind, end}, dialect_)),
          head < 0 ? "there are not so many: write a smaller count"
                   : fmt::format(
                         "name {} or below",
                         source_name({device.kind, static_cast<std::uint32_t>(head)}, dialect_)));
  }

  void preset() {
    if (instruction_.op != Op::OutT && instruction_.op != Op::OutC) return;
    const Operand& preset = instruction_.operand(1);
    if (preset.kind != Kind::Constant || preset.value >= 0 || instruction_.width == 32) return;
    error(1, "a preset below 0", "write K1 to K32767");
  }

  void neighbours() {
    if (instruction_.op == Op::Sft && instruction_.operand(0).device.number == 0) {
      error(0, "takes the value of the bit before it, and there is none",
            "name a device with a number from 1 on");
    }
    if (instruction_.op != Op::Zrst) return;
    const Device first = instruction_.operand(0).device;
    const Device last = instruction_.operand(1).device;
    if (first.kind != last.kind) {
      error(1, "not of the kind that the first operand is", "reset each kind with its own ZRST");
    } else if (is_32_bit_counter(first, dialect_) != is_32_bit_counter(last, dialect_)) {
      error(1, "a counter of another width than the first", "reset each with its own ZRST");
    }
  }

  const Instruction& instruction_;
  const SourceInstruction& row_;
  const std::vector<ListWord>& words_;
  Dialect dialect_;
  OperandReader& reader_;
  bool good_ = true;
};

}  // namespace

bool check_ranges(const Instruction& instruction, const SourceInstruction& row,
                  const std::vector<ListWord>& words, Dialect dialect, OperandReader& reader) {
  return RangeCheck(instruction, row, words, dialect, reader).check();
}

}  // namespace rung
