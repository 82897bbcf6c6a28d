// SPDX-License-Identifier: Apache-2.0
// ADD SUB MUL DIV.
#include "backends/c_instructions.hpp"

namespace rung {
namespace {

void add(CUnit& unit, const Instruction& instruction, const COperands& operands) {
  const bool wide = instruction.width == 32;
  const char sign = instruction.op == Op::Add ? '+' : '-';
  unit.body.line("const uint32_t v = (uint32_t)a {} (uint32_t)b;", sign);
  operands.store(2, instruction.width, "v");
  // q has no such flags: its carry is that of rotates and shifts.
  if (unit.program.dialect != Dialect::Fx) return;
  const bool ranges = !unit.layout.of_role(SpecialRole::Borrow).empty() ||
                      !unit.layout.of_role(SpecialRole::Carry).empty();
  write_flag(unit, SpecialRole::Zero, wide ? "v == 0" : "(v & 0xFFFFu) == 0");
  if (!ranges) return;
  unit.body.open("{{");
  unit.body.line("const int64_t exact = (int64_t)a {} b;", sign);
  write_flag(unit, SpecialRole::Borrow, wide ? "exact < INT32_MIN" : "exact < INT16_MIN");
  write_flag(unit, SpecialRole::Carry, wide ? "exact > INT32_MAX" : "exact > INT16_MAX");
  unit.body.close();
}

void multiply(CUnit& unit, const Instruction& instruction, const COperands& operands) {
  const bool wide = instruction.width == 32;
  unit.body.code(wide ? "const uint64_t v = (uint64_t)((int64_t)a * b);"
                      : "const uint32_t v = (uint32_t)(a * b);");
  operands.store(2, instruction.double_width ? 2 * instruction.width : instruction.width, "v");
}

// 64 bits, as -2147483648 / -1 has no value of 32.
void divide(CUnit& unit, const Instruction& instruction, const COperands& operands) {
  const bool wide = instruction.width == 32;
  unit.body.open("if (b == 0) {{");
  unit.body.line("@.divided = 1;");
  if (!unit.is_ldmicro()) unit.body.line("{}();", unit.helpers.use(CHelper::Fault));
  unit.body.otherwise();
  const std::string quotient = wide ? "(uint32_t)((int64_t)a / b)" : "(uint32_t)(a / b)";
  const std::string rest = wide ? "(uint32_t)((int64_t)a % b)" : "(uint32_t)(a % b)";
  if (!instruction.double_width) {
    unit.body.line("const uint32_t v = {};", quotient);
    operands.store(2, instruction.width, "v");
  } else if (wide) {
    unit.body.line("const uint64_t v = (uint64_t){} << 32 | {};", rest, quotient);
    operands.store(2, 64, "v");
  } else {
    unit.body.line("const uint32_t v = {} << 16 | ({} & 0xFFFFu);", rest, quotient);
    operands.store(2, 32, "v");
  }
  unit.body.close();
}

}  // namespace

bool write_arithmetic(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  if (instruction.op < Op::Add || instruction.op > Op::Div) return false;
  const COperands operands(unit, instruction);
  write_guarded(unit, operands, condition.executed, [&] {
    unit.body.line("const int32_t a = {};", operands.value(0));
    unit.body.line("const int32_t b = {};", operands.value(1));
    if (instruction.op == Op::Mul) {
      multiply(unit, instruction, operands);
    } else if (instruction.op == Op::Div) {
      divide(unit, instruction, operands);
    } else {
      add(unit, instruction, operands);
    }
  });
  return true;
}

}  // namespace rung
