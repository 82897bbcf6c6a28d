// SPDX-License-Identifier: Apache-2.0
// Elements that meet the peripherals, through the device ports (rungs/ports.hpp): READ_ADC SET_PWM
// PERSIST UART_SEND UART_RECV FORMATTED_STRING.
#include "backends/c_instructions.hpp"
#include "rungs/format_string.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

using Step = StringStep::Kind;

void set_pwm(CUnit& unit, const Instruction& instruction, const std::string& s) {
  const auto hertz = static_cast<std::uint32_t>(instruction.operand(1).value);
  const auto word = [](std::uint32_t bits) {
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(bits));
  };
  unit.body.open("if ({}) {{", s);
  unit.body.line("@.pwm_duty = {};", COperands(unit, instruction).value(0, 16));
  unit.body.open("if (@.pwm_hz_low == 0 && @.pwm_hz_high == 0) {{");
  unit.body.line("@.pwm_hz_low = {};", word(hertz));
  unit.body.line("@.pwm_hz_high = {};", word(hertz >> 16));
  unit.body.close();
  unit.body.close();
}

void persist(CUnit& unit, const Instruction& instruction, const std::string& s) {
  const std::string value = unit.layout.place(instruction.operand(0).device);
  const std::int32_t number = instruction.operand(1).value;
  const std::string kept = unit.layout.place(port::at(port::persist_value, number));
  unit.body.open("if ({} & @.persist_ready) {{", s);
  unit.body.line("if (!{0}) {1} = {2};", unit.edge(instruction), value, kept);
  unit.body.line("{} = 1;", unit.edge(instruction));
  unit.body.open("if ({} != {}) {{", value, kept);
  unit.body.line("{} = {};", kept, value);
  unit.body.line("@.persist_index = {};", number);
  unit.body.line("@.persist_ready = 0;");
  unit.body.close();
  unit.body.close();
}

void send(CUnit& unit, const Instruction& instruction, const std::string& s) {
  unit.body.open("if ({} & @.uart_tx_ready) {{", s);
  unit.body.line("@.uart_tx_data = (int16_t)({} & 0xFF);",
                 COperands(unit, instruction).value(0, 16));
  unit.body.line("@.uart_tx_ready = 0;");
  unit.body.close();
  unit.body.line("{} = @.uart_tx_ready ^ 1u;", s);
}

void receive(CUnit& unit, const Instruction& instruction, const std::string& s) {
  unit.body.line("{} &= @.uart_rx_full;", s);
  unit.body.open("if ({}) {{", s);
  unit.body.line("{} = @.uart_rx_data;", unit.layout.place(instruction.operand(0).device));
  unit.body.line("@.uart_rx_full = 0;");
  unit.body.close();
}

// The steps that are no byte that is known now, as cases of a switch.
void number_steps(CUnit& unit, const Instruction& instruction, const std::vector<StringStep>& steps,
                  int number) {
  const std::string value = unit.layout.place(instruction.operand(0).device);
  const std::string kept = fmt::format("@.string_kept[{}]", number);
  const std::string seen = fmt::format("@.string_seen[{}]", number);
  bool first = true;
  CSource& body = unit.body;
  body.open("switch (@.string_step[{}]) {{", number);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].kind == Step::Byte) continue;
    body.line("case {}:", i);
    // From here on the variable may change without harm.
    if (first && steps[i].kind == Step::Sign) {
      body.line("  {0} = {1} < 0 ? {2}(0u - (uint32_t){1}) : {1};", kept, value,
                unit.helpers.use(CHelper::Word));
    } else if (first) {
      body.line("  {} = {};", kept, value);
    }
    if (first) body.line("  {} = 0;", seen);
    first = false;
    if (steps[i].kind == Step::Sign) {
      body.line("  byte = {} < 0 ? 45 : 32;", value);
    } else {
      body.line("  byte = {}(&{}, &{}, {}, {});", unit.helpers.use(CHelper::Digit), kept, seen,
                steps[i].value, steps[i].last ? 1 : 0);
    }
    body.line("  break;");
  }
  body.line("default:");
  body.line("  break;");
  body.close();
}

void string(CUnit& unit, const Instruction& instruction, const std::string& s) {
  const std::vector<StringStep> steps = string_steps(instruction.table);
  if (steps.empty()) return unit.body.line("{} = 0;", s);
  const int number = unit.strings++;
  const std::string step = fmt::format("@.string_step[{}]", number);
  unit.body.line("if ({}(&{}, {})) {} = 0;", unit.helpers.use(CHelper::Rise),
                 unit.edge(instruction), s, step);
  unit.body.open("if ({} < {}u && @.uart_tx_ready) {{", step, steps.size());
  std::string bytes;
  bool plain = true;
  for (const StringStep& each : steps) {
    plain = plain && each.kind == Step::Byte;
    bytes +=
        fmt::format("{}{}", bytes.empty() ? "" : ", ", each.kind == Step::Byte ? each.value : 0);
  }
  unit.body.line("static const uint8_t text[] = {{{}}};", bytes);
  unit.body.line("{}uint8_t byte = text[{}];", plain ? "const " : "", step);
  if (!plain) number_steps(unit, instruction, steps, number);
  unit.body.line("@.uart_tx_data = byte;");
  unit.body.line("@.uart_tx_ready = 0;");
  unit.body.line("++{};", step);
  unit.body.close();
  unit.body.line("{} = {} < {}u;", s, step, steps.size());
}

}  // namespace

bool write_peripherals(CUnit& unit, const Instruction& instruction, const std::string& s) {
  switch (instruction.op) {
    case Op::ReadAdc:
      unit.body.line("if ({}) {} = {};", s, unit.layout.place(instruction.operand(0).device),
                     unit.layout.place(port::at(port::adc, instruction.operand(1).value)));
      return true;
    case Op::SetPwm:
      set_pwm(unit, instruction, s);
      return true;
    case Op::Persist:
      persist(unit, instruction, s);
      return true;
    case Op::UartSend:
      send(unit, instruction, s);
      return true;
    case Op::UartRecv:
      receive(unit, instruction, s);
      return true;
    case Op::FormattedString:
      string(unit, instruction, s);
      return true;
    default:
      return false;
  }
}

}  // namespace rung
