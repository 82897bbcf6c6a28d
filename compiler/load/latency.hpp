// SPDX-License-Identifier: Apache-2.0
// How long a scan takes on the controller, all phases included, and how long an edge at an input
// pin may take to show at an output pin: bounds that hold for every input, client and line.
#pragma once

#include <cstdint>
#include <string>

#include "image/image.hpp"
#include "io/bind.hpp"

namespace rung::load {

// Entries of the io list.
struct Entries {
  int latch = 0;
  int refresh = 0;
};
Entries entries_of(const image::Image& image, const io::Bindings& bindings);

struct Timing {
  std::int64_t clock_hz = 0;
  // Clocks of the phases, and of the whole scan without the wait for its period. With flow tasks a
  // scan is a round; its clocks, and all that follows from them, are then bounds.
  std::int64_t latch = 0, scan = 0, refresh = 0, exchange = 0, cycle = 0;
  std::int64_t flow = 0;    // of `scan`, what is not the ladder's
  std::int64_t period = 0;  // from latch to latch: the cycle, or the minimum period if it is longer
  // Clocks from an edge at an input pin, of the slowest filter that is bound, to the last clock in
  // which the output pin can follow.
  std::int64_t worst = 0;
  std::int64_t best = 0;    // the least, without a filter
  std::int64_t pins = 0;    // of `worst`, the pins
  std::int64_t filter = 0;  // and the slowest filter
};
Timing timing_of(const image::Image& image, const io::Bindings& bindings, std::int64_t clock_hz);

// An error for a watchdog that the scan would trip, a warning for a period that it cannot keep; at
// the map's lines, or for a map that was made up at the file `program`.
void check_timing(const Timing& timing, const io::Map& map, const io::Bindings& bindings,
                  const std::string& program, Diagnostics& diagnostics);

std::string to_string(const Timing& timing);

}  // namespace rung::load
