// SPDX-License-Identifier: Apache-2.0
#include "rungs/devices.hpp"

#include <algorithm>
#include <cctype>

namespace rung {
namespace {

// fx: X and Y as far as the FX3U's Modbus map goes (Y000-Y377), M and D below the special ones
// (M8000, D8000), as its programming manual lists them. paper: the paper shows single digits only
// and is by users of Mitsubishi's controllers, so its devices are those of fx. q: what a QnU CPU
// has before its parameters are changed.
constexpr DeviceRange kRanges[] = {
    {Dialect::Paper, DeviceKind::X, 8, 0377},  {Dialect::Paper, DeviceKind::Y, 8, 0377},
    {Dialect::Paper, DeviceKind::M, 10, 7679}, {Dialect::Paper, DeviceKind::D, 10, 7999},
    {Dialect::Fx, DeviceKind::X, 8, 0377},     {Dialect::Fx, DeviceKind::Y, 8, 0377},
    {Dialect::Fx, DeviceKind::M, 10, 7679},    {Dialect::Fx, DeviceKind::D, 10, 7999},
    {Dialect::Q, DeviceKind::X, 16, 0x1FFF},   {Dialect::Q, DeviceKind::Y, 16, 0x1FFF},
    {Dialect::Q, DeviceKind::M, 10, 8191},     {Dialect::Q, DeviceKind::D, 10, 12287},
};

std::optional<DeviceKind> kind_of(char letter) {
  switch (std::toupper(static_cast<unsigned char>(letter))) {
    case 'X':
      return DeviceKind::X;
    case 'Y':
      return DeviceKind::Y;
    case 'M':
      return DeviceKind::M;
    case 'D':
      return DeviceKind::D;
    default:
      return std::nullopt;
  }
}

int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  return std::toupper(static_cast<unsigned char>(c)) - 'A' + 10;
}

}  // namespace

std::span<const DeviceRange> device_ranges() { return kRanges; }

const DeviceRange& device_range(DeviceKind kind, Dialect dialect) {
  return *std::find_if(std::begin(kRanges), std::end(kRanges), [&](const DeviceRange& range) {
    return range.kind == kind && range.dialect == dialect;
  });
}

ParsedDevice parse_device(std::string_view text, Dialect dialect) {
  if (text.size() < 2) return {DeviceError::Form, {}};
  const std::optional<DeviceKind> kind = kind_of(text.front());
  if (!kind) return {DeviceError::Form, {}};
  const std::string_view digits = text.substr(1);
  const bool well_formed = std::all_of(digits.begin(), digits.end(),
                                       [](unsigned char c) { return std::isxdigit(c) != 0; });
  const DeviceRange& range = device_range(*kind, dialect);
  // XA is a device where numbers are hexadecimal, and else some other word.
  const bool begins_with_digit = std::isdigit(static_cast<unsigned char>(digits.front())) != 0;
  if (!well_formed || (!begins_with_digit && range.base != 16)) return {DeviceError::Form, {}};
  std::uint64_t number = 0;
  for (const char c : digits) {
    const int value = digit_value(c);
    if (value >= range.base) return {DeviceError::Digit, {*kind, 0}};
    number = number * static_cast<unsigned>(range.base) + static_cast<unsigned>(value);
    number = std::min<std::uint64_t>(number, UINT32_MAX);
  }
  if (number > range.last) return {DeviceError::Range, {*kind, 0}};
  return {DeviceError::None, {*kind, static_cast<std::uint32_t>(number)}};
}

std::optional<Device> parse_device_name(std::string_view text, Dialect dialect) {
  const ParsedDevice parsed = parse_device(text, dialect);
  if (parsed.error != DeviceError::None) return std::nullopt;
  return parsed.device;
}

}  // namespace rung
