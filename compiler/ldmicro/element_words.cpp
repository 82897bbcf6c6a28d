// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "ldmicro/element.hpp"
#include "ldmicro/numbers.hpp"

namespace rung {
namespace {

Operand device_operand(Device device) {
  Operand operand;
  operand.device = device;
  return operand;
}

bool begins_number(std::string_view text) {
  return text[0] == '-' || text[0] == '\'' || (text[0] >= '0' && text[0] <= '9');
}

// What someone will have meant by a hexadecimal number: its 16 bits, signed.
std::string hexadecimal_hint(std::string_view text) {
  if (!text.starts_with("0x") && !text.starts_with("0X")) return {};
  std::uint32_t value = 0;
  for (const char c : text.substr(2)) {
    const bool letter = (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    if (!letter && (c < '0' || c > '9')) return {};
    value = value << 4U | static_cast<std::uint32_t>(letter ? (c | 0x20) - 'a' + 10 : c - '0');
    if (value > 0xFFFF) return {};
  }
  return fmt::format("if its 16 bits are meant, write {}", static_cast<std::int16_t>(value));
}

}  // namespace

std::string LdElement::name() {
  const LdWord& word = this->word();
  if (is_ld_name(word.text)) return word.text;
  if (begins_number(word.text)) {
    refuse(word.position,
           fmt::format("{}: {} needs a name here, not a number", shown(word.text), line_.keyword()),
           "give it a variable, to which MOVE gives the number");
  } else {
    refuse(word.position, fmt::format("{} is no name", shown(word.text)),
           "names are of letters, digits and _, and do not begin with a digit");
  }
  return "_";
}

Operand LdElement::bit() {
  const std::string text = name();
  return good_ ? device_operand(context_.symbols.bit(text)) : Operand{};
}

Operand LdElement::variable() {
  const std::string text = name();
  return good_ ? device_operand(context_.symbols.variable(text)) : Operand{};
}

Operand LdElement::variable_or_number() {
  if (!begins_number(peek().text)) return variable();
  Operand operand;
  operand.kind = Operand::Kind::Constant;
  operand.value = literal(word());
  return operand;
}

std::int32_t LdElement::literal(const LdWord& word) {
  const std::string& text = word.text;
  if (text[0] == '\'') {
    // Words end at blanks, so that of ' ' the first quote alone is left.
    if (text.size() == 1) {
      context_.warn(word.position, "' is read as 0, as LDmicro 2.3 does with ' '",
                    "write 32 for a blank");
      return 0;
    }
    const auto c = static_cast<unsigned char>(text[1]);
    if (c >= 0x80) {
      refuse(word.position,
             fmt::format("{}: the code of this character depends on Windows' "
                         "language",
                         shown(text)),
             "write the code itself");
    } else if (text.size() != 3 || text[2] != '\'') {
      context_.warn(word.position, fmt::format("{} is read as '{}'", shown(text), text[1]));
    }
    return c;
  }
  const LdNumber number = leading_number(text);
  if (number.length != text.size()) {
    context_.warn(word.position,
                  fmt::format("{} is read as {}, as LDmicro 2.3 does", shown(text), number.value),
                  hexadecimal_hint(text));
  }
  return fits16(word, number.value) ? static_cast<std::int32_t>(number.value) : 0;
}

bool LdElement::fits16(const LdWord& word, std::int64_t value) {
  if (value >= INT16_MIN && value <= INT16_MAX) return true;
  refuse(word.position, fmt::format("{} is beyond 16 bits", shown(word.text)),
         "values are -32768 to 32767");
  return false;
}

int LdElement::flag() {
  const LdWord& word = this->word();
  if (word.text == "1") return 1;
  if (word.text != "0") {
    refuse(word.position,
           fmt::format("{}: this mark of {} is 0 or 1", shown(word.text), line_.keyword()));
  }
  return 0;
}

std::int64_t LdElement::whole_number() {
  const LdWord& word = this->word();
  const LdNumber number = leading_number(word.text);
  if (number.length != word.text.size()) {
    refuse(word.position,
           fmt::format("{}: {} takes a decimal number here", shown(word.text), line_.keyword()),
           is_ld_name(word.text) ? "LDmicro 2.3 has no variables in this place: write the number"
                                 : "");
  } else if (!number.fits) {
    refuse(word.position, fmt::format("{} is beyond 32 bits", shown(word.text)));
  } else {
    return number.value;
  }
  return 0;
}

std::int32_t LdElement::number16(const char* of) {
  const LdWord& word = peek();
  const std::int64_t value = whole_number();
  if (value >= INT16_MIN && value <= INT16_MAX) return static_cast<std::int32_t>(value);
  refuse(word.position, fmt::format("{} is beyond 16 bits: {}", shown(word.text), of),
         "values are -32768 to 32767");
  return 0;
}

}  // namespace rung
