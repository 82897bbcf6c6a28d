// SPDX-License-Identifier: Apache-2.0
#include "rungs/device.hpp"

#include <fmt/format.h>

#include "rungs/devices.hpp"
#include "rungs/ports.hpp"

namespace rung {

std::string_view dialect_name(Dialect dialect) {
  switch (dialect) {
    case Dialect::Paper:
      return "paper";
    case Dialect::Fx:
      return "fx";
    case Dialect::Q:
      return "q";
    case Dialect::Ldmicro:
      break;
  }
  return "ldmicro";
}

std::optional<Dialect> find_dialect(std::string_view name) {
  for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q, Dialect::Ldmicro}) {
    if (dialect_name(dialect) == name) return dialect;
  }
  return std::nullopt;
}

std::string device_name(Device device, Dialect dialect) {
  if (is_port(device.kind)) return port::name(device);
  if (device.kind == DeviceKind::CNH) {
    return device_name({DeviceKind::CN, device.number}, dialect) + ":h";
  }
  const std::string_view letters = kind_letters(device.kind);
  const DeviceRange* range = find_device_range(device.kind, dialect);
  switch (range != nullptr ? range->base : 10) {
    case 8:
      return fmt::format("{}{:o}", letters, device.number);
    case 16:
      return fmt::format("{}{:X}", letters, device.number);
    default:
      return fmt::format("{}{}", letters, device.number);
  }
}

}  // namespace rung
