// SPDX-License-Identifier: Apache-2.0
// From times and rates to clocks.
#pragma once

#include <cmath>
#include <cstdint>

namespace rung::load {

// Rounded; at most what `double` holds exactly.
inline std::int64_t clocks_of(std::int64_t microseconds, std::int64_t clock_hz) {
  return std::llround(static_cast<double>(microseconds) * static_cast<double>(clock_hz) / 1e6);
}

// Of the UARTs (hdl/peripherals/uart_tx.v): eighths of a bit a clock, in units of 2^-20.
inline constexpr double kFractionsABit = 8.0 * (1 << 20);
inline std::int64_t baud_step(std::int64_t baud, std::int64_t clock_hz) {
  return std::llround(kFractionsABit * static_cast<double>(baud) / static_cast<double>(clock_hz));
}

}  // namespace rung::load
