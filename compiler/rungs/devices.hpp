// SPDX-License-Identifier: Apache-2.0
// The devices that a program can name: their ranges and the number bases of their names.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "rungs/device.hpp"

namespace rung {

// The devices of one kind in one dialect: numbers `first` to `last`, written in `base`.
struct DeviceRange {
  Dialect dialect;
  DeviceKind kind;
  int base;
  std::uint32_t last;
  std::uint32_t first = 0;
};

// The whole table; special devices (special.hpp) are not in it.
std::span<const DeviceRange> device_ranges();
// Its row for `kind` in `dialect`, or null: the dialect has no such devices.
const DeviceRange* find_device_range(DeviceKind kind, Dialect dialect);
// The same where there is one.
const DeviceRange& device_range(DeviceKind kind, Dialect dialect);
// What stands before the number in the name of a device: "X", "SM", "TN".
std::string_view kind_letters(DeviceKind kind);

// fx C200 and above count in 32 bits. Takes contact or value.
bool is_32_bit_counter(Device counter, Dialect dialect);
// The second word of a 32-bit operand at `device`: the next one; of a 32-bit counter its high word.
Device high_word(Device device, Dialect dialect);
// Contact and value of a timer or counter, from either. Any other device is returned as it is.
Device contact_of(Device device);
Device value_of(Device device);
// TS STS CS, TN STN CN.
bool is_timer(DeviceKind kind);
bool is_counter(DeviceKind kind);

// How the timers from number `first` to `last` of a kind count.
struct TimerRange {
  Dialect dialect;
  DeviceKind kind;  // TS or STS
  std::uint32_t first, last;
  std::int64_t base_us;
  bool retentive;
};
// Of the timer with this contact (SEMANTICS.md); q's OUTH takes a tenth of `base_us`.
const TimerRange& timer_range(Device contact, Dialect dialect);

enum class DeviceError : std::uint8_t {
  None,
  Form,     // not the letters of a kind of device and then letters or digits
  Digit,    // a digit that the number base lacks
  Range,    // a number beyond the last device
  Special,  // a special device that this controller does not have
};

struct ParsedDevice {
  DeviceError error = DeviceError::None;
  Device device;  // on Digit, Range and Special only its kind holds
};

// Reads a device name in either case, leading zeros allowed. A timer or counter, T5, gives its
// contact; the names of traces, TN5, CN200:h, are read too.
ParsedDevice parse_device(std::string_view text, Dialect dialect);

// The same for those to whom the reason of a failure is all one.
std::optional<Device> parse_device_name(std::string_view text, Dialect dialect);

}  // namespace rung
