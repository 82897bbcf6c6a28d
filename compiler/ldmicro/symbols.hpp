// SPDX-License-Identifier: Apache-2.0
// The names of an LDmicro program and the devices that they become.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "rungs/device.hpp"

namespace rung {

// Letters, digits and `_`, of which the first is no digit.
bool is_ld_name(std::string_view text);

// A name is one device as a bit and another as a variable. Numbers count from 0 in the order in
// which the file names the devices of a kind.
class LdSymbols {
 public:
  Device bit(const std::string& name);
  Device variable(const std::string& name);
  // The analogue channel of a variable; the next one if it has none.
  Device channel(const std::string& name);
  int channels() const { return static_cast<int>(channels_.size()); }
  bool has_variable(const std::string& name) const { return variables_.count(name) != 0; }

  // What traces call the devices (Program::names).
  std::map<Device, std::string> names() const;

 private:
  Device next(std::map<std::string, Device>& devices, const std::string& name, DeviceKind kind);

  std::map<std::string, Device> bits_, variables_, channels_;
  std::map<DeviceKind, std::uint32_t> used_;
};

}  // namespace rung
