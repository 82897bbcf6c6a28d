// SPDX-License-Identifier: Apache-2.0
// Timers and counters.
#include "backends/c_instructions.hpp"
#include "rungs/devices.hpp"

namespace rung {
namespace {

// `&plc.TS[5], &plc.TN[5]`, of a 32-bit counter three.
std::string pointers(const CUnit& unit, Device contact) {
  const Device value = value_of(contact);
  std::string text = fmt::format("&{}, &{}", unit.layout.place(contact), unit.layout.place(value));
  if (is_32_bit_counter(contact, unit.program.dialect)) {
    text += ", &" + unit.layout.place(high_word(value, unit.program.dialect));
  }
  return text;
}

std::string state(CUnit& unit, Device contact) {
  unit.stateful.insert(contact.kind);
  return fmt::format("@.{}_state[{}]", CLayout::array(contact.kind), unit.layout.number(contact));
}

void out_timer(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  const COperands operands(unit, instruction);
  const Device contact = instruction.operand(0).device;
  unit.timers.insert(contact);
  unit.tick_bases.insert(instruction.base_us);
  const Operand& preset = instruction.operand(1);
  unit.body.line("{}({}, &{}, {}, {}, @.{}, {});", unit.helpers.use(CHelper::Timer),
                 pointers(unit, contact), state(unit, contact), condition.cond,
                 preset.kind == Operand::Kind::Constant
                     ? fmt::format("{}u", static_cast<std::uint16_t>(preset.value))
                     : "(uint16_t)" + operands.value(1, 16),
                 time_name("ticks", instruction.base_us),
                 timer_range(contact, unit.program.dialect).retentive ? 1 : 0);
}

void out_counter(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  const COperands operands(unit, instruction);
  const Device contact = instruction.operand(0).device;
  const bool wide = is_32_bit_counter(contact, unit.program.dialect);
  std::string down;
  if (wide) {
    const auto directions = devices_of_role(SpecialRole::Direction, unit.program.dialect);
    const Device relay = directions.at(contact.number - 200);
    down = unit.layout.names(relay) ? ", " + unit.layout.place(relay) : ", 0";
  }
  unit.body.line("{}({}, &{}, {}, {}{});",
                 unit.helpers.use(wide ? CHelper::DoubleCounter : CHelper::Counter),
                 pointers(unit, contact), state(unit, contact), condition.cond,
                 operands.value(1, wide ? 32 : 16), down);
}

void reset(CUnit& unit, Device contact, const CCondition& condition) {
  if (is_counter(contact.kind)) {
    const std::string held = state(unit, contact);
    unit.body.line("{0} = (uint8_t)(({0} & 1u) | ({1}) << 1);", held, condition.cond);
  }
  unit.body.open("if ({}) {{", bare(condition.executed));
  unit.body.line("{} = 0;", unit.layout.place(contact));
  const Device value = value_of(contact);
  unit.body.line("{} = 0;", unit.layout.place(value));
  if (is_32_bit_counter(contact, unit.program.dialect)) {
    unit.body.line("{} = 0;", unit.layout.place(high_word(value, unit.program.dialect)));
  }
  unit.body.close();
}

}  // namespace

bool write_timers_counters(CUnit& unit, const Instruction& instruction,
                           const CCondition& condition) {
  switch (instruction.op) {
    case Op::OutT:
      out_timer(unit, instruction, condition);
      return true;
    case Op::OutC:
      out_counter(unit, instruction, condition);
      return true;
    case Op::Rst: {
      const Device contact = instruction.operand(0).device;
      const bool timed = contact.kind == DeviceKind::TS || contact.kind == DeviceKind::STS ||
                         contact.kind == DeviceKind::CS;
      if (!timed || instruction.operand(0).kind != Operand::Kind::Device) return false;
      reset(unit, contact, condition);
      return true;
    }
    default:
      return false;
  }
}

}  // namespace rung
