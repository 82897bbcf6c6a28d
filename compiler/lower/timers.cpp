// SPDX-License-Identifier: Apache-2.0
#include "lower/timers.hpp"

#include <map>

#include "lower/condition.hpp"
#include "lower/operands.hpp"
#include "rungs/devices.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;
using Role = Context::Role;

// More than one OUT, or one that a loop or subroutine may execute again.
bool executes_often(const Program& program, Device timer) {
  int outs = 0;
  bool repeated = false;
  bool beyond_main = false;
  int loops = 0;
  for (const Instruction& instruction : program.instructions) {
    beyond_main = beyond_main || instruction.op == Op::Fend;
    loops += instruction.op == Op::For ? 1 : instruction.op == Op::Next ? -1 : 0;
    if (instruction.op != Op::OutT || instruction.operand(0).device != timer) continue;
    ++outs;
    repeated = repeated || beyond_main || loops > 0;
  }
  return outs > 1 || repeated;
}

bool has_reset(const Program& program, Device counter) {
  for (const Instruction& instruction : program.instructions) {
    if (instruction.op == Op::Rst && instruction.operand(0).device == counter) return true;
  }
  return false;
}

// memory <- the result on the branch stack, at the end of a timer or counter.
void end_coil(Context& context, Device coil) {
  context.block(Core::Mpp);
  remember(context, coil);
}

void count_16(Context& context, Device contact, const WordSource& preset) {
  const Device value = value_of(contact);
  const Device below = context.temporary_bit();
  context.contact(Core::Ani, contact);
  context.gated(Core::Add, {value}, {word(value), constant(1)}, true);
  context.always(Core::Lt, {below}, {word(value), preset});
  context.contact(Core::Ani, below);
  context.coil(Core::Set, contact, true);
}

void test_pair_equal(Context& context, Device bit, const Pair& a, const Pair& b) {
  const Device low = context.temporary_bit();
  const Device high = context.temporary_bit();
  context.always(Core::Eq, {low}, {a.low, b.low});
  context.always(Core::Eq, {high}, {a.high, b.high});
  context.compute(bit, {{low, false}, {high, false}});
}

// The ring of 32 bits: the contact follows the crossing between preset - 1 and preset.
void count_32(Context& context, Device contact, const Pair& preset) {
  const Device low = value_of(contact);
  const Device high = high_word(low, context.dialect());
  const Device down{DeviceKind::M, 8200 + contact.number - 200};
  const bool directed = context.is_named(down);
  const Pair value{word(low), word(high)};
  const Device reached = context.temporary_bit();
  if (directed) {
    const Device at_preset = context.temporary_bit();
    test_pair_equal(context, at_preset, value, preset);
    context.block(Core::Mps);
    context.contact(Core::And, down);
    context.gated(Core::Sub32, {low, high}, {value.low, value.high, constant(1), constant(0)},
                  true);
    context.contact(Core::And, at_preset);
    context.coil(Core::Rst, contact, true);
    context.block(Core::Mpp);
    context.contact(Core::Ani, down);
  }
  context.gated(Core::Add32, {low, high}, {value.low, value.high, constant(1), constant(0)}, true);
  test_pair_equal(context, reached, value, preset);
  context.contact(Core::And, reached);
  context.coil(Core::Set, contact, true);
}

// The ticks for this OUT of the timer: none if another was executed before in this scan.
Device ticks_once(Context& context, Device timer, Device ticks) {
  const Device used = context.memory_of(timer, Role::TicksUsed);
  const Device once = context.temporary_word();
  context.always(Core::Mov, {once}, {word(ticks)});
  context.contact(Core::Ld, used);
  context.gated(Core::Mov, {once}, {constant(0)});
  // Executed is executed, with power or without; skipped is not.
  context.contact(Core::Ori, used);
  context.gate_live();
  context.coil(Core::Set, used);
  context.block(Core::Pop);
  return once;
}

}  // namespace

void begin_timers(Context& context) {
  const Program& program = context.program();
  std::map<Device, std::size_t> timers;
  for (std::size_t i = 0; i < program.instructions.size(); ++i) {
    if (program.instructions[i].op == Op::OutT) {
      timers.try_emplace(program.instructions[i].operand(0).device, i);
    }
  }
  for (const auto& [timer, first] : timers) {
    if (!executes_often(program, timer)) continue;
    const Device used = context.memory_of(timer, Role::TicksUsed);
    context.at(first);
    context.begin_network();
    context.contact(Core::Ld, used);
    context.contact(Core::Ani, used);
    context.coil(Core::Out, used);
    context.end_network();
  }
}

// cond is the gated result c; coil k, contact s, value v, preset p:
//   c AND k AND NOT s: v <- min(v + ticks, p);  s <- c AND (s OR v >= p);  NOT c: v <- 0;  k <- c
void lower_timer(Context& context) {
  const Instruction& source = context.source();
  const Device contact = source.operand(0).device;
  const Device value = value_of(contact);
  const Device coil = context.memory_of(contact, Role::Coil);
  const bool retentive = timer_range(contact, context.dialect()).retentive;
  const bool often = executes_often(context.program(), contact);
  std::vector<Device> valid;
  const WordSource preset = read16(context, source.operand(1), valid);

  const Device next = context.temporary_word();
  const Device below = context.temporary_bit();
  Device ticks = context.ticks(source.base_us);
  if (often) ticks = ticks_once(context, contact, ticks);
  context.always(Core::Add, {next}, {word(value), word(ticks)});
  context.always(Core::Minu, {next}, {word(next), preset});

  context.gate();
  context.block(Core::Mps);
  context.contact(Core::And, coil);
  context.contact(Core::Ani, contact);
  context.gated(Core::Mov, {value}, {word(next)}, true);
  context.always(Core::Ltu, {below}, {word(value), preset});
  context.block(Core::Mrd);
  if (retentive) {
    context.contact(Core::Ani, below);
    context.coil(Core::Set, contact, true);
  } else {
    context.contact(Core::Ld, contact);
    context.contact(Core::Ori, below);
    context.block(Core::Anb);
    context.drive(contact, true);
    context.block(Core::Mrd);
    context.block(Core::Inv);
    context.gate_live();
    context.gated(Core::Mov, {value}, {constant(0)}, true);
  }
  end_coil(context, coil);
}

void lower_counter(Context& context) {
  const Instruction& source = context.source();
  const Device contact = source.operand(0).device;
  const Device coil = context.memory_of(contact, Role::Coil);
  const bool wide = is_32_bit_counter(contact, context.dialect());
  std::vector<Device> valid;
  Pair preset{constant(0), constant(0)};
  if (wide) {
    preset = read32(context, source.operand(1), valid);
  } else {
    preset.low = read16(context, source.operand(1), valid);
  }
  context.gate();
  context.block(Core::Mps);
  context.contact(Core::Ani, coil);
  if (has_reset(context.program(), contact)) {
    context.contact(Core::Ani, context.memory_of(contact, Role::Held));
  }
  wide ? count_32(context, contact, preset) : count_16(context, contact, preset.low);
  end_coil(context, coil);
}

void reset_timer(Context& context) {
  const Device contact = context.source().operand(0).device;
  const Device value = value_of(contact);
  Execution execution(context, {});
  context.gated(Core::Mov, {value}, {constant(0)}, true);
  if (is_32_bit_counter(contact, context.dialect())) {
    context.gated(Core::Mov, {high_word(value, context.dialect())}, {constant(0)}, true);
  }
  context.coil(Core::Rst, contact, true);
  execution.end();
  if (!is_counter(contact.kind)) return;
  // Counting stops while this reset is driven (SEMANTICS.md, counters).
  context.block(Core::Mps);
  remember(context, context.memory_of(contact, Role::Held));
  context.block(Core::Mpp);
}

}  // namespace rung::lower
