// SPDX-License-Identifier: Apache-2.0
#include "melsec/operands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include "melsec/unsupported.hpp"
#include "rungs/devices.hpp"

namespace rung {
namespace {

// First and last number of an FX's special relays (M) and registers (D).
constexpr int kFirstSpecial = 8000;
constexpr int kLastSpecial = 8511;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string_view kind_name(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::X:
      return "an input";
    case DeviceKind::Y:
      return "an output";
    case DeviceKind::M:
      return "a relay";
    case DeviceKind::D:
      break;
  }
  return "a word";
}

// The number that all of `digits` is, or nothing.
std::optional<long> read_number(std::string_view digits, int base) {
  long value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, failure] = std::from_chars(digits.data(), end, value, base);
  if (failure == std::errc::result_out_of_range)
    return digits.front() == '-' ? -1L << 40U : 1L << 40U;
  if (failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace

bool looks_like_operand(std::string_view upper) {
  if (unsupported_operand(upper)) return true;
  if (upper.size() < 2 ||
      std::string_view("XYMDKH").find(upper.front()) == std::string_view::npos) {
    return false;
  }
  if (upper.front() == 'H') return std::isxdigit(static_cast<unsigned char>(upper[1])) != 0;
  return is_digit(upper[1]) || (upper.size() > 2 && upper[1] == '-' && is_digit(upper[2])) ||
         parse_device(upper, Dialect::Q).error == DeviceError::None;
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

bool OperandReader::is_constant(const ListWord& word) const {
  const std::string& text = word.upper;
  return !text.empty() && (text.front() == 'K' || text.front() == 'H') &&
         text.find(',') == std::string::npos && !unsupported_operand(text);
}

void OperandReader::explain(const ListWord& word, Device parsed, bool digit) {
  const DeviceRange& range = device_range(parsed.kind, dialect_);
  const std::string first = device_name({parsed.kind, 0}, dialect_);
  const std::string last = device_name({parsed.kind, range.last}, dialect_);
  if (digit) {
    const bool octal = range.base == 8;
    const bool q_has_it = parse_device(word.upper, Dialect::Q).error == DeviceError::None;
    error(word,
          fmt::format("not {}: its numbers are {} in dialect {}", kind_name(parsed.kind),
                      octal ? "octal (digits 0 to 7)" : "decimal", dialect_name(dialect_)),
          octal && q_has_it
              ? fmt::format("after {}7 comes {}10; for a list with hexadecimal X and Y use "
                            "--dialect q",
                            first.front(), first.front())
              : fmt::format("the devices are {} to {}", first, last));
    return;
  }
  const std::optional<long> number = read_number(std::string_view(word.upper).substr(1), 10);
  if (range.base == 10 && dialect_ != Dialect::Q && number && *number >= kFirstSpecial &&
      *number <= kLastSpecial) {
    error(word, fmt::format("a special {}, not supported yet",
                            parsed.kind == DeviceKind::M ? "relay" : "register"));
    return;
  }
  error(word, fmt::format("beyond the last device of dialect {}", dialect_name(dialect_)),
        fmt::format("the devices are {} to {}", first, last));
}

std::optional<Device> OperandReader::device(const ListWord& word) {
  const ParsedDevice parsed = parse_device(word.upper, dialect_);
  switch (parsed.error) {
    case DeviceError::None:
      return parsed.device;
    case DeviceError::Digit:
    case DeviceError::Range:
      explain(word, parsed.device, parsed.error == DeviceError::Digit);
      return std::nullopt;
    case DeviceError::Form:
      break;
  }
  if (const auto unsupported = unsupported_operand(word.upper)) {
    error(word, unsupported->reason, unsupported->mend);
  } else if (word.upper.find(',') != std::string::npos) {
    error(word, "not a device", "separate operands with blanks");
  } else if (is_digit(word.upper.front()) || word.upper.front() == '-') {
    error(word, "a number, not a device",
          fmt::format("a constant is written K{}", shown(word.upper)));
  } else {
    error(word, "not a device", "the devices are X, Y, M and D with a number, such as M10");
  }
  return std::nullopt;
}

std::optional<Device> OperandReader::contact(const ListWord& word) {
  if (is_constant(word)) {
    error(word, "a constant where a bit is read", "name an X, Y or M");
    return std::nullopt;
  }
  const std::optional<Device> device = this->device(word);
  if (device && is_word(*device)) {
    error(word, "a word where a bit is read", "name an X, Y or M");
    return std::nullopt;
  }
  return device;
}

std::optional<Device> OperandReader::coil(const ListWord& word) {
  if (is_constant(word)) {
    error(word, "a constant cannot be written", "name a Y or M");
    return std::nullopt;
  }
  const std::optional<Device> device = this->device(word);
  if (!device) return std::nullopt;
  if (is_word(*device)) {
    error(word, "a word where a bit is written",
          dialect_ == Dialect::Paper ? "name a Y or M; a word is written by MV"
                                     : "name a Y or M; a word is written by MOV");
    return std::nullopt;
  }
  if (device->kind == DeviceKind::X) {
    error(word, "an input, and inputs cannot be written", "name a Y or M");
    return std::nullopt;
  }
  return device;
}

std::optional<Device> OperandReader::coil_or_word(const ListWord& word) {
  const ParsedDevice parsed = parse_device(word.upper, dialect_);
  if (parsed.error == DeviceError::None && is_word(parsed.device)) return parsed.device;
  return coil(word);
}

std::optional<WordSource> OperandReader::constant(const ListWord& word) {
  const bool decimal = word.upper.front() == 'K';
  const std::string_view digits = std::string_view(word.upper).substr(1);
  const std::optional<long> value =
      !decimal && digits.starts_with('-') ? std::nullopt : read_number(digits, decimal ? 10 : 16);
  if (!value) {
    error(word, "not a constant",
          "decimal constants are written K10 or K-10, hexadecimal ones H0A");
    return std::nullopt;
  }
  if (decimal ? *value < INT16_MIN || *value > INT16_MAX : *value > UINT16_MAX) {
    error(word, "more than 16 bits hold",
          decimal ? "K goes from -32768 to 32767" : "H goes from 0 to FFFF");
    return std::nullopt;
  }
  WordSource source;
  source.value = static_cast<std::int16_t>(static_cast<std::uint16_t>(*value));
  return source;
}

std::optional<WordSource> OperandReader::source(const ListWord& word) {
  if (is_constant(word)) return constant(word);
  const std::optional<Device> device = this->device(word);
  if (!device) return std::nullopt;
  if (!is_word(*device)) {
    error(word, fmt::format("{} where a word is read", kind_name(device->kind)),
          "name a D, or a constant such as K10");
    return std::nullopt;
  }
  WordSource source;
  source.constant = false;
  source.device = *device;
  return source;
}

std::optional<Device> OperandReader::target(const ListWord& word, bool double_width) {
  if (is_constant(word)) {
    error(word, "a constant cannot be written", "the last operand is the target: name a D");
    return std::nullopt;
  }
  const std::optional<Device> device = this->device(word);
  if (!device) return std::nullopt;
  if (!is_word(*device)) {
    error(word, fmt::format("{} where a word is written", kind_name(device->kind)),
          "the last operand is the target: name a D");
    return std::nullopt;
  }
  const std::uint32_t last = device_range(DeviceKind::D, dialect_).last;
  if (double_width && device->number == last) {
    error(word, "the result takes two words, and there is none after this",
          fmt::format("name D{} or below", last - 1));
    return std::nullopt;
  }
  return device;
}

}  // namespace rung
