// SPDX-License-Identifier: Apache-2.0
// The devices that a program can name: their ranges and the number bases of their names.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "rungs/program.hpp"

namespace rung {

// The devices of one kind in one dialect: numbers 0 to `last`, written in `base`.
struct DeviceRange {
  Dialect dialect;
  DeviceKind kind;
  int base;
  std::uint32_t last;
};

// The whole table.
std::span<const DeviceRange> device_ranges();
// Its row for `kind` in `dialect`.
const DeviceRange& device_range(DeviceKind kind, Dialect dialect);

enum class DeviceError : std::uint8_t {
  None,
  Form,   // not one of the letters X Y M D and then letters or digits
  Digit,  // a digit that the number base lacks
  Range,  // a number beyond the last device
};

struct ParsedDevice {
  DeviceError error = DeviceError::None;
  Device device;  // on Digit and Range only its kind holds
};

// Reads a device name of X, Y, M or D; either case, leading zeros allowed.
ParsedDevice parse_device(std::string_view text, Dialect dialect);

// The same for those to whom the reason of a failure is all one.
std::optional<Device> parse_device_name(std::string_view text, Dialect dialect);

}  // namespace rung
