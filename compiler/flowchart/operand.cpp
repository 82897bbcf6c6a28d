// SPDX-License-Identifier: Apache-2.0
#include "flowchart/operand.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <string_view>

#include "melsec/operands.hpp"
#include "rungs/devices.hpp"
#include "rungs/footprint.hpp"
#include "rungs/special.hpp"

namespace rung::flowchart {
namespace {

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

[[noreturn]] void refuse(const Token& token, std::string_view what, std::string mend) {
  throw Refusal{token.position, fmt::format("{}: {}", shown(token), what), std::move(mend)};
}

std::string range_text(DeviceKind kind, Dialect dialect) {
  if (find_device_range(kind, dialect) == nullptr) return {};
  const DeviceRange& range = device_range(kind, dialect);
  return fmt::format("the devices are {} to {}", source_name({kind, range.first}, dialect),
                     source_name({kind, range.last}, dialect));
}

// `name` is in upper case, without what makes it a digit group or a bit of a word.
Device read_device(const Token& token, std::string_view name, Dialect dialect) {
  const ParsedDevice parsed = name.find(':') == std::string_view::npos
                                  ? parse_device(name, dialect)
                                  : ParsedDevice{DeviceError::Form, {}};
  const DeviceKind kind = parsed.device.kind;
  switch (parsed.error) {
    case DeviceError::None:
      break;
    case DeviceError::Digit: {
      const DeviceRange* range = find_device_range(kind, dialect);
      const bool octal = range != nullptr && range->base == 8;
      refuse(token,
             fmt::format("not {}: its numbers are {} in dialect {}", kind_name(kind),
                         octal ? "octal (digits 0 to 7)" : "decimal", dialect_name(dialect)),
             range_text(kind, dialect));
    }
    case DeviceError::Range:
      refuse(token, fmt::format("beyond the last device of dialect {}", dialect_name(dialect)),
             range_text(kind, dialect));
    case DeviceError::Special:
      refuse(token, "a special device that this controller does not have",
             "compiler/SEMANTICS.md lists those that it has");
    case DeviceError::Form:
      for (const Dialect other : {Dialect::Fx, Dialect::Q}) {
        const ParsedDevice there = parse_device(name, other);
        if (there.error == DeviceError::Form) continue;
        refuse(token,
               fmt::format("{}, which dialect {} does not have", kind_name(there.device.kind),
                           dialect_name(dialect)),
               fmt::format("for such a controller begin with the line `dialect {}`",
                           dialect_name(other)));
      }
      const std::string_view near = near_keyword(token.text);
      refuse(token, "neither a device nor a word of the language",
             near.empty() ? "a device is a letter such as X, Y, M, D with a number: M10"
                          : fmt::format("did you mean {}?", near));
  }
  const SpecialRange* special = find_special(parsed.device, dialect);
  if (special != nullptr && !is_driven(special->role) && special->role != SpecialRole::Direction) {
    refuse(token, "what instructions of the ladder leave there; a step neither sets nor sees it",
           "copy it to a relay in the ladder");
  }
  return parsed.device;
}

// K4X0, upper case: K, digits, a letter.
bool is_digit_group(std::string_view text) {
  if (text.front() != 'K') return false;
  const std::size_t letter = text.find_first_not_of("0123456789", 1);
  return letter != std::string_view::npos && letter > 1;
}

Operand read_group(const Token& token, std::string_view text, Dialect dialect) {
  const std::size_t letter = text.find_first_not_of("0123456789", 1);
  if (letter != 2 || text[1] < '1' || text[1] > '4') {
    refuse(token, "not a digit group of a word", "K1 to K4: one to four digits of four bits each");
  }
  const Device head = read_device(token, text.substr(letter), dialect);
  Operand operand;
  operand.kind = Operand::Kind::Digits;
  operand.device = head;
  operand.digits = text[1] - '0';
  const auto bits = static_cast<std::uint32_t>(4 * operand.digits);
  if (is_word(head) || is_timer(head.kind) || is_counter(head.kind) ||
      find_special(head, dialect) != nullptr) {
    refuse(token, "a digit group begins with an input, output or relay", "K4X0, K2M16");
  }
  if (head.number + bits - 1 > device_range(head.kind, dialect).last) {
    refuse(token, fmt::format("its {} bits go beyond the last device", bits),
           range_text(head.kind, dialect));
  }
  return operand;
}

Operand read_word_bit(const Token& token, std::string_view text, std::size_t dot, Dialect dialect) {
  const Device word = read_device(token, text.substr(0, dot), dialect);
  const std::string_view number = text.substr(dot + 1);
  const bool plain = word.kind == DeviceKind::D || word.kind == DeviceKind::W ||
                     word.kind == DeviceKind::SW || word.kind == DeviceKind::R;
  if (!plain || number.size() != 1 || std::isxdigit(static_cast<unsigned char>(number[0])) == 0) {
    refuse(token, "not a bit of a word", "bits of data registers are D0.0 to D0.F");
  }
  Operand operand;
  operand.kind = Operand::Kind::WordBit;
  operand.device = word;
  std::from_chars(number.data(), number.data() + 1, operand.bit, 16);
  return operand;
}

}  // namespace

Operand read_operand(const Token& token, Dialect dialect) {
  const std::string text = upper(token.text);
  const std::size_t dot = text.find('.');
  const bool group = is_digit_group(text);
  if (dialect == Dialect::Paper && (group || dot != std::string::npos)) {
    refuse(token, "bits of words and words of bits are not in dialect paper",
           "begin with the line `dialect fx`");
  }
  if (group) return read_group(token, text, dialect);
  if (dot != std::string::npos) return read_word_bit(token, text, dot, dialect);
  Operand operand;
  operand.device = read_device(token, text, dialect);
  return operand;
}

bool is_bit(const Operand& operand) {
  return operand.kind == Operand::Kind::WordBit ||
         (operand.kind == Operand::Kind::Device && !is_word(operand.device));
}

void check_writable(const Token& token, const Operand& operand, Dialect dialect) {
  const DeviceKind kind = operand.device.kind;
  if (is_timer(kind) || is_counter(kind)) {
    refuse(token, fmt::format("{}: timers and counters work in the ladder only", kind_name(kind)),
           "use `wait 500 ms`, or start it in the ladder by a relay that the step sets");
  }
  if (kind == DeviceKind::X) {
    refuse(token, "an input, which only the controller writes", "write a relay (M) or output (Y)");
  }
  const SpecialRange* special = find_special(operand.device, dialect);
  if (special != nullptr && is_driven(special->role)) {
    refuse(token, "a special relay that only the controller writes", "write a relay (M)");
  }
}

}  // namespace rung::flowchart
