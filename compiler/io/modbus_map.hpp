// SPDX-License-Identifier: Apache-2.0
// Where Modbus clients find a device: the one place that computes it, from hdl/isa/modbus.toml and
// the counts of a configuration.
#pragma once

#include <optional>
#include <string_view>

#include "rungs/device.hpp"

namespace rung::io {

enum class Table { Coil, Discrete, Holding };
// "coil", "discrete", "holding"
std::string_view table_name(Table table);

struct Point {
  Table table = Table::Coil;
  int address = 0;
  int index = 0;  // in the device map of its table, bits or words
  int last = 0;   // address up to which its area goes
};

// Nothing if the areas of `config` do not have the device. Of a 32-bit counter each word has its
// own.
std::optional<Point> point_of(Device device, Dialect dialect, std::string_view config);

// The device of an address, of those that the dialect has; the reverse of point_of.
std::optional<Device> device_at(Table table, int address, Dialect dialect, std::string_view config);

}  // namespace rung::io
