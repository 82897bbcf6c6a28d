// SPDX-License-Identifier: Apache-2.0
// Shifts along devices.
#include "backends/c_instructions.hpp"

namespace rung {
namespace {

std::uint32_t count_of(const Operand& operand) { return static_cast<std::uint32_t>(operand.value); }

// Shifts `length` bits or words by `count`; what moves in is in the array `source`.
void shift(CUnit& unit, Device target, std::uint32_t length, std::uint32_t count, bool up) {
  const CHelper helper = is_word(target) ? (up ? CHelper::RiseWords : CHelper::FallWords)
                                         : (up ? CHelper::RiseBits : CHelper::FallBits);
  unit.body.line("{}({}, source, {}u, {}u);", unit.helpers.use(helper), unit.layout.pointer(target),
                 length, count);
}

// SFTL SFTR WSFL WSFR.
void shift_in(CUnit& unit, const Instruction& instruction, const CCondition& condition, bool up) {
  const Device source = instruction.operand(0).device;
  const std::uint32_t length = count_of(instruction.operand(2));
  const std::uint32_t count = count_of(instruction.operand(3));
  // C has no arrays of no elements.
  if (count == 0) return;
  unit.body.open("if ({}) {{", bare(condition.executed));
  unit.body.line("const {} *const first = {};", CLayout::type(source.kind),
                 unit.layout.pointer(source));
  unit.body.line("{} source[{}];", CLayout::type(source.kind), count);
  unit.body.line("uint32_t i;");
  unit.body.line("for (i = 0; i < {}u; ++i) source[i] = first[i];", count);
  shift(unit, instruction.operand(1).device, length, count, up);
  unit.body.close();
}

// BSFL BSFR DSFL DSFR: by one, 0 moves in; of bits the carry takes what moves out.
void shift_by_one(CUnit& unit, const Instruction& instruction, const CCondition& condition,
                  bool up) {
  const Device target = instruction.operand(0).device;
  const std::uint32_t length = count_of(instruction.operand(1));
  if (length == 0) return;
  const bool carry = !is_word(target) && !unit.layout.of_role(SpecialRole::Carry).empty();
  unit.body.open("if ({}) {{", bare(condition.executed));
  unit.body.line("static const {} source[1] = {{0}};", CLayout::type(target.kind));
  if (carry) {
    const Device last{target.kind, target.number + (up ? length - 1 : 0)};
    unit.body.line("const uint8_t left = {};", unit.layout.place(last));
  }
  shift(unit, target, length, 1, up);
  if (carry) write_flag(unit, SpecialRole::Carry, "left");
  unit.body.close();
}

}  // namespace

bool write_shifts(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  switch (instruction.op) {
    case Op::Sftl:
    case Op::Wsfl:
      shift_in(unit, instruction, condition, true);
      return true;
    case Op::Sftr:
    case Op::Wsfr:
      shift_in(unit, instruction, condition, false);
      return true;
    case Op::Bsfl:
    case Op::Dsfl:
      shift_by_one(unit, instruction, condition, true);
      return true;
    case Op::Bsfr:
    case Op::Dsfr:
      shift_by_one(unit, instruction, condition, false);
      return true;
    default:
      return false;
  }
}

}  // namespace rung
