// SPDX-License-Identifier: Apache-2.0
// LDmicro: the elements that use peripherals, and the peripherals as LDmicro's simulator has them.
#include "reference/reference.hpp"
#include "rungs/ports.hpp"

namespace rung {

void Reference::execute_peripheral(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::ReadAdc: {
      const int channel = instruction.operand(1).value;
      if (now_.result) change(instruction.operand(0).device, get(port::at(port::adc, channel)));
      return;
    }
    case Op::SetPwm:
      if (now_.result) set_pwm(instruction);
      return;
    case Op::Persist:
      if (now_.result) persist(instruction);
      return;
    case Op::UartSend:
      if (now_.result && transmitter_free()) transmit(variable_of(instruction.operand(0)));
      now_.result = !transmitter_free();
      return;
    case Op::UartRecv:
      now_.result = now_.result && get(port::uart_rx_full) != 0;
      if (!now_.result) return;
      set(port::uart_rx_full, 0);
      return change(instruction.operand(0).device, get(port::uart_rx_data));
    case Op::FormattedString:
      return send_string(instruction);
    default:
      return;
  }
}

void Reference::set_pwm(const Instruction& instruction) {
  set(port::pwm_duty, variable_of(instruction.operand(0)));
  if (get(port::pwm_hz_low) != 0 || get(port::pwm_hz_high) != 0) return;
  const auto hz = static_cast<std::uint32_t>(instruction.operand(1).value);
  set(port::pwm_hz_low, static_cast<std::int16_t>(hz));
  set(port::pwm_hz_high, static_cast<std::int16_t>(hz >> 16));
}

void Reference::persist(const Instruction& instruction) {
  if (get(port::persist_ready) == 0) return;
  const Device variable = instruction.operand(0).device;
  const Device kept = port::at(port::persist_value, instruction.operand(1).value);
  if (!exchange_memory(true)) return change(variable, get(kept));
  if (get(variable) == get(kept)) return;
  set(kept, get(variable));
  set(port::persist_index, static_cast<std::int16_t>(instruction.operand(1).value));
  set(port::persist_ready, 0);
}

// It is busy in the scan in which it is given a byte, and in the next one.
bool Reference::transmitter_free() const { return !sent_scan_ || time_.scan - *sent_scan_ >= 2; }

void Reference::transmit(int byte) {
  sent_.push_back(byte & 0xFF);
  sent_scan_ = time_.scan;
}

void Reference::send_string(const Instruction& instruction) {
  Message& message = messages_.at(current_);
  if (rises()) message.next = 0;
  if (message.next < message.steps.size() && transmitter_free()) {
    const std::int16_t variable =
        instruction.operands.empty() ? std::int16_t{0} : variable_of(instruction.operand(0));
    transmit(next_byte(message, variable));
  }
  now_.result = message.next < message.steps.size();
}

int Reference::next_byte(Message& message, std::int16_t variable) {
  const std::size_t at = message.next++;
  const StringStep& step = message.steps[at];
  if (step.kind == StringStep::Kind::Byte) return step.value;
  // The number is taken once, so that its digits belong together.
  if (at == 0 || message.steps[at - 1].kind == StringStep::Kind::Byte) {
    message.left = variable;
    message.significant = false;
  }
  if (step.kind == StringStep::Kind::Sign) {
    if (variable >= 0) return ' ';
    message.left = static_cast<std::int16_t>(-variable);
    return '-';
  }
  const int digit = message.left / step.value;
  message.left = static_cast<std::int16_t>(message.left - digit * step.value);
  message.significant = message.significant || digit != 0 || step.last;
  return message.significant ? ('0' + digit) & 0xFF : ' ';
}

}  // namespace rung
