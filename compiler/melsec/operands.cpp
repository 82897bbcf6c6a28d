// SPDX-License-Identifier: Apache-2.0
#include "melsec/operands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include "melsec/special_reasons.hpp"
#include "melsec/unsupported.hpp"
#include "rungs/devices.hpp"

namespace rung {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_hex_digit(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

// The number that all of `digits` is, at most 2^40; or nothing.
std::optional<std::int64_t> read_number(std::string_view digits, int base) {
  constexpr std::int64_t kFar = 1LL << 40U;
  std::int64_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, failure] = std::from_chars(digits.data(), end, value, base);
  if (failure == std::errc::result_out_of_range) return digits.front() == '-' ? -kFar : kFar;
  if (failure != std::errc() || stop != end) return std::nullopt;
  return std::clamp(value, -kFar, kFar);
}

// K4X0: a K, one or more digits, a letter.
bool is_digit_group(std::string_view upper) {
  if (upper.size() < 4 || upper.front() != 'K') return false;
  const std::size_t letter = upper.find_first_not_of("0123456789", 1);
  return letter != std::string_view::npos && letter > 1 && upper[letter] != 'Z' &&
         upper[letter] != 'V' && std::isupper(static_cast<unsigned char>(upper[letter])) != 0;
}

bool is_constant(std::string_view upper) {
  return !upper.empty() && (upper.front() == 'K' || upper.front() == 'H');
}

// Where the index of D20Z1 or D20V begins, or npos.
std::size_t find_index(std::string_view upper) {
  const std::size_t at = upper.find_last_of("ZV");
  if (at == std::string_view::npos || at < 2 || !is_hex_digit(upper[at - 1])) {
    return std::string_view::npos;
  }
  const std::string_view number = upper.substr(at + 1);
  return std::all_of(number.begin(), number.end(), is_digit) ? at : std::string_view::npos;
}

bool is_pointer_or_level(std::string_view upper) {
  return upper.size() >= 2 && (upper.front() == 'P' || upper.front() == 'N') &&
         std::all_of(upper.begin() + 1, upper.end(), is_digit);
}

constexpr int kLastPointer = 4095;
constexpr int kLastLevel = 7;

}  // namespace

bool looks_like_operand(std::string_view upper) {
  if (upper.size() < 2) return false;
  if (unsupported_operand(upper)) return true;
  for (const Dialect dialect : {Dialect::Fx, Dialect::Q}) {
    if (parse_device(upper, dialect).error != DeviceError::Form) return true;
  }
  if (is_pointer_or_level(upper) || is_digit_group(upper)) return true;
  if (upper.front() == 'K') {
    return is_digit(upper[1]) || (upper.size() > 2 && upper[1] == '-' && is_digit(upper[2]));
  }
  if (upper.front() == 'H') return is_hex_digit(upper[1]);
  const std::size_t tail = std::min(find_index(upper), upper.find('.'));
  return tail != std::string_view::npos && tail > 1 && looks_like_operand(upper.substr(0, tail));
}

std::optional<Device> timer_or_counter(std::string_view upper, Dialect dialect) {
  const ParsedDevice parsed = parse_device(upper, dialect);
  if (parsed.error == DeviceError::Form || parsed.error == DeviceError::Special) return {};
  if (!is_timer(parsed.device.kind) && !is_counter(parsed.device.kind)) return {};
  return contact_of(parsed.device);
}

std::string source_name(Device device, Dialect dialect) {
  const Device contact = contact_of(device);
  switch (contact.kind) {
    case DeviceKind::TS:
      return fmt::format("T{}", device.number);
    case DeviceKind::STS:
      return fmt::format("ST{}", device.number);
    case DeviceKind::CS:
      return fmt::format("C{}", device.number);
    default:
      return device_name(device, dialect);
  }
}

std::string_view kind_name(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::X:
      return "an input";
    case DeviceKind::Y:
      return "an output";
    case DeviceKind::M:
      return "a relay";
    case DeviceKind::L:
      return "a latched relay";
    case DeviceKind::F:
      return "an annunciator";
    case DeviceKind::B:
    case DeviceKind::SB:
      return "a link relay";
    case DeviceKind::S:
      return "a state";
    case DeviceKind::SM:
      return "a special relay";
    case DeviceKind::TS:
      return "a timer";
    case DeviceKind::STS:
      return "a retentive timer";
    case DeviceKind::CS:
      return "a counter";
    case DeviceKind::V:
    case DeviceKind::Z:
      return "an index register";
    case DeviceKind::SD:
      return "a special register";
    case DeviceKind::TN:
    case DeviceKind::STN:
      return "the value of a timer";
    case DeviceKind::CN:
    case DeviceKind::CNH:
      return "the value of a counter";
    case DeviceKind::D:
    case DeviceKind::W:
    case DeviceKind::SW:
    case DeviceKind::R:
    case DeviceKind::HB:
    case DeviceKind::PB:
    case DeviceKind::PW:
    case DeviceKind::HW:
      break;
  }
  return "a word";
}

OperandReader::OperandReader(const std::string& file, Dialect dialect, std::string instruction,
                             Diagnostics& diagnostics)
    : file_(file),
      dialect_(dialect),
      instruction_(std::move(instruction)),
      diagnostics_(diagnostics) {}

void OperandReader::error(const ListWord& word, const std::string& what, std::string mend) {
  diagnostics_.error(file_, word.position,
                     fmt::format("{} {}: {}", instruction_, shown(word.upper), what),
                     std::move(mend));
}

void OperandReader::refuse(const ListWord& word) { static_cast<void>(parse(word, 32)); }

void OperandReader::explain(const ListWord& word, std::string_view name, DeviceKind kind,
                            bool digit) {
  if (find_device_range(kind, dialect_) == nullptr) {
    error(word, fmt::format("not {}: its number is decimal", kind_name(kind)));
    return;
  }
  const DeviceRange& range = device_range(kind, dialect_);
  const std::string first = source_name({kind, range.first}, dialect_);
  const std::string last = source_name({kind, range.last}, dialect_);
  if (digit) {
    const bool octal = range.base == 8;
    const bool q_has_it = parse_device(name, Dialect::Q).error == DeviceError::None;
    error(word,
          fmt::format("not {}: its numbers are {} in dialect {}", kind_name(kind),
                      octal ? "octal (digits 0 to 7)" : "decimal", dialect_name(dialect_)),
          octal && q_has_it
              ? fmt::format("after {}7 comes {}10; for a list with hexadecimal X and Y use "
                            "--dialect q",
                            first.front(), first.front())
              : fmt::format("the devices are {} to {}", first, last));
    return;
  }
  // C235 to C255 of an FX count pulses of their own inputs.
  const auto number = read_number(name.substr(std::min<std::size_t>(1, name.size())), 10);
  if (dialect_ == Dialect::Fx && kind == DeviceKind::CS && number && *number >= 235 &&
      *number <= 255) {
    error(word, "a high-speed counter, hardware that this controller does not have");
    return;
  }
  error(word, fmt::format("beyond the last device of dialect {}", dialect_name(dialect_)),
        fmt::format("the devices are {} to {}", first, last));
}

std::optional<Device> OperandReader::device(const ListWord& word, std::string_view name) {
  // The high word of a counter has a name in traces only.
  const bool in_traces = name.find(':') != std::string_view::npos;
  const ParsedDevice parsed =
      in_traces ? ParsedDevice{DeviceError::Form, {}} : parse_device(name, dialect_);
  switch (parsed.error) {
    case DeviceError::None:
      return parsed.device;
    case DeviceError::Digit:
    case DeviceError::Range:
      explain(word, name, parsed.device.kind, parsed.error == DeviceError::Digit);
      return std::nullopt;
    case DeviceError::Special: {
      const Unsupported reason = special_reason(name, dialect_);
      error(word, reason.reason, reason.mend);
      return std::nullopt;
    }
    case DeviceError::Form:
      break;
  }
  if (const auto unsupported = unsupported_operand(name)) {
    error(word, unsupported->reason, unsupported->mend);
    return std::nullopt;
  }
  for (const Dialect other : {Dialect::Fx, Dialect::Q}) {
    const ParsedDevice there = parse_device(name, other);
    if (there.error == DeviceError::Form || in_traces) continue;
    error(word,
          fmt::format("{}, which dialect {} does not have", kind_name(there.device.kind),
                      dialect_name(dialect_)),
          fmt::format("if the program is for such a controller, use --dialect {}",
                      dialect_name(other)));
    return std::nullopt;
  }
  if (word.upper.find(',') != std::string::npos) {
    error(word, "not a device", "separate operands with blanks");
  } else if (is_digit(word.upper.front()) || word.upper.front() == '-') {
    error(word, "a number, not a device",
          fmt::format("a constant is written K{}", shown(word.upper)));
  } else {
    error(word, "not a device", "a device is a letter such as X, Y, M, D with a number: M10");
  }
  return std::nullopt;
}

std::optional<Operand> OperandReader::constant(const ListWord& word, int width) {
  const bool decimal = word.upper.front() == 'K';
  const std::string_view digits = std::string_view(word.upper).substr(1);
  const std::optional<std::int64_t> value =
      !decimal && digits.starts_with('-') ? std::nullopt : read_number(digits, decimal ? 10 : 16);
  if (!value) {
    error(word, "not a constant",
          "decimal constants are written K10 or K-10, hexadecimal ones H0A");
    return std::nullopt;
  }
  const std::int64_t half = 1LL << (width - 1);
  if (decimal ? *value < -half || *value >= half : *value >= 2 * half) {
    error(word, fmt::format("more than {} bits hold", width),
          decimal ? fmt::format("K goes from {} to {}", -half, half - 1)
                  : fmt::format("H goes from 0 to {:X}", 2 * half - 1));
    return std::nullopt;
  }
  Operand operand;
  operand.kind = Operand::Kind::Constant;
  operand.value = static_cast<std::int32_t>(*value >= half ? *value - 2 * half : *value);
  return operand;
}

std::optional<Operand> OperandReader::digits(const ListWord& word) {
  const std::string_view text = word.upper;
  const std::size_t letter = text.find_first_not_of("0123456789", 1);
  if (const std::size_t index = find_index(text); index != std::string_view::npos) {
    error(word, "a digit group with an index, which is not supported",
          "move the group to a word first, or address words");
    return std::nullopt;
  }
  const auto head = device(word, text.substr(letter));
  if (!head) return std::nullopt;
  const std::optional<std::int64_t> groups = read_number(text.substr(1, letter - 1), 10);
  Operand operand;
  operand.kind = Operand::Kind::Digits;
  operand.device = *head;
  operand.digits = static_cast<int>(std::min<std::int64_t>(groups.value_or(0), 99));
  return operand;
}

std::optional<Operand> OperandReader::word_bit(const ListWord& word, std::size_t dot) {
  const std::string_view text = word.upper;
  const std::string_view number = text.substr(dot + 1);
  const auto head = device(word, text.substr(0, dot));
  if (!head) return std::nullopt;
  const Device value = value_of(*head);
  if (!is_word(value) || value.kind == DeviceKind::V || value.kind == DeviceKind::Z ||
      is_timer(value.kind) || is_counter(value.kind)) {
    error(word, fmt::format("a bit of {}", kind_name(head->kind)),
          "bits are taken of data registers: D0.F");
    return std::nullopt;
  }
  if (number.size() != 1 || !is_hex_digit(number.front())) {
    error(word, "not a bit of a word", "the bits are .0 to .F");
    return std::nullopt;
  }
  Operand operand;
  operand.kind = Operand::Kind::WordBit;
  operand.device = value;
  operand.bit = static_cast<int>(read_number(number, 16).value_or(0));
  return operand;
}

std::optional<Operand> OperandReader::indexed(const ListWord& word, std::size_t at) {
  const std::string_view text = word.upper;
  if (is_constant(text)) {
    error(word, "a constant with an index, which is not supported",
          "add the index register to the constant in a register first");
    return std::nullopt;
  }
  const auto head = device(word, text.substr(0, at));
  if (!head) return std::nullopt;
  // FX: V and Z alone are V0 and Z0.
  std::string index(text.substr(at));
  if (index.size() == 1) index += '0';
  const auto register_ = device(word, index);
  if (!register_) return std::nullopt;
  Operand operand;
  operand.device = *head;
  operand.index = *register_;
  return operand;
}

std::optional<Operand> OperandReader::number(const ListWord& word, int most) {
  const auto value = read_number(std::string_view(word.upper).substr(1), 10);
  if (!value || *value > most) {
    error(word, fmt::format("beyond {}{}", word.upper.front(), most),
          fmt::format("write {0}0 to {0}{1}", word.upper.front(), most));
    return std::nullopt;
  }
  Operand operand;
  operand.kind = Operand::Kind::Number;
  operand.value = static_cast<std::int32_t>(*value);
  return operand;
}

std::optional<Operand> OperandReader::parse(const ListWord& word, int width) {
  const std::string_view text = word.upper;
  if (is_pointer_or_level(text)) {
    return number(word, text.front() == 'P' ? kLastPointer : kLastLevel);
  }
  const bool plain = text.find(',') == std::string_view::npos;
  if (plain && is_digit_group(text)) return digits(word);
  if (plain && !unsupported_operand(text)) {
    if (const std::size_t dot = text.find('.'); dot != std::string_view::npos && dot > 1) {
      return word_bit(word, dot);
    }
    if (const std::size_t at = find_index(text); at != std::string_view::npos) {
      return indexed(word, at);
    }
    if (is_constant(text)) return constant(word, width);
  }
  // FX: V and Z alone are V0 and Z0.
  const bool index = dialect_ == Dialect::Fx && (text == "V" || text == "Z");
  const auto found = device(word, index ? std::string(text) + "0" : std::string(text));
  if (!found) return std::nullopt;
  Operand operand;
  operand.device = *found;
  return operand;
}

}  // namespace rung
