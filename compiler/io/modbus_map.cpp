// SPDX-License-Identifier: Apache-2.0
#include "io/modbus_map.hpp"

#include "rung_controller.hpp"
#include "rungs/devices.hpp"

namespace rung::io {

std::string_view table_name(Table table) {
  switch (table) {
    case Table::Coil:
      return "coil";
    case Table::Discrete:
      return "discrete";
    case Table::Holding:
      break;
  }
  return "holding";
}

std::optional<Point> point_of(Device device, Dialect dialect, std::string_view config) {
  const bool high = device.kind == DeviceKind::CNH;
  const Device low = high ? Device{DeviceKind::CN, device.number} : device;
  const bool pair = low.kind == DeviceKind::CN && is_32_bit_counter(low, dialect);
  for (const controller::Area& area : controller::areas) {
    if (area.config != config || area.kind != low.kind || area.pairs != pair) continue;
    if (low.number < static_cast<std::uint32_t>(area.number)) continue;
    const std::uint32_t n = low.number - static_cast<std::uint32_t>(area.number);
    if (n >= static_cast<std::uint32_t>(area.count)) continue;
    const int offset = pair ? 2 * static_cast<int>(n) + (high ? 1 : 0) : static_cast<int>(n);
    if (offset >= area.count) continue;
    const Table table = is_word(low) ? Table::Holding : area.coils ? Table::Coil : Table::Discrete;
    return Point{table, area.first + offset, area.index + offset, area.first + area.count - 1};
  }
  return std::nullopt;
}

std::optional<Device> device_at(Table table, int address, Dialect dialect,
                                std::string_view config) {
  for (const controller::Area& area : controller::areas) {
    const int offset = address - area.first;
    if (area.config != config || is_word(area.kind) != (table == Table::Holding) || offset < 0 ||
        offset >= area.count) {
      continue;
    }
    const int n = area.pairs ? offset / 2 : offset;
    const bool high = area.pairs && offset % 2 != 0;
    const Device device{high ? DeviceKind::CNH : area.kind,
                        static_cast<std::uint32_t>(area.number + n)};
    const auto back = point_of(device, dialect, config);
    if (back && back->table == table && back->address == address) return device;
  }
  return std::nullopt;
}

}  // namespace rung::io
