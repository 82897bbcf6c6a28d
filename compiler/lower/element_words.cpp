// SPDX-License-Identifier: Apache-2.0
// Arithmetic and tables of LDmicro.
#include "lower/elements.hpp"

namespace rung::lower {
namespace {

core::Op core_op(Op op) {
  switch (op) {
    case Op::Add:
      return core::Op::Add;
    case Op::Sub:
      return core::Op::Sub;
    case Op::Mul:
      return core::Op::Mul;
    default:
      return core::Op::Div;
  }
}

}  // namespace

// A core instruction takes one constant; of two, the second goes through a word.
void Elements::arithmetic() {
  WordSource b = value(1);
  if (value(0).constant && b.constant) {
    const Device device = context_.temporary_word();
    context_.always(Core::Mov, {device}, {b});
    b = word(device);
  }
  gated(core_op(source().op), {variable(2)}, {value(0), b}, false);
}

void Elements::shift_register() {
  begin_edge();
  for (std::size_t i = source().operands.size(); i-- > 1;) {
    gated(Core::Mov, {variable(i)}, {word(variable(i - 1))});
  }
  end_edge();
}

// The rows as a table in constant words. Where the target is its own index, a row may lead to a
// later one, and each has the value where that ends.
void Elements::look_up() {
  const Device target = variable();
  std::vector<std::int32_t> rows = source().table;
  const auto count = static_cast<std::int32_t>(rows.size());
  const WordSource index = value(1);
  if (flow_ == Flow::Off || rows.empty()) return;
  if (index.constant) {
    if (index.value >= 0 && index.value < count) {
      gated(Core::Mov, {target}, {constant(rows[static_cast<std::size_t>(index.value)])});
    }
    return;
  }
  if (index == word(target)) {
    for (std::int32_t i = count - 1; i >= 0; --i) {
      std::int32_t& row = rows[static_cast<std::size_t>(i)];
      if (row > i && row < count) row = rows[static_cast<std::size_t>(row)];
    }
  }
  const Device inside = context_.temporary_bit();
  context_.always(Core::Ltu, {inside}, {index, constant(count)});
  const Flow flow = flow_;
  if (flow == Flow::Result) context_.block(Core::Mps);
  contact(inside, false);
  context_.load_constant(target, rows, index, false);
  if (flow == Flow::Result) {
    context_.block(Core::Mpp);
  } else {
    replace(flow);
  }
}

void Elements::segment(Device target, const WordSource& index, std::size_t i) {
  const std::vector<std::int32_t>& table = source().table;
  const std::int32_t x = table[2 * i - 2];
  const std::int32_t y = table[2 * i - 1];
  const Device line = context_.temporary_word();
  context_.gated(Core::Sub, {line}, {index, constant(x)});
  context_.gated(Core::Mul, {line}, {word(line), constant(table[2 * i + 1] - y)});
  context_.gated(Core::Div, {line}, {word(line), constant(table[2 * i] - x)});
  context_.gated(Core::Add, {target}, {word(line), constant(y)}, true);
}

// The lowest segment that matches counts. With a target of its own, each segment's constants are
// chosen first and the line is worked out once; where the target is the index, one segment may lead
// to the next, and each works on a copy.
void Elements::piecewise() {
  const Device target = variable();
  const std::size_t segments = source().table.size() / 2 - 1;
  if (flow_ == Flow::Off || segments == 0) return;
  const std::vector<std::int32_t>& table = source().table;
  const auto limit = [&](std::size_t i) { return constant(table[2 * i] + 1); };

  if (value(1) == word(target)) {
    const Device copy = context_.temporary_word();
    context_.always(Core::Mov, {copy}, {word(target)});
    for (std::size_t i = segments; i > 0; --i) {
      context_.contact(Core::Ld, less(word(copy), limit(i)));
      segment(copy, word(copy), i);
      context_.block(Core::Pop);
    }
    return gated(Core::Mov, {target}, {word(copy)});
  }

  const Flow flow = flow_;
  if (segments == 1) {
    const Device inside = less(value(1), limit(1));
    if (flow == Flow::Result) context_.block(Core::Mps);
    contact(inside, false);
    segment(target, value(1), 1);
  } else {
    const Device x = context_.temporary_word();
    const Device y = context_.temporary_word();
    const Device dx = context_.temporary_word();
    const Device dy = context_.temporary_word();
    // dx is 0 where no segment matches.
    context_.always(Core::Mov, {dx}, {constant(0)});
    for (std::size_t i = segments; i > 0; --i) {
      context_.contact(Core::Ld, less(value(1), limit(i)));
      context_.gated(Core::Mov, {x}, {constant(table[2 * i - 2])});
      context_.gated(Core::Mov, {y}, {constant(table[2 * i - 1])});
      context_.gated(Core::Mov, {dx}, {constant(table[2 * i] - table[2 * i - 2])});
      context_.gated(Core::Mov, {dy}, {constant(table[2 * i + 1] - table[2 * i - 1])});
      context_.block(Core::Pop);
    }
    const Device outside = equal(word(dx), 0);
    if (flow == Flow::Result) context_.block(Core::Mps);
    contact(outside, true);
    const Device line = context_.temporary_word();
    context_.gated(Core::Sub, {line}, {value(1), word(x)});
    context_.gated(Core::Mul, {line}, {word(line), word(dy)});
    context_.gated(Core::Div, {line}, {word(line), word(dx)});
    context_.gated(Core::Add, {target}, {word(line), word(y)}, true);
  }
  if (flow == Flow::Result) {
    context_.block(Core::Mpp);
  } else {
    replace(flow);
  }
}

}  // namespace rung::lower
