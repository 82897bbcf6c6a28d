// SPDX-License-Identifier: Apache-2.0
#include "lower/words.hpp"

#include "lower/compare.hpp"
#include "lower/wide.hpp"
#include "rungs/devices.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;

void move(Context& context) {
  Requirements requirements;
  const Words value = read(context, context.source().operand(0), requirements.valid);
  write_result(context, context.source().operand(1), value, std::move(requirements));
}

Words complement(Context& context, const Words& value) {
  return combine(context, Core::Wxor, value, Words(value.size(), constant(-1)));
}

void move_complement(Context& context) {
  Requirements requirements;
  const Words value = read(context, context.source().operand(0), requirements.valid);
  write_result(context, context.source().operand(1), complement(context, value),
               std::move(requirements));
}

// The words that the instruction can write at once, each as one operation on two sources, or none.
void bitwise(Context& context, Core op, bool inverted) {
  const Instruction& source = context.source();
  Requirements requirements;
  const Words a = read(context, source.operand(0), requirements.valid);
  const Words b = read(context, source.operand(1), requirements.valid);
  const auto count = static_cast<int>(a.size());
  const Place to = place(context, source.operand(2), count, requirements.valid);
  const std::vector<Device> direct = direct_words(context, to, count);
  bool constants = false;
  for (int i = 0; i < count; ++i) constants = constants || (a[i].constant && b[i].constant);
  const bool late = count == 2 && !direct.empty() &&
                    (overwrites(direct[0], {a[1]}) || overwrites(direct[0], {b[1]}));
  if (direct.empty() || inverted || late || constants) {
    Words result = combine(context, op, a, b);
    if (inverted) result = complement(context, result);
    Execution execution(context, requirements);
    store(context, to, result);
    return execution.end();
  }
  Execution execution(context, requirements);
  for (int i = 0; i < count; ++i) context.gated(op, {direct[i]}, {a[i], b[i]});
  execution.end();
}

// What an operand holds now, in words of its own.
Words copy(Context& context, const Words& value) {
  Words words;
  for (const WordSource& source : value) {
    const Device device = context.temporary_word();
    context.always(Core::Mov, {device}, {source});
    words.push_back(word(device));
  }
  return words;
}

// The number of a place within the window of its kind.
WordSource number_of(const Context& context, const Place& place) {
  if (place.offset) return word(*place.offset);
  const Device device = place.operand.device;
  const std::uint32_t first = context.window(device.kind).front().number;
  return constant(static_cast<std::int32_t>(device.number - first));
}

// Of pairs that overlap, the one with the higher number is written last and stands. Where an index
// decides which one that is, the first is stored on either side of the second.
void exchange(Context& context) {
  const Instruction& source = context.source();
  Requirements requirements;
  const Words a = copy(context, read(context, source.operand(0), requirements.valid));
  const Words b = copy(context, read(context, source.operand(1), requirements.valid));
  const auto count = static_cast<int>(a.size());
  const Place first = place(context, source.operand(0), count, requirements.valid);
  const Place second = place(context, source.operand(1), count, requirements.valid);
  const bool same_kind = first.operand.device.kind == second.operand.device.kind;
  if (count > 1 && same_kind && (first.offset || second.offset)) {
    const Device ascending = test_less(context, {number_of(context, first), constant(0)},
                                       {number_of(context, second), constant(0)}, 16);
    const auto store_first = [&](Core contact) {
      context.block(Core::Mps);
      context.contact(contact, ascending);
      store(context, first, b);
      context.block(Core::Mpp);
    };
    Execution execution(context, requirements);
    store_first(Core::And);
    store(context, second, a);
    store_first(Core::Ani);
    return execution.end();
  }
  const bool in_order = source.operand(0).device <= source.operand(1).device;
  Execution execution(context, requirements);
  if (in_order) store(context, first, b);
  store(context, second, a);
  if (!in_order) store(context, first, b);
  execution.end();
}

void swap_bytes(Context& context) {
  const Operand& target = context.source().operand(0);
  Requirements requirements;
  Words value = read(context, target, requirements.valid);
  for (WordSource& each : value) each = combine(context, Core::Rol, each, constant(8));
  write_result(context, target, value, std::move(requirements));
}

void block_move(Context& context) {
  const Instruction& source = context.source();
  const Operand& from = source.operand(0);
  const Operand& to = source.operand(1);
  const int count = source.operand(2).value;
  Requirements requirements;
  if (from.kind != Operand::Kind::Device) {
    // Digit groups may overlap in any way: all are read first.
    std::vector<Words> values;
    for (int i = 0; i < count; ++i) {
      values.push_back(read(context, element(from, i, source.width), requirements.valid));
    }
    Execution execution(context, requirements);
    for (int i = 0; i < count; ++i) {
      store(context, {element(to, i, source.width), std::nullopt}, values[i]);
    }
    return execution.end();
  }
  const int words = count * source.width / 16;
  const std::vector<Device> sources = words_of(from.device, 16 * words, context.dialect());
  if (to.kind != Operand::Kind::Device) {
    Execution execution(context, requirements);
    for (int i = 0; i < count; ++i) {
      Words value;
      for (int k = 0; k < source.width / 16; ++k) {
        value.push_back(word(sources[i * source.width / 16 + k]));
      }
      store(context, {element(to, i, source.width), std::nullopt}, value);
    }
    return execution.end();
  }
  const std::vector<Device> targets = words_of(to.device, 16 * words, context.dialect());
  const bool downward = from.device.kind == to.device.kind && to.device.number > from.device.number;
  Execution execution(context, requirements);
  for (int i = 0; i < words; ++i) {
    const int n = downward ? words - 1 - i : i;
    context.gated(Core::Mov, {targets[n]}, {word(sources[n])});
  }
  execution.end();
}

void fill(Context& context) {
  const Instruction& source = context.source();
  Requirements requirements;
  // The value may lie among what is filled: it is read first.
  Words value = read(context, source.operand(0), requirements.valid);
  if (source.operand(0).kind == Operand::Kind::Device) value = copy(context, value);
  Execution execution(context, requirements);
  for (int i = 0; i < source.operand(2).value; ++i) {
    store(context, {element(source.operand(1), i, source.width), std::nullopt}, value);
  }
  execution.end();
}

void reset_range(Context& context) {
  const Device first = context.source().operand(0).device;
  const Device last = context.source().operand(1).device;
  Execution execution(context, {});
  for (std::uint32_t n = first.number; n <= std::max(first.number, last.number); ++n) {
    const Device device{first.kind, n};
    if (is_timer(first.kind) || is_counter(first.kind)) {
      const Device value = value_of(contact_of(device));
      context.gated(Core::Mov, {value}, {constant(0)}, true);
      if (is_32_bit_counter(value, context.dialect())) {
        context.gated(Core::Mov, {high_word(value, context.dialect())}, {constant(0)}, true);
      }
      context.coil(Core::Rst, contact_of(device), true);
    } else if (is_word(device)) {
      context.gated(Core::Mov, {device}, {constant(0)});
    } else {
      context.coil(Core::Rst, device);
    }
  }
  execution.end();
}

}  // namespace

bool lower_words(Context& context) {
  switch (context.source().op) {
    case Op::Mov:
      move(context);
      return true;
    case Op::Cml:
      move_complement(context);
      return true;
    case Op::Wand:
      bitwise(context, Core::Wand, false);
      return true;
    case Op::Wor:
      bitwise(context, Core::Wor, false);
      return true;
    case Op::Wxor:
      bitwise(context, Core::Wxor, false);
      return true;
    case Op::Wxnr:
      bitwise(context, Core::Wxor, true);
      return true;
    case Op::Xch:
      exchange(context);
      return true;
    case Op::Swap:
      swap_bytes(context);
      return true;
    case Op::Bmov:
      block_move(context);
      return true;
    case Op::Fmov:
      fill(context);
      return true;
    case Op::Zrst:
      reset_range(context);
      return true;
    case Op::Cmp:
      lower_cmp(context);
      return true;
    case Op::Zcp:
      lower_zcp(context);
      return true;
    default:
      return false;
  }
}

}  // namespace rung::lower
