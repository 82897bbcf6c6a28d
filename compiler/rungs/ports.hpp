// SPDX-License-Identifier: Apache-2.0
// Device ports: devices through which a program meets the controller's peripherals. The table, and
// what each means, is hdl/isa/ports.toml.
#pragma once

#include <cstdint>
#include <string>

#include "rungs/device.hpp"

namespace rung::port {

// Port `name` as a device, and how many there are of it, one behind the other.
#define RUNG_PORT(name, kind, number, count)              \
  inline constexpr Device name{DeviceKind::kind, number}; \
  inline constexpr int name##_count = count;
#include "ports.inc"

// Number `i` of several.
constexpr Device at(Device first, int i) {
  return {first.kind, first.number + static_cast<std::uint32_t>(i)};
}

// "uart_rx_full", "adc2": the name in the table, numbered where there are several.
std::string name(Device port);

}  // namespace rung::port
