// SPDX-License-Identifier: Apache-2.0
// BCD and BIN. With q1 = v / 10, q2 = v / 100, q3 = v / 1000 (no remainders), BCD(v) is
// v + 6 q1 + 96 q2 + 1536 q3: each step of ten moves 6 further than the binary number. The other
// way BIN(b) is b - 6 (b >> 4) - 60 (b >> 8) - 600 (b >> 12).
#include "lower/wide.hpp"
#include "lower/words.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;

// Words of a product, whatever the result: the low one, or the high one.
WordSource product(Context& context, const WordSource& a, int factor, bool high) {
  const Device low_word = context.temporary_word();
  const Device high_word = context.temporary_word();
  core::Instruction instruction;
  instruction.op = Core::Mul;
  instruction.always = true;
  instruction.targets = {low_word};
  if (high) instruction.targets.push_back(high_word);
  instruction.sources = {a, constant(factor)};
  context.emit(std::move(instruction));
  return word(high ? high_word : low_word);
}

// v / 10 for 0 <= v <= 9999: 6554 / 65536 is a tenth and little more.
WordSource tenth(Context& context, const WordSource& value) {
  return product(context, value, 6554, true);
}

WordSource to_bcd(Context& context, const WordSource& value) {
  WordSource quotient = value;
  WordSource sum = value;
  for (const int weight : {6, 96, 1536}) {
    quotient = tenth(context, quotient);
    sum = combine(context, Core::Add, sum, product(context, quotient, weight, false));
  }
  return sum;
}

WordSource from_bcd(Context& context, const WordSource& value) {
  WordSource sum = value;
  const int weights[] = {6, 60, 600};
  for (int digit = 1; digit <= 3; ++digit) {
    const WordSource turned = combine(context, Core::Rol, value, constant(16 - 4 * digit));
    const WordSource shifted =
        combine(context, Core::Wand, turned, constant((1 << (16 - 4 * digit)) - 1));
    sum = combine(context, Core::Sub, sum, product(context, shifted, weights[digit - 1], false));
  }
  return sum;
}

// A bit that is 1 if no digit of the word is above 9: bit 3 of a digit stands alone.
Device digits_good(Context& context, const WordSource& value) {
  const WordSource other =
      combine(context, Core::Wor, combine(context, Core::Rol, value, constant(1)),
              combine(context, Core::Rol, value, constant(2)));
  const WordSource both =
      combine(context, Core::Wand, combine(context, Core::Wand, value, other), constant(0x8888));
  const Device good = context.temporary_bit();
  context.always(Core::Eq, {good}, {both, constant(0)});
  return good;
}

std::vector<Device> divide_by_10000(Context& context, const Words& value) {
  core::Instruction instruction;
  instruction.op = Core::Div32;
  instruction.always = true;
  for (int i = 0; i < 4; ++i) instruction.targets.push_back(context.temporary_word());
  instruction.sources = {value[0], value[1], constant(10000), constant(0)};
  const std::vector<Device> targets = instruction.targets;
  context.emit(std::move(instruction));
  return targets;
}

void binary_to_bcd(Context& context) {
  const Instruction& source = context.source();
  Requirements requirements;
  const Words value = in_words(context, read(context, source.operand(0), requirements.valid));
  const Device good = context.temporary_bit();
  Words result;
  if (value.size() == 1) {
    context.always(Core::Ltu, {good}, {value[0], constant(10000)});
    result = {to_bcd(context, value[0])};
  } else {
    // In range if the quotient by 10000 is, which is negative where the value is.
    const std::vector<Device> parts = divide_by_10000(context, value);
    const Device low = context.temporary_bit();
    const Device high = context.temporary_bit();
    const Device negative = context.temporary_bit();
    context.always(Core::Ltu, {low}, {word(parts[0]), constant(10000)});
    context.always(Core::Eq, {high}, {word(parts[1]), constant(0)});
    context.always(Core::Tb, {negative}, {value[1], constant(15)});
    context.compute(good, {{low, false}, {high, false}, {negative, true}});
    result = {to_bcd(context, word(parts[2])), to_bcd(context, word(parts[0]))};
  }
  requirements.valid.push_back(good);
  write_result(context, source.operand(1), result, std::move(requirements));
}

void bcd_to_binary(Context& context) {
  const Instruction& source = context.source();
  Requirements requirements;
  const Words value = in_words(context, read(context, source.operand(0), requirements.valid));
  for (const WordSource& each : value) requirements.valid.push_back(digits_good(context, each));
  Words result{from_bcd(context, value[0])};
  if (value.size() == 2) {
    // high * 10000 + low: four digits each.
    const WordSource high = from_bcd(context, value[1]);
    core::Instruction multiply;
    multiply.op = Core::Mul;
    multiply.always = true;
    const Device low_word = context.temporary_word();
    const Device high_word = context.temporary_word();
    multiply.targets = {low_word, high_word};
    multiply.sources = {high, constant(10000)};
    context.emit(std::move(multiply));
    core::Instruction add;
    add.op = Core::Add32;
    add.always = true;
    const Device sum_low = context.temporary_word();
    const Device sum_high = context.temporary_word();
    add.targets = {sum_low, sum_high};
    add.sources = {word(low_word), word(high_word), result[0], constant(0)};
    context.emit(std::move(add));
    result = {word(sum_low), word(sum_high)};
  }
  write_result(context, source.operand(1), result, std::move(requirements));
}

}  // namespace

bool lower_codes(Context& context) {
  switch (context.source().op) {
    case Op::Bcd:
      binary_to_bcd(context);
      return true;
    case Op::Bin:
      bcd_to_binary(context);
      return true;
    default:
      return false;
  }
}

}  // namespace rung::lower
