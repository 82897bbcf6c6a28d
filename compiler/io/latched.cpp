// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "io/bind.hpp"
#include "rungs/devices.hpp"
#include "source/text_file.hpp"

namespace rung::io {
namespace {

using enum DeviceKind;

// What an FX3U keeps before its parameters are changed: relays, states, registers and counters. A
// counter's contact and its value, of the 32-bit ones the high word too.
struct LatchedRange {
  DeviceKind kind;
  std::uint32_t first, last;
};
constexpr LatchedRange kFx[] = {{M, 500, 7679}, {S, 500, 999},  {D, 200, 7999}, {CS, 100, 199},
                                {CN, 100, 199}, {CS, 220, 234}, {CN, 220, 234}, {CNH, 220, 234}};

bool is_latched(Device device, Dialect dialect) {
  if (dialect == Dialect::Q) {
    return device.kind == L || device.kind == STS || device.kind == STN;
  }
  if (dialect == Dialect::Ldmicro) return false;  // PERSIST is its own
  for (const LatchedRange& range : kFx) {
    if (range.kind == device.kind && device.number >= range.first && device.number <= range.last) {
      return true;
    }
  }
  return (device.kind == TS || device.kind == TN) && dialect == Dialect::Fx &&
         timer_range(contact_of(device), dialect).retentive;
}

// All that is kept when `device` is: of a timer or counter contact and value.
void add(Device device, Dialect dialect, std::set<Device>& devices) {
  devices.insert(device);
  const Device contact = contact_of(device);
  if (contact == device && value_of(device) == device) return;
  devices.insert(contact);
  devices.insert(value_of(contact));
  if (is_32_bit_counter(contact, dialect)) devices.insert({CNH, contact.number});
}

class Reader {
 public:
  Reader(const Map& map, const Subject& subject, Diagnostics& diagnostics)
      : map_(map), subject_(subject), diagnostics_(diagnostics) {}

  std::vector<Device> run() {
    for (const Line& line : *map_.latched) read(line);
    return {devices_.begin(), devices_.end()};
  }

 private:
  // A range of a list goes over numbers; a name of an LDmicro program stands for itself.
  void read(const Line& line) {
    const bool whole = subject_.find(line.name, false).has_value();  // comments may have a dash
    const std::size_t dash = whole ? std::string::npos : line.name.find('-');
    const std::string low = line.name.substr(0, dash);
    const std::string high = dash == std::string::npos ? low : line.name.substr(dash + 1);
    const auto first = device_of(line, low);
    const auto last = device_of(line, high);
    if (!first || !last) return;
    if (first->kind != last->kind || first->number > last->number) {
      diagnostics_.error(map_.file, line.position,
                         fmt::format("{}: this is no range", shown(line.name)),
                         "write the first and the last device of one kind: M100-M199");
      return;
    }
    if (first->kind == X || first->kind == Y) {
      diagnostics_.error(map_.file, line.position,
                         fmt::format("{}: inputs and outputs cannot be kept", shown(line.name)),
                         "keep a relay that the program makes them of");
      return;
    }
    for (const SubjectDevice& each : subject_.devices) {
      if (each.device.kind == first->kind && each.device.number >= first->number &&
          each.device.number <= last->number) {
        add_with_partner(each.device);
      }
    }
  }

  void add_with_partner(Device device) {
    std::set<Device> all;
    add(device, subject_.dialect, all);
    for (const Device each : all) {
      if (subject_.has(each)) devices_.insert(each);
    }
  }

  std::optional<Device> device_of(const Line& line, const std::string& name) {
    const auto device = subject_.find(name, false);
    if (!device) {
      const std::string near = subject_.near(name);
      diagnostics_.error(map_.file, line.position,
                         fmt::format("{}: {} is neither a device nor a name of the program",
                                     shown(line.name), shown(name)),
                         near.empty()
                             ? "write a device, or the first and last of a range: M100-M199"
                             : fmt::format("did you mean {}?", near));
    }
    return device;
  }

  const Map& map_;
  const Subject& subject_;
  Diagnostics& diagnostics_;
  std::set<Device> devices_;
};

}  // namespace

std::vector<Device> latched_by_default(const Subject& subject) {
  std::vector<Device> devices;
  for (const SubjectDevice& each : subject.devices) {
    if (!is_port(each.device.kind) && is_latched(each.device, subject.dialect)) {
      devices.push_back(each.device);
    }
  }
  std::sort(devices.begin(), devices.end());
  return devices;
}

std::vector<Device> latched_of(const Map& map, const Subject& subject, Diagnostics& diagnostics) {
  return Reader(map, subject, diagnostics).run();
}

}  // namespace rung::io
