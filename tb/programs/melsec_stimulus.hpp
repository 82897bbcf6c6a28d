// SPDX-License-Identifier: Apache-2.0
// What a random program is given in each scan: inputs, presets, time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rungs/device.hpp"
#include "trace/stimulus.hpp"

namespace rung {

// The events of `scans` scans for the devices that a program names: inputs come and go, words begin
// with corner values or small numbers, and now and then a device is preset between two scans.
std::vector<std::vector<StimulusEvent>> melsec_stimulus(std::uint64_t seed,
                                                        std::span<const Device> named,
                                                        Dialect dialect, int scans);

// The tick of program number `seed`, from far below the shortest time base to far above the
// longest.
std::int64_t melsec_tick_us(std::uint64_t seed);

}  // namespace rung
