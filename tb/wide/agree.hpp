// SPDX-License-Identifier: Apache-2.0
// A program on MPU4's simulator beside the reference interpreter.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "driver/compile.hpp"
#include "trace/stimulus.hpp"

namespace rung::tb {

struct WideHow {
  int slots = 8;
  bool merge = true;
  std::int64_t tick_us = 10000;
};

// Runs as many scans as `stimulus` has. After each, all devices are what the reference has; without
// merging each device has had the same sequence of values too. The clocks are those of the image.
// Empty, or the first difference; `clocks`, if given, gets the clocks of a scan.
std::string wide_difference(const Program& program, const Stimulus& stimulus, const WideHow& how,
                            std::int64_t* clocks = nullptr);

}  // namespace rung::tb
