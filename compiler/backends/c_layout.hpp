// SPDX-License-Identifier: Apache-2.0
// Where the devices of a program are kept in its C. A list's: special relays as variables of their
// own, all others in one array for each kind, by their numbers. An LDmicro program's: each as a
// variable with its name, b_Xdoor or w_count, so that no name of a program is anything else in C.
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "rungs/device.hpp"
#include "rungs/footprint.hpp"
#include "rungs/program.hpp"
#include "rungs/special.hpp"

namespace rung {

class CLayout {
 public:
  explicit CLayout(const Program& program);

  const std::vector<Device>& devices() const { return devices_; }
  // The device ports that the program uses, ascending.
  const std::vector<Device>& ports() const { return ports_; }
  bool has_port(Device port) const;
  // How many ports it uses of those that follow each other from `first` on.
  int ports_from(Device first, int count) const;
  // An LDmicro program's name of a device, which a bit and a variable may share.
  std::string name(Device device) const;
  // These and all that an index register may reach.
  std::vector<Device> reachable() const;
  bool names(Device device) const { return named_.contains(device); }
  bool special(Device device) const;
  // Of the array of this kind; 0 where there is none.
  std::uint32_t size(DeviceKind kind) const { return sizes_[static_cast<std::size_t>(kind)]; }
  // The kind's letters, which are the name of its array.
  static std::string array(DeviceKind kind);
  static std::string type(DeviceKind kind) { return is_word(kind) ? "int16_t" : "uint8_t"; }
  // A number as the dialect writes it: 010, 0x1F, 100.
  std::string number(Device device) const;
  // The variable that holds a device.
  std::string place(Device device) const;
  // A pointer to a device and those that follow it. Special relays are in no digit group or range.
  std::string pointer(Device first) const { return "&" + place(first); }
  // What an index register reaches. Asked of kinds that the program indexes.
  const IndexWindow& window(DeviceKind kind) const;
  // The special relays of this role that the program names.
  std::vector<Device> of_role(SpecialRole role) const;

 private:
  static std::string port_place(Device port);

  const Program& program_;
  Dialect dialect_;
  std::vector<Device> devices_;
  std::vector<Device> ports_;
  std::set<Device> named_;
  std::vector<IndexWindow> windows_;
  std::array<std::uint32_t, kDeviceKinds> sizes_{};
};

}  // namespace rung
