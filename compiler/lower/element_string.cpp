// SPDX-License-Identifier: Apache-2.0
// FORMATTED_STRING: one byte a scan, while the transmitter is free.
#include <algorithm>

#include "lower/elements.hpp"

namespace rung::lower {
namespace {

constexpr int kKept = 1;     // memory word: what is left of the variable
constexpr int kLeading = 1;  // memory bit: only zeros so far

}  // namespace

void Elements::formatted_string(bool used) {
  const std::vector<StringStep> steps = string_steps(source().table);
  const Device step = context_.memory_word(0);
  begin_edge();
  gated(Core::Mov, {step}, {constant(0)});
  end_edge();
  if (steps.empty()) return replace(Flow::Off);

  const auto count = static_cast<std::int32_t>(steps.size());
  const Device going = context_.temporary_bit();
  context_.compute(going,
                   {{less(word(step), constant(count)), false}, {port::uart_tx_ready, false}});
  const Device byte = context_.temporary_word();
  std::vector<std::int32_t> bytes;
  for (const StringStep& each : steps) {
    bytes.push_back(each.kind == StringStep::Kind::Byte ? each.value : 0);
  }
  context_.load_constant(byte, bytes, word(step), true);
  string_variable(going, step, byte, steps);

  context_.contact(Core::Ld, going);
  context_.gated(Core::Mov, {port::uart_tx_data}, {word(byte)});
  context_.coil(Core::Rst, port::uart_tx_ready);
  context_.gated(Core::Add, {step}, {word(step), constant(1)});
  context_.block(Core::Pop);
  if (used) replace(less(word(step), constant(count)), false);
}

// The steps of the sign and of the digits, where the string has them.
void Elements::string_variable(Device going, Device step, Device byte,
                               const std::vector<StringStep>& steps) {
  const auto is_kind = [](StringStep::Kind kind) {
    return [kind](const StringStep& each) { return each.kind == kind; };
  };
  const auto first = std::find_if(steps.begin(), steps.end(), is_kind(StringStep::Kind::Digit));
  if (first == steps.end()) return;
  const auto place = static_cast<std::int32_t>(first - steps.begin());
  const bool sign = std::any_of(steps.begin(), steps.end(), is_kind(StringStep::Kind::Sign));
  if (sign) string_sign(going, equal(word(step), place - 1), byte);
  std::vector<std::int32_t> powers;
  for (auto digit = first; digit != steps.end() && digit->kind == first->kind; ++digit) {
    powers.push_back(digit->value);
  }
  string_digits(going, step, byte, place, powers, sign);
}

// kept <- |variable|
void Elements::string_sign(Device going, Device here, Device byte) {
  const WordSource shown = value(0);
  const Device kept = context_.memory_word(kKept);
  const Device negative = less(shown, constant(0));
  context_.contact(Core::Ld, going);
  context_.contact(Core::And, here);
  context_.gated(Core::Mov, {byte}, {constant(' ')});
  context_.gated(Core::Mov, {kept}, {shown});
  context_.contact(Core::And, negative);
  context_.gated(Core::Mov, {byte}, {constant('-')});
  context_.gated(Core::Sub, {kept}, {constant(0), shown});
  context_.block(Core::Pop);
}

// One division serves all digits: of a scan's step only the power of ten differs.
void Elements::string_digits(Device going, Device step, Device byte, std::int32_t place,
                             const std::vector<std::int32_t>& powers, bool sign) {
  const auto count = static_cast<std::int32_t>(powers.size());
  const Device kept = context_.memory_word(kKept);
  const Device leading = context_.memory(kLeading);
  const Device digit = context_.temporary_word();
  const Device power = context_.temporary_word();
  const Device quotient = context_.temporary_word();
  const Device product = context_.temporary_word();
  const Device among = context_.temporary_bit();

  context_.contact(Core::Ld, going);
  context_.contact(Core::And, equal(word(step), place));
  if (!sign) context_.gated(Core::Mov, {kept}, {value(0)});
  context_.coil(Core::Set, leading);
  context_.block(Core::Pop);

  context_.always(Core::Sub, {digit}, {word(step), constant(place)});
  context_.always(Core::Ltu, {among}, {word(digit), constant(count)});
  context_.load_constant(power, powers, word(digit), true);
  const Device last = equal(word(step), place + count - 1);
  context_.contact(Core::Ld, going);
  context_.contact(Core::And, among);
  context_.gated(Core::Div, {quotient}, {word(kept), word(power)});
  context_.gated(Core::Mul, {product}, {word(quotient), word(power)});
  context_.gated(Core::Sub, {kept}, {word(kept), word(product)});
  context_.gated(Core::Add, {byte}, {word(quotient), constant('0')});
  const Device is_zero = equal(word(quotient), 0);
  context_.block(Core::Mps);
  context_.contact(Core::And, is_zero);
  context_.contact(Core::And, leading);
  context_.contact(Core::Ani, last);
  context_.gated(Core::Mov, {byte}, {constant(' ')});
  context_.block(Core::Mpp);
  context_.contact(Core::Ani, is_zero);
  context_.coil(Core::Rst, leading);
  context_.block(Core::Pop);
}

}  // namespace rung::lower
