// SPDX-License-Identifier: Apache-2.0
#include "backends/c_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rungs/devices.hpp"

namespace rung {

CLayout::CLayout(const Program& program)
    : dialect_(program.dialect),
      devices_(named_devices(program)),
      named_(devices_.begin(), devices_.end()),
      windows_(index_windows(program)) {
  const auto reach = [&](DeviceKind kind, std::uint32_t last) {
    std::uint32_t& size = sizes_[static_cast<std::size_t>(kind)];
    size = std::max(size, last + 1);
  };
  for (const Device device : devices_) {
    if (!special(device)) reach(device.kind, device.number);
  }
  for (const IndexWindow& window : windows_) reach(window.kind, window.last);
}

std::vector<Device> CLayout::reachable() const {
  std::set<Device> devices = named_;
  for (const IndexWindow& window : windows_) {
    for (std::uint32_t n = window.first; n <= window.last; ++n) devices.insert({window.kind, n});
  }
  return {devices.begin(), devices.end()};
}

bool CLayout::special(Device device) const { return find_special(device, dialect_) != nullptr; }

std::string CLayout::array(DeviceKind kind) {
  return kind == DeviceKind::CNH ? "CNH" : std::string(kind_letters(kind));
}

std::string CLayout::number(Device device) const {
  const DeviceRange* const range = find_device_range(device.kind, dialect_);
  switch (range == nullptr ? 10 : range->base) {
    case 8:
      return fmt::format("{}{:o}", device.number > 7 ? "0" : "", device.number);
    case 16:
      return fmt::format("{}{:X}", device.number > 9 ? "0x" : "", device.number);
    default:
      return fmt::to_string(device.number);
  }
}

std::string CLayout::place(Device device) const {
  if (special(device)) return fmt::format("@.{}{}", array(device.kind), device.number);
  return fmt::format("@.{}[{}]", array(device.kind), number(device));
}

const IndexWindow& CLayout::window(DeviceKind kind) const {
  return *std::find_if(windows_.begin(), windows_.end(),
                       [&](const IndexWindow& window) { return window.kind == kind; });
}

std::vector<Device> CLayout::of_role(SpecialRole role) const {
  std::vector<Device> found;
  for (const Device device : devices_of_role(role, dialect_)) {
    if (names(device)) found.push_back(device);
  }
  return found;
}

}  // namespace rung
