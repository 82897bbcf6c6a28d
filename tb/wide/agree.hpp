// SPDX-License-Identifier: Apache-2.0
// A program on MPU4 beside the reference interpreter.
#pragma once

#include <string>

#include "lockstep/wide_processor.hpp"
#include "rungs/program.hpp"
#include "trace/stimulus.hpp"

namespace rung::tb {

struct WideHow {
  int slots = 8;
  bool merge = true;
  bool rtl = false;  // else the simulator alone
  std::int64_t tick_us = 10000;
};

// For all programs one MPU4 of each kind: what one program leaves in its registers must be nothing
// to the next.
WideProcessor& wide_processor(int slots, bool rtl);

// Runs as many scans as `stimulus` has. After each, all devices and ports are what the reference
// has; without merging each device has had the same sequence of values too. The clocks are those of
// the image. Empty, or the first difference; `clocks`, if given, gets the clocks of a scan.
std::string wide_difference(const Program& program, const Stimulus& stimulus, const WideHow& how,
                            std::int64_t* clocks = nullptr);

}  // namespace rung::tb
