// SPDX-License-Identifier: Apache-2.0
#include "rungs/names.hpp"

#include <utility>

#include "rungs/devices.hpp"

namespace rung {

DeviceNames::DeviceNames(Dialect dialect, std::map<Device, std::string> names)
    : dialect_(dialect), names_(std::move(names)) {
  for (const auto& [device, name] : names_) {
    (is_port(device.kind) ? channels_ : devices_).emplace(name, device);
  }
}

std::string DeviceNames::name(Device device) const {
  const auto found = names_.find(device);
  return found == names_.end() ? device_name(device, dialect_) : found->second;
}

std::optional<Device> DeviceNames::device(std::string_view name) const {
  return own() ? find(devices_, name) : parse_device_name(name, dialect_);
}

std::optional<Device> DeviceNames::channel(std::string_view name) const {
  return find(channels_, name);
}

std::optional<Device> DeviceNames::find(const Index& index, std::string_view name) {
  const auto found = index.find(name);
  if (found == index.end()) return std::nullopt;
  return found->second;
}

}  // namespace rung
