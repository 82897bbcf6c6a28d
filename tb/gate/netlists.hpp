// SPDX-License-Identifier: Apache-2.0
// The netlists of scripts/flow/gate.py, each beside its RTL (paired.hpp).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gate/paired.hpp"
#include "lockstep/any_machine.hpp"

namespace rung::tb {

// A netlist that there is.
struct NetlistInfo {
  std::string name;
  isa::Mpu mpu;
  const isa::Config* config;
  int slots;  // of MPU4, else 0
};
// Those of the library that is linked: rung_gate has them as synthesised, rung_gate_faults those
// whose LUTs can be made wrong, by gate_state.fault.
const std::vector<NetlistInfo>& netlists();

// The netlist and its RTL with an image on them. Throws std::runtime_error where they differ, now
// and in all that is done with the machine.
LoadedMachine load_netlist(const NetlistInfo& netlist, const image::Image& image,
                           std::int64_t tick_us);

// Reads all devices of a processor (of MPU4 all places of a program) through the load port.
void read_all(const NetlistInfo& netlist, const image::Image& image, DeviceMemory& memory);

}  // namespace rung::tb
