// SPDX-License-Identifier: Apache-2.0
// Elements that meet the controller's peripherals, through device ports (hdl/isa/ports.toml).
#include <algorithm>

#include "lower/elements.hpp"

namespace rung::lower {
namespace {

// All SET_PWM of the program ask for the same frequency.
bool one_frequency(const Program& program) {
  const std::int32_t* first = nullptr;
  return std::all_of(program.instructions.begin(), program.instructions.end(),
                     [&](const Instruction& instruction) {
                       if (instruction.op != Op::SetPwm) return true;
                       const std::int32_t& hertz = instruction.operand(1).value;
                       if (first == nullptr) first = &hertz;
                       return hertz == *first;
                     });
}

}  // namespace

// Where the program knows several frequencies, the first SET_PWM that is executed decides.
void Elements::pwm() {
  const std::int32_t hertz = source().operand(1).value;
  const WordSource low = constant(hertz & 0xFFFF);
  const WordSource high = constant(hertz >> 16);
  gated(Core::Mov, {port::pwm_duty}, {value(0)});
  if (flow_ == Flow::Off) return;
  if (one_frequency(context_.program())) {
    gated(Core::Mov, {port::pwm_hz_low}, {low});
    if (high.value != 0) gated(Core::Mov, {port::pwm_hz_high}, {high});
    return;
  }
  if (!pwm_started_) pwm_started_ = context_.fresh_bit();
  const Flow flow = flow_;
  materialise();
  context_.block(Core::Mps);
  contact(*pwm_started_, true);
  gated(Core::Mov, {port::pwm_hz_low}, {low});
  gated(Core::Mov, {port::pwm_hz_high}, {high});
  coil(Core::Set, *pwm_started_);
  context_.block(Core::Mpp);
  if (flow != Flow::Result) replace(flow);
}

void Elements::persist() {
  if (flow_ == Flow::Off) return;
  const Device kept = variable();
  const Device value_kept = port::at(port::persist_value, source().operand(1).value);
  const Device restored = context_.memory();
  const Flow flow = flow_;
  materialise();
  context_.block(Core::Mps);
  contact(port::persist_ready, false);
  context_.block(Core::Mps);
  contact(restored, true);
  gated(Core::Mov, {kept}, {word(value_kept)});
  context_.block(Core::Mpp);
  coil(Core::Set, restored);
  const Device same =
      test_equal(context_, {word(kept), constant(0)}, {word(value_kept), constant(0)}, 16);
  contact(same, true);
  gated(Core::Mov, {value_kept}, {word(kept)});
  gated(Core::Mov, {port::persist_index}, {constant(source().operand(1).value)});
  coil(Core::Rst, port::persist_ready);
  context_.block(Core::Mpp);
  if (flow != Flow::Result) replace(flow);
}

void Elements::send(bool used) {
  if (flow_ != Flow::Off) {
    contact(port::uart_tx_ready, false);
    gated(Core::Mov, {port::uart_tx_data}, {word(variable())});
    coil(Core::Rst, port::uart_tx_ready);
  }
  if (used) replace(port::uart_tx_ready, true);
}

void Elements::receive() {
  contact(port::uart_rx_full, false);
  gated(Core::Mov, {variable()}, {word(port::uart_rx_data)});
  coil(Core::Rst, port::uart_rx_full);
}

}  // namespace rung::lower
