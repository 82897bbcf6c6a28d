// SPDX-License-Identifier: Apache-2.0
// Outputs on bits.
#include "backends/c_instructions.hpp"
#include "rungs/footprint.hpp"

namespace rung {
namespace {

void statement(CUnit& unit, const COperands& operands, std::string_view guard,
               const std::string& text) {
  if (!operands.indexed()) {
    return unit.body.line("{}{}", guard.empty() ? "" : fmt::format("if ({}) ", bare(guard)), text);
  }
  write_guarded(unit, operands, guard, [&] { unit.body.code(text); });
}

// SET or OUT of a state in the zone of another: that one has to go.
void transition(CUnit& unit, const COperands& operands, const CCondition& condition) {
  write_guarded(unit, operands, condition.executed, [&] {
    unit.body.code(operands.set_bit(0, "1"));
    for (const Device state : condition.states) {
      unit.body.line("@.S_left[{}] = 1;", unit.layout.number(state));
    }
  });
}

void pulse_output(CUnit& unit, const Instruction& instruction, const COperands& operands,
                  const CCondition& condition) {
  const std::string edge = unit.edge(instruction);
  unit.body.code(operands.set_bit(0, instruction.op == Op::Pls
                                         ? fmt::format("{} & ({} ^ 1u)", condition.cond, edge)
                                         : fmt::format("({} ^ 1u) & {}", condition.cond, edge)));
  unit.body.line("{} = (uint8_t)({});", edge, bare(condition.cond));
}

void shift_one(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  const Device bit = instruction.operand(0).device;
  unit.body.open("if ({}) {{", bare(condition.executed));
  if (bit.number == 0) {
    unit.body.line("{} = 0;", unit.layout.place(bit));
  } else {
    const std::string before = unit.layout.place({bit.kind, bit.number - 1});
    unit.body.line("{} = {};", unit.layout.place(bit), before);
    unit.body.line("{} = 0;", before);
  }
  unit.body.close();
}

}  // namespace

bool write_bits(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  const COperands operands(unit, instruction);
  const auto is_transition = [&] {
    return !condition.states.empty() && instruction.operand(0).kind == Operand::Kind::Device &&
           instruction.operand(0).device.kind == DeviceKind::S;
  };
  switch (instruction.op) {
    case Op::Out:
      if (is_transition()) {
        transition(unit, operands, condition);
      } else {
        statement(unit, operands, "", operands.set_bit(0, condition.cond));
      }
      return true;
    case Op::Outi:
      statement(
          unit, operands, "",
          operands.set_bit(0, fmt::format("({} ^ 1u){}", condition.result,
                                          condition.power.empty() ? "" : " & " + condition.power)));
      return true;
    case Op::Set:
      if (is_transition()) {
        transition(unit, operands, condition);
      } else {
        statement(unit, operands, condition.executed, operands.set_bit(0, "1"));
      }
      return true;
    case Op::Rst:
      statement(unit, operands, condition.executed, operands.set_bit(0, "0"));
      return true;
    case Op::Pls:
    case Op::Plf:
      pulse_output(unit, instruction, operands, condition);
      return true;
    case Op::Alt:
      statement(unit, operands, condition.executed, operands.set_bit(0, operands.bit(0) + " ^ 1u"));
      return true;
    case Op::Sft:
      shift_one(unit, instruction, condition);
      return true;
    default:
      return false;
  }
}

void write_guarded(CUnit& unit, const COperands& operands, std::string_view guard,
                   const std::function<void()>& lines) {
  if (guard.empty()) {
    unit.body.open("{{");
  } else {
    unit.body.open("if ({}) {{", bare(guard));
  }
  if (operands.indexed()) {
    operands.declare_indices();
    unit.body.open("if ({}) {{", operands.any_outside());
    unit.body.line("{}();", unit.helpers.use(CHelper::Fault));
    unit.body.otherwise();
    lines();
    unit.body.close();
  } else {
    lines();
  }
  unit.body.close();
}

void write_flag(CUnit& unit, SpecialRole role, std::string_view value) {
  for (const Device flag : unit.layout.of_role(role)) {
    unit.body.line("{} = (uint8_t)({});", unit.layout.place(flag), value);
  }
}

}  // namespace rung
