// SPDX-License-Identifier: Apache-2.0
// SHIFT_REGISTER, LOOK_UP_TABLE, PIECEWISE_LINEAR.
#include "backends/c_instructions.hpp"

namespace rung {
namespace {

// The table as a constant of the innermost block.
void constants(CUnit& unit, const Instruction& instruction, std::string_view name) {
  constexpr std::size_t kPerLine = 12;
  const std::vector<std::int32_t>& table = instruction.table;
  unit.body.open("static const int16_t {}[] = {{", name);
  for (std::size_t i = 0; i < table.size(); i += kPerLine) {
    const std::size_t end = std::min(i + kPerLine, table.size());
    std::string line;
    for (std::size_t j = i; j < end; ++j) {
      line += fmt::format("{}{},", j == i ? "" : " ", table[j]);
    }
    unit.body.line("{}", line);
  }
  unit.body.close("};");
}

void shift(CUnit& unit, const Instruction& instruction, const std::string& s) {
  unit.body.open("if ({}(&{}, {})) {{", unit.helpers.use(CHelper::Rise), unit.edge(instruction), s);
  for (std::size_t i = instruction.operands.size(); i-- > 1;) {
    unit.body.line("{} = {};", unit.layout.place(instruction.operand(i).device),
                   unit.layout.place(instruction.operand(i - 1).device));
  }
  unit.body.close();
}

void look_up(CUnit& unit, const Instruction& instruction, const std::string& s) {
  if (instruction.table.empty()) return;
  const COperands operands(unit, instruction);
  const std::string target = operands.place(0);
  const std::string index = operands.value(1, 16);
  const std::size_t count = instruction.table.size();
  unit.body.open("if ({}) {{", s);
  constants(unit, instruction, "rows");
  if (index == target) {
    unit.body.line("{0} = {1}(rows, {2}, {0});", target, unit.helpers.use(CHelper::LookUpOwn),
                   count);
  } else {
    unit.body.line("{0} = {1}(rows, {2}, {3}, {0});", target, unit.helpers.use(CHelper::LookUp),
                   count, index);
  }
  unit.body.close();
}

void piecewise(CUnit& unit, const Instruction& instruction, const std::string& s) {
  const std::size_t count = instruction.table.size() / 2;
  if (count < 2) return;
  const COperands operands(unit, instruction);
  const std::string target = operands.place(0);
  const std::string index = operands.value(1, 16);
  unit.body.open("if ({}) {{", s);
  constants(unit, instruction, "points");
  unit.body.line("{0} = {1}(points, {2}, {3}, {0}, {4});", target,
                 unit.helpers.use(CHelper::Piecewise), count, index, index == target ? 1 : 0);
  unit.body.close();
}

}  // namespace

bool write_tables(CUnit& unit, const Instruction& instruction, const std::string& s) {
  switch (instruction.op) {
    case Op::ShiftRegister:
      shift(unit, instruction, s);
      return true;
    case Op::LookUpTable:
      look_up(unit, instruction, s);
      return true;
    case Op::PiecewiseLinear:
      piecewise(unit, instruction, s);
      return true;
    default:
      return false;
  }
}

}  // namespace rung
