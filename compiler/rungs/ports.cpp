// SPDX-License-Identifier: Apache-2.0
#include "rungs/ports.hpp"

#include <fmt/format.h>

#include <string_view>

namespace rung::port {
namespace {

struct Row {
  std::string_view name;
  Device first;
  std::uint32_t count;
};

constexpr Row kRows[] = {
#define RUNG_PORT(name, kind, number, count) {#name, {DeviceKind::kind, number}, count},
#include "ports.inc"
};

}  // namespace

std::string name(Device port) {
  for (const Row& row : kRows) {
    const std::uint32_t i = port.number - row.first.number;
    if (port.kind != row.first.kind || i >= row.count) continue;
    return row.count == 1 ? std::string(row.name) : fmt::format("{}{}", row.name, i);
  }
  return fmt::format("port{}", port.number);
}

}  // namespace rung::port
