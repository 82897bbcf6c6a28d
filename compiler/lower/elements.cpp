// SPDX-License-Identifier: Apache-2.0
#include "lower/elements.hpp"

namespace rung::lower {

void Elements::execute(bool used) {
  switch (source().op) {
    case Op::And:
    case Op::Ani:
      return contact(source().operand(0).device, source().op == Op::Ani);
    case Op::AndCompare: {
      if (flow_ == Flow::Off) return;
      const Test test = compare_contact(context_);
      return contact(test.bit, test.inverted);
    }
    case Op::Open:
      return replace(Flow::Off);
    case Op::Out:
    case Op::Outi:
      return out(source().op == Op::Outi);
    case Op::Set:
    case Op::Rst:
      return coil(source().op == Op::Set ? Core::Set : Core::Rst, source().operand(0).device);
    case Op::Osr:
    case Op::Osf:
      return one_shot(source().op == Op::Osr);
    case Op::MasterRelay:
      return master_relay();
    case Op::Ton:
      return on_delay();
    case Op::Tof:
      return off_delay();
    case Op::Rto:
      return retentive(used);
    case Op::Ctu:
    case Op::Ctd:
      return count(used);
    case Op::Ctc:
      return circular();
    case Op::Res:
      return gated(Core::Mov, {variable()}, {constant(0)});
    case Op::Mov:
      return gated(Core::Mov, {variable(1)}, {value(0)}, false);
    case Op::Add:
    case Op::Sub:
    case Op::Mul:
    case Op::Div:
      return arithmetic();
    case Op::ShiftRegister:
      return shift_register();
    case Op::LookUpTable:
      return look_up();
    case Op::PiecewiseLinear:
      return piecewise();
    case Op::ReadAdc:
      return gated(Core::Mov, {variable()}, {word(port::at(port::adc, source().operand(1).value))});
    case Op::SetPwm:
      return pwm();
    case Op::Persist:
      return persist();
    case Op::UartSend:
      return send(used);
    case Op::UartRecv:
      return receive();
    case Op::FormattedString:
      return formatted_string(used);
    default:
      return;  // Short, Comment: the condition goes on as it is
  }
}

void Elements::finish() {
  if (!started_) return;
  context_.begin_network();
  flow_ = Flow::On;
  coil(Core::Set, *started_);
  context_.end_network();
}

void Elements::contact(Device bit, bool inverted) {
  if (flow_ == Flow::Off) return;
  if (flow_ == Flow::On) {
    context_.contact(inverted ? Core::Ldi : Core::Ld, bit);
  } else {
    context_.contact(inverted ? Core::Ani : Core::And, bit);
  }
  flow_ = Flow::Result;
}

void Elements::materialise() {
  if (flow_ == Flow::Result) return;
  context_.contact(flow_ == Flow::On ? Core::Ldi : Core::Ld, zero());
  flow_ = Flow::Result;
}

void Elements::replace(Device bit, bool inverted) {
  replace(Flow::On);
  contact(bit, inverted);
}

void Elements::replace(Flow constant) {
  if (flow_ == Flow::Result) context_.block(Core::Pop);
  flow_ = constant;
}

WordSource Elements::value(std::size_t operand) const {
  const Operand& from = source().operand(operand);
  return from.kind == Operand::Kind::Device ? word(from.device) : constant(from.value);
}

Device Elements::variable(std::size_t operand) const { return source().operand(operand).device; }

void Elements::gated(Core op, std::initializer_list<Device> targets,
                     std::initializer_list<WordSource> sources, bool quiet) {
  if (flow_ == Flow::Off) return;
  core::Instruction instruction;
  instruction.op = op;
  instruction.targets = targets;
  instruction.sources = sources;
  instruction.quiet = quiet;
  instruction.always = flow_ == Flow::On;
  context_.emit(std::move(instruction));
}

void Elements::coil(Core op, Device bit) { gated(op, {bit}, {}, false); }

void Elements::gated_by(Device bit, bool inverted, Core op, std::initializer_list<Device> targets,
                        std::initializer_list<WordSource> sources) {
  context_.contact(inverted ? Core::Ldi : Core::Ld, bit);
  context_.gated(op, targets, sources, true);
  context_.block(Core::Pop);
}

Device Elements::less(const WordSource& a, const WordSource& b) {
  return test_less(context_, {a, constant(0)}, {b, constant(0)}, 16);
}

Device Elements::equal(const WordSource& a, std::int32_t number) {
  return test_equal(context_, {a, constant(0)}, {constant(number), constant(0)}, 16);
}

Device Elements::zero() {
  if (!zero_) zero_ = context_.fresh_bit();
  return *zero_;
}

// A constant condition makes a set or reset coil of it that always runs.
void Elements::out(bool inverted) {
  const Device bit = variable();
  if (flow_ == Flow::Result) {
    if (inverted) context_.block(Core::Inv);
    context_.coil(Core::Out, bit);
    if (inverted) context_.block(Core::Inv);
    return;
  }
  const Flow flow = std::exchange(flow_, Flow::On);
  coil((flow == Flow::On) != inverted ? Core::Set : Core::Rst, bit);
  flow_ = flow;
}

// The first one of a scan finds the relay at 1 and passes its condition on; at each further one it
// becomes NOT relay OR condition.
void Elements::master_relay() {
  const bool first = !master_;
  if (first) master_ = context_.fresh_bit();
  const Flow flow = flow_;
  materialise();
  context_.block(Core::Mps);
  if (!first) context_.contact(Core::Ori, *master_);
  context_.coil(Core::Out, *master_);
  context_.block(Core::Mpp);
  if (flow != Flow::Result) replace(flow);
}

void Elements::one_shot(bool rising) {
  const Device memory = context_.memory();
  const Device now = context_.temporary_bit();
  materialise();
  context_.coil(Core::Out, now);
  if (!rising) context_.block(Core::Inv);
  context_.contact(rising ? Core::Ani : Core::And, memory);
  context_.compute(memory, {{now, false}});
}

}  // namespace rung::lower
