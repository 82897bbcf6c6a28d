// SPDX-License-Identifier: Apache-2.0
// Special relays, and time: what a controller gives a program before each scan beside its inputs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rungs/device.hpp"

namespace rung {

enum class SpecialRole : std::uint8_t {
  // driven by the controller, read by programs
  On,
  Off,
  FirstScan,
  NotFirstScan,
  Clock,
  // written by instructions, and by programs
  Zero,
  Borrow,
  Carry,
  Error,
  // written by programs
  Direction,  // of a 32-bit counter: on counts down
};
inline bool is_driven(SpecialRole role) { return role <= SpecialRole::Clock; }

// Special relays first to last have this role; `period_us` is a clock's.
struct SpecialRange {
  Dialect dialect;
  DeviceKind kind;
  std::uint32_t first, last;
  SpecialRole role;
  std::int64_t period_us;
};
// The whole table (SEMANTICS.md).
std::span<const SpecialRange> special_ranges();
// The row of a special relay; null if it is none, or one that this controller does not have.
const SpecialRange* find_special(Device device, Dialect dialect);
// The relays of this role in `dialect`, ascending.
std::vector<Device> devices_of_role(SpecialRole role, Dialect dialect);

// When a scan happens: scan k at k times the tick.
struct ScanTime {
  std::int64_t scan = 0;
  std::int64_t tick_us = 10000;
};
// The value of a driven relay in a scan.
bool driven_value(const SpecialRange& special, ScanTime time);
// Ticks of `base_us` since the scan before; none in scan 0, at most 32767.
std::int16_t ticks_since_last(std::int64_t base_us, ScanTime time);

}  // namespace rung
