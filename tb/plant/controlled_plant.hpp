// SPDX-License-Identifier: Apache-2.0
// A plant with the simulated controller, through the pins, beside the reference, while a Modbus
// client polls at full speed.
#pragma once

#include <cstdint>
#include <string>

#include "plant/plant.hpp"

namespace rung::tb {

struct PlantRun {
  std::string board = "simulated";
  int period_ms = 10;  // from scan to scan
  std::int64_t plant_ms = 60'000;
};

struct PlantResult {
  std::string difference;  // the first one, or an accident; empty: none
  std::int64_t scans = 0;
  std::int64_t polls = 0;                           // replies that were those of one scan
  std::uint32_t least_clocks = 0, most_clocks = 0;  // of a scan, as the controller counts them
  std::int64_t expected_clocks = 0;                 // as the compiler does
  int overruns = 0;
  std::uint64_t clocks = 0, clocks_per_ms = 0;
};

// Each scan: the plant's inputs are at the pins, filtered, before the latch; all outputs are
// compared after the refresh. Each reply of the controller must be what the reference had after one
// scan between request and reply. Ends at the first difference.
PlantResult run_plant(Plant& plant, const PlantRun& run);

}  // namespace rung::tb
