// SPDX-License-Identifier: Apache-2.0
#include "lower/wide.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace rung::lower {
namespace {

std::uint16_t fold(core::Op op, std::uint16_t a, std::uint16_t b) {
  switch (op) {
    case core::Op::Add:
      return static_cast<std::uint16_t>(a + b);
    case core::Op::Sub:
      return static_cast<std::uint16_t>(a - b);
    case core::Op::Wand:
      return a & b;
    case core::Op::Wor:
      return a | b;
    case core::Op::Wxor:
      return a ^ b;
    case core::Op::Rol:
      return std::rotl(a, b & 15);
    default:
      assert(false && "no constants here");
      return 0;
  }
}

}  // namespace

Words read(Context& context, const Operand& operand, std::vector<Device>& valid) {
  if (context.source().width == 16) return {read16(context, operand, valid)};
  const Pair pair = read32(context, operand, valid);
  return {pair.low, pair.high};
}

Words in_words(Context& context, const Words& value) {
  Words words = value;
  for (WordSource& each : words) {
    if (!each.constant) continue;
    const Device device = context.temporary_word();
    context.always(core::Op::Mov, {device}, {each});
    each = word(device);
  }
  return words;
}

WordSource combine(Context& context, core::Op op, const WordSource& a, const WordSource& b) {
  if (a.constant && b.constant) {
    return constant(
        fold(op, static_cast<std::uint16_t>(a.value), static_cast<std::uint16_t>(b.value)));
  }
  const Device target = context.temporary_word();
  context.always(op, {target}, {a, b});
  return word(target);
}

Words combine(Context& context, core::Op op, const Words& a, const Words& b) {
  Words words;
  for (std::size_t i = 0; i < a.size(); ++i) words.push_back(combine(context, op, a[i], b[i]));
  return words;
}

void write_result(Context& context, const Operand& target, const Words& result,
                  Requirements requirements) {
  const Place to = place(context, target, static_cast<int>(result.size()), requirements.valid);
  Execution execution(context, requirements);
  store(context, to, result);
  execution.end();
}

bool overwrites(Device first_target, const Words& sources) {
  return std::any_of(sources.begin(), sources.end(), [&](const WordSource& source) {
    return !source.constant && source.device == first_target;
  });
}

}  // namespace rung::lower
