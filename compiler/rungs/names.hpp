// SPDX-License-Identifier: Apache-2.0
// What the names in a stimulus or a trace mean, and what a trace calls a device: the names of a
// dialect, or those that an LDmicro program gives. An image has them too, without the program.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "rungs/program.hpp"

namespace rung {

class DeviceNames {
 public:
  // Every device of a dialect of lists.
  DeviceNames(Dialect dialect) : dialect_(dialect) {}
  // Those of `program`, which need not outlive this.
  DeviceNames(const Program& program) : DeviceNames(program.dialect, program.names) {}
  // Of an LDmicro program only the devices in `names`.
  DeviceNames(Dialect dialect, std::map<Device, std::string> names);

  Dialect dialect() const { return dialect_; }
  // Whether the names are the program's, and it has no others.
  bool own() const { return dialect_ == Dialect::Ldmicro; }
  const std::map<Device, std::string>& all() const { return names_; }

  std::string name(Device device) const;
  // By the name that traces use. A variable and the channel that is read into it have the same one.
  std::optional<Device> device(std::string_view name) const;
  std::optional<Device> channel(std::string_view name) const;

 private:
  using Index = std::map<std::string, Device, std::less<>>;

  static std::optional<Device> find(const Index& index, std::string_view name);

  Dialect dialect_;
  std::map<Device, std::string> names_;  // empty for a list
  Index devices_, channels_;
};

}  // namespace rung
