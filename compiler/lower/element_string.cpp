// SPDX-License-Identifier: Apache-2.0
// FORMATTED_STRING: one byte a scan, while the transmitter is free.
#include "lower/elements.hpp"
#include "rungs/format_string.hpp"

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
  std::vector<Digit> digits;
  bool sign = false;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Device here = equal(word(step), static_cast<std::int32_t>(i));
    switch (steps[i].kind) {
      case StringStep::Kind::Byte:
        gated_by(here, false, Core::Mov, {byte}, {constant(steps[i].value)});
        break;
      case StringStep::Kind::Sign:
        sign = true;
        string_sign(going, here, byte);
        break;
      case StringStep::Kind::Digit:
        digits.push_back({here, steps[i].value});
        break;
    }
  }
  if (!digits.empty()) string_digits(going, byte, digits, sign);

  context_.contact(Core::Ld, going);
  context_.gated(Core::Mov, {port::uart_tx_data}, {word(byte)});
  context_.coil(Core::Rst, port::uart_tx_ready);
  context_.gated(Core::Add, {step}, {word(step), constant(1)});
  context_.block(Core::Pop);
  if (used) replace(less(word(step), constant(count)), false);
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
void Elements::string_digits(Device going, Device byte, const std::vector<Digit>& digits,
                             bool sign) {
  const Device kept = context_.memory_word(kKept);
  const Device leading = context_.memory(kLeading);
  const Device power = context_.temporary_word();
  const Device quotient = context_.temporary_word();
  const Device product = context_.temporary_word();

  context_.contact(Core::Ld, going);
  context_.contact(Core::And, digits.front().here);
  if (!sign) context_.gated(Core::Mov, {kept}, {value(0)});
  context_.coil(Core::Set, leading);
  context_.block(Core::Pop);
  for (const Digit& digit : digits) {
    gated_by(digit.here, false, Core::Mov, {power}, {constant(digit.power)});
  }

  context_.contact(Core::Ld, digits.front().here);
  for (std::size_t i = 1; i < digits.size(); ++i) context_.contact(Core::Or, digits[i].here);
  context_.contact(Core::And, going);
  context_.gated(Core::Div, {quotient}, {word(kept), word(power)});
  context_.gated(Core::Mul, {product}, {word(quotient), word(power)});
  context_.gated(Core::Sub, {kept}, {word(kept), word(product)});
  context_.gated(Core::Add, {byte}, {word(quotient), constant('0')});
  const Device is_zero = equal(word(quotient), 0);
  context_.block(Core::Mps);
  context_.contact(Core::And, is_zero);
  context_.contact(Core::And, leading);
  context_.contact(Core::Ani, digits.back().here);
  context_.gated(Core::Mov, {byte}, {constant(' ')});
  context_.block(Core::Mpp);
  context_.contact(Core::Ani, is_zero);
  context_.coil(Core::Rst, leading);
  context_.block(Core::Pop);
}

}  // namespace rung::lower
