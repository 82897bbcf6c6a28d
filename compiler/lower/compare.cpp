// SPDX-License-Identifier: Apache-2.0
#include "lower/compare.hpp"

#include "lower/condition.hpp"
#include "lower/operands.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;

Pair read(Context& context, const Operand& operand, std::vector<Device>& valid) {
  if (context.source().width == 32) return read32(context, operand, valid);
  return {read16(context, operand, valid), constant(0)};
}

// What a compare contact finds: 0 where the operand is out of its window.
Pair read_or_zero(Context& context, const Operand& operand) {
  std::vector<Device> valid;
  const Pair pair = read(context, operand, valid);
  for (const Device inside : valid) {
    context.contact(Core::Ldi, inside);
    context.gated(Core::Mov, {pair.low.device}, {constant(0)});
    if (!pair.high.constant) context.gated(Core::Mov, {pair.high.device}, {constant(0)});
    context.block(Core::Pop);
    set_errors_beside(context, inside);
  }
  return pair;
}

// A word instruction has one constant at most: the other operand goes through a word.
Pair in_words(Context& context, const Pair& pair, int width) {
  Pair words = pair;
  for (WordSource* source : {&words.low, &words.high}) {
    if (!source->constant || (source == &words.high && width == 16)) continue;
    const Device device = context.temporary_word();
    context.always(Core::Mov, {device}, {*source});
    *source = word(device);
  }
  return words;
}

// The word operations take one constant each; of two 32-bit operands with constants in either, the
// second gives way.
void separate(Context& context, const Pair& a, Pair& b, int width) {
  const bool low = a.low.constant && b.low.constant;
  const bool high = width == 32 && a.high.constant && b.high.constant;
  if (low || high) b = in_words(context, b, width);
}

void equal(Context& context, Device bit, const WordSource& a, const WordSource& b) {
  context.always(Core::Eq, {bit}, {a, b});
}

// Copies hidden bits to three that follow each other, under the current result.
void copy_bits(Context& context, Device first, const std::vector<Device>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    copy_bit(context, {first.kind, first.number + static_cast<std::uint32_t>(i)}, values[i]);
  }
}

Device opposite_of_both(Context& context, Device a, Device b) {
  const Device bit = context.temporary_bit();
  context.compute(bit, {{a, true}, {b, true}});
  return bit;
}

}  // namespace

Device test_equal(Context& context, const Pair& a, const Pair& second, int width) {
  Pair b = second;
  separate(context, a, b, width);
  const Device low = context.temporary_bit();
  equal(context, low, a.low, b.low);
  if (width == 16) return low;
  const Device high = context.temporary_bit();
  equal(context, high, a.high, b.high);
  const Device both = context.temporary_bit();
  context.compute(both, {{low, false}, {high, false}});
  return both;
}

Device test_less(Context& context, const Pair& a, const Pair& second, int width) {
  Pair b = second;
  separate(context, a, b, width);
  const Device bit = context.temporary_bit();
  if (width == 16) {
    context.always(Core::Lt, {bit}, {a.low, b.low});
  } else {
    context.always(Core::Lt32, {bit}, {a.low, a.high, b.low, b.high});
  }
  return bit;
}

Test compare_contact(Context& context) {
  const Instruction& source = context.source();
  const int width = source.width;
  const Pair a = read_or_zero(context, source.operand(0));
  const Pair b = read_or_zero(context, source.operand(1));
  Test test;
  switch (source.relation) {
    case Relation::Equal:
      test = {test_equal(context, a, b, width), false};
      break;
    case Relation::NotEqual:
      test = {test_equal(context, a, b, width), true};
      break;
    case Relation::Less:
      test = {test_less(context, a, b, width), false};
      break;
    case Relation::GreaterEqual:
      test = {test_less(context, a, b, width), true};
      break;
    case Relation::Greater:
      test = {test_less(context, b, a, width), false};
      break;
    case Relation::LessEqual:
      test = {test_less(context, b, a, width), true};
      break;
  }
  return test;
}

void lower_cmp(Context& context) {
  const Instruction& source = context.source();
  Requirements requirements;
  const Pair a = read(context, source.operand(0), requirements.valid);
  const Pair b = read(context, source.operand(1), requirements.valid);
  const Device greater = test_less(context, b, a, source.width);
  const Device less = test_less(context, a, b, source.width);
  const Device equal = opposite_of_both(context, greater, less);
  Execution execution(context, requirements);
  copy_bits(context, source.operand(2).device, {greater, equal, less});
  execution.end();
}

void lower_zcp(Context& context) {
  const Instruction& source = context.source();
  Requirements requirements;
  const Pair low = read(context, source.operand(0), requirements.valid);
  const Pair high = read(context, source.operand(1), requirements.valid);
  const Pair value = read(context, source.operand(2), requirements.valid);
  const Device below = test_less(context, value, low, source.width);
  const Device above = test_less(context, high, value, source.width);
  const Device within = opposite_of_both(context, below, above);
  // Where the limits are the wrong way round a value can be below and above, as the text has it.
  Execution execution(context, requirements);
  copy_bits(context, source.operand(3).device, {below, within, above});
  execution.end();
}

}  // namespace rung::lower
