// SPDX-License-Identifier: Apache-2.0
// The bits that the controller gives the program before each scan, in rows of one bit a slot.
#pragma once

#include <map>
#include <vector>

#include "rungs/device.hpp"
#include "wide/machine.hpp"

namespace rung::wide {

struct Latch {
  std::map<Device, int> position;  // row (from the first latch row) * slots + lane
  int rows = 0;

  // Row i is written as if in this step: before step 0.
  int step_of_row(int row) const {
    return row - (rows > constant::scan_latch_free ? rows : constant::scan_latch_free);
  }
  // The first step that can read the device.
  int ready(Device device, const Machine& machine) const {
    const auto found = position.find(device);
    if (found == position.end()) return 0;
    return step_of_row(found->second / machine.slots) + machine.other;
  }
};

// Those of `devices` in their order.
inline Latch make_latch(const std::vector<Device>& devices, const Machine& machine) {
  Latch latch;
  for (const Device device : devices) {
    latch.position.emplace(device, static_cast<int>(latch.position.size()));
  }
  const auto count = static_cast<int>(latch.position.size());
  latch.rows = (count + machine.slots - 1) / machine.slots;
  return latch;
}

}  // namespace rung::wide
