// SPDX-License-Identifier: Apache-2.0
#include "lower/bits.hpp"

#include "lower/condition.hpp"
#include "lower/operands.hpp"
#include "lower/timers.hpp"
#include "rungs/devices.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;

// A state that is switched on in the zone of others leaves them (SEMANTICS.md, STL).
void leave_states(Context& context, Device target) {
  if (target.kind != DeviceKind::S) return;
  for (const Device state : context.states()) {
    context.coil(Core::Set, context.memory_of(state, Context::Role::Left));
  }
}

// Writes one bit of a word with a mask, under the current result.
void set_word_bit(Context& context, const Operand& operand) {
  context.gated(Core::Wor, {operand.device}, {word(operand.device), constant(1 << operand.bit)});
}
void clear_word_bit(Context& context, const Operand& operand) {
  context.gated(Core::Wand, {operand.device},
                {word(operand.device), constant(~(1 << operand.bit))});
}

void indexed_coil(Context& context, Core op, const Operand& operand, Device number) {
  core::Instruction instruction;
  instruction.op = op;
  instruction.head = context.window(operand.device.kind).front();
  instruction.sources = {word(number)};
  instruction.targets = context.window(operand.device.kind);
  context.emit(std::move(instruction));
}

void out_indexed(Context& context, const Operand& operand) {
  const Offset offset = index_offset(context, operand, 1);
  set_errors_beside(context, offset.inside);
  context.gate();
  context.block(Core::Mps);
  context.contact(Core::And, offset.inside);
  indexed_coil(context, Core::SetBit, operand, offset.number);
  context.block(Core::Mrd);
  context.block(Core::Inv);
  context.gate_live();
  context.contact(Core::And, offset.inside);
  indexed_coil(context, Core::RstBit, operand, offset.number);
  context.block(Core::Mpp);
}

void out_word_bit(Context& context, const Operand& operand) {
  context.gate();
  context.block(Core::Mps);
  set_word_bit(context, operand);
  context.block(Core::Mrd);
  context.block(Core::Inv);
  context.gate_live();
  clear_word_bit(context, operand);
  context.block(Core::Mpp);
}

void set_or_reset(Context& context, bool on) {
  const Operand& operand = context.source().operand(0);
  if (operand.kind == Operand::Kind::WordBit) {
    Execution execution(context, {});
    on ? set_word_bit(context, operand) : clear_word_bit(context, operand);
    return execution.end();
  }
  if (operand.index) {
    const Offset offset = index_offset(context, operand, 1);
    Execution execution(context, {{offset.inside}});
    if (is_word(operand.device)) {
      core::Instruction store;
      store.op = Core::StoreWord;
      store.head = context.window(operand.device.kind).front();
      store.sources = {word(offset.number), constant(0)};
      store.targets = context.window(operand.device.kind);
      context.emit(std::move(store));
    } else {
      indexed_coil(context, on ? Core::SetBit : Core::RstBit, operand, offset.number);
    }
    return execution.end();
  }
  const Device device = operand.device;
  if (!on && (is_timer(device.kind) || is_counter(device.kind))) return reset_timer(context);
  Execution execution(context, {});
  if (is_word(device)) {
    context.gated(Core::Mov, {device}, {constant(0)});
  } else {
    context.coil(on ? Core::Set : Core::Rst, device);
    if (on) leave_states(context, device);
  }
  execution.end();
}

void out(Context& context) {
  const Operand& operand = context.source().operand(0);
  if (operand.kind == Operand::Kind::WordBit) return out_word_bit(context, operand);
  if (operand.index) return out_indexed(context, operand);
  if (operand.device.kind == DeviceKind::S && !context.states().empty()) {
    // Within the zone of a state this is a transition, like SET.
    return set_or_reset(context, true);
  }
  context.gate();
  context.drive(operand.device);
}

// The result stays what it was: OUTI is the one output that writes something else.
void out_inverse(Context& context) {
  context.block(Core::Mps);
  context.block(Core::Inv);
  out(context);
  context.block(Core::Mpp);
}

void pulse_coil(Context& context, bool rising) {
  const Device memory = context.memory();
  context.gate();
  context.block(Core::Mps);
  if (!rising) context.block(Core::Inv);
  context.contact(rising ? Core::Ani : Core::And, memory);
  context.drive(context.source().operand(0).device);
  context.block(Core::Mpp);
  remember(context, memory);
}

void alternate(Context& context) {
  const Device bit = context.source().operand(0).device;
  const Device before = context.temporary_bit();
  context.compute(before, {{bit, false}});
  Execution execution(context, {});
  context.block(Core::Mps);
  context.contact(Core::Ani, before);
  context.coil(Core::Set, bit);
  context.block(Core::Mrd);
  context.contact(Core::And, before);
  context.coil(Core::Rst, bit);
  context.block(Core::Mpp);
  execution.end();
}

void shift_one(Context& context) {
  const Device bit = context.source().operand(0).device;
  Execution execution(context, {});
  if (bit.number == 0) {
    context.coil(Core::Rst, bit);  // there is no bit before it
  } else {
    const Device before{bit.kind, bit.number - 1};
    copy_bit(context, bit, before);
    context.coil(Core::Rst, before);
  }
  execution.end();
}

std::vector<Device> bits_from(Device head, int count) {
  std::vector<Device> bits;
  for (int i = 0; i < count; ++i) {
    bits.push_back({head.kind, head.number + static_cast<std::uint32_t>(i)});
  }
  return bits;
}

// Copies that shift `bits` by `by` places, upward or downward, in an order in which every bit is
// read before it is written; `fill` moves in, the lowest first.
void shift_bits(Context& context, const std::vector<Device>& bits, int by, bool up,
                const std::vector<Device>& fill) {
  const auto n = static_cast<int>(bits.size());
  by = std::min(by, n);
  for (int k = 0; k < n - by; ++k) {
    const int to = up ? n - 1 - k : k;
    copy_bit(context, bits[to], bits[up ? to - by : to + by]);
  }
  for (int k = 0; k < by; ++k) {
    const Device to = bits[up ? k : n - by + k];
    if (fill.empty()) {
      context.coil(Core::Rst, to);
    } else {
      copy_bit(context, to, fill[k]);
    }
  }
}

bool overlap(const std::vector<Device>& a, const std::vector<Device>& b) {
  return a.front().kind == b.front().kind && a.front().number <= b.back().number &&
         b.front().number <= a.back().number;
}

// SFTL, SFTR: a source that is itself shifted is read first.
void shift_from(Context& context, bool up) {
  const Instruction& source = context.source();
  const std::vector<Device> bits = bits_from(source.operand(1).device, source.operand(2).value);
  std::vector<Device> fill = bits_from(source.operand(0).device, source.operand(3).value);
  if (bits.empty() || fill.empty()) return;
  if (overlap(bits, fill)) {
    for (Device& bit : fill) {
      const Device before = context.temporary_bit();
      context.compute(before, {{bit, false}});
      bit = before;
    }
  }
  Execution execution(context, {});
  shift_bits(context, bits, source.operand(3).value, up, fill);
  execution.end();
}

void shift_by_one(Context& context, bool up) {
  const Instruction& source = context.source();
  const std::vector<Device> bits = bits_from(source.operand(0).device, source.operand(1).value);
  if (bits.empty()) return;
  Execution execution(context, {});
  for (const Device carry : context.named_of_role(SpecialRole::Carry)) {
    copy_bit(context, carry, up ? bits.back() : bits.front());
  }
  shift_bits(context, bits, 1, up, {});
  execution.end();
}

}  // namespace

bool lower_bits(Context& context) {
  switch (context.source().op) {
    case Op::Out:
      out(context);
      return true;
    case Op::Outi:
      out_inverse(context);
      return true;
    case Op::Set:
      set_or_reset(context, true);
      return true;
    case Op::Rst:
      set_or_reset(context, false);
      return true;
    case Op::Pls:
      pulse_coil(context, true);
      return true;
    case Op::Plf:
      pulse_coil(context, false);
      return true;
    case Op::Alt:
      alternate(context);
      return true;
    case Op::Sft:
      shift_one(context);
      return true;
    case Op::Sftl:
      shift_from(context, true);
      return true;
    case Op::Sftr:
      shift_from(context, false);
      return true;
    case Op::Bsfl:
      shift_by_one(context, true);
      return true;
    case Op::Bsfr:
      shift_by_one(context, false);
      return true;
    default:
      return false;
  }
}

}  // namespace rung::lower
