// SPDX-License-Identifier: Apache-2.0
#include "hardwired/interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "rungs/footprint.hpp"

namespace rung::hardwired {

std::string literal(Device device, std::int16_t value) {
  return is_word(device) ? fmt::format("16'h{:04X}", static_cast<std::uint16_t>(value))
                         : fmt::format("1'b{}", value != 0 ? 1 : 0);
}

Interface::Interface(const Program& source, const core::Program& program,
                     const logic::Logic& logic) {
  std::set<Device> shown;
  for (const Device device : visible_devices(source)) shown.insert(device);
  for (const Device device : core::devices(program)) {
    if (is_port(device.kind)) shown.insert(device);
  }
  for (const Device device : shown) {
    const bool written = logic.current(device, logic::kNever) != logic::kStart;
    if (device.kind == DeviceKind::X && !written) {
      starts_[device] = {Start::Kind::Given, fmt::format("in_i[{}]", inputs.size())};
      inputs.push_back(device);
    }
    if (device.kind == DeviceKind::Y) outputs.push_back(device);
    const SpecialRange* special = find_special(device, source.dialect);
    if (special != nullptr && is_driven(special->role)) drive(device, *special, written);
    state_bits[device] = state_width;
    state_width += is_word(device) ? 16 : 1;
    state.push_back(device);
  }
  for (const core::TickWord& word : program.ticks) {
    starts_[word.device] = {Start::Kind::Given,
                            fmt::format("ticks_i[{} +: 16]", 16 * ticks.size())};
    ticks.push_back(word.base_us);
  }
  for (const core::ConstantWord& word : program.constants) {
    starts_[word.device] = {Start::Kind::Fixed, literal(word.device, word.value)};
  }
}

void Interface::drive(Device device, const SpecialRange& special, bool written) {
  Start start;
  start.kind = Start::Kind::Given;
  switch (special.role) {
    case SpecialRole::FirstScan:
    case SpecialRole::NotFirstScan:
      first_scan_ = true;
      start.text = special.role == SpecialRole::FirstScan ? "first_q" : "~first_q";
      break;
    case SpecialRole::Clock:
      start.text = fmt::format("clocks_i[{}]", clocks.size());
      clocks.push_back(device);
      break;
    default:
      // A program may write it: it is driven again before the next scan.
      if (!written) start.kind = Start::Kind::Fixed;
      start.text = literal(device, special.role == SpecialRole::On ? 1 : 0);
  }
  starts_[device] = start;
}

const Start& Interface::start(Device device) const {
  static const Start kRegister;
  const auto found = starts_.find(device);
  return found == starts_.end() ? kRegister : found->second;
}

const std::string& Names::of(Device device) {
  const auto [place, fresh] = names_.try_emplace(device);
  if (!fresh) return place->second;
  std::string name;
  if (is_hidden(device.kind) && !is_port(device.kind)) {
    name = is_word(device) ? "hidden_w" : "hidden";  // numbered below
  } else {
    for (const char c : device_name(device, source_)) {
      const auto byte = static_cast<unsigned char>(c);
      name += byte < 0x80 && std::isalnum(byte) != 0 ? static_cast<char>(std::tolower(byte)) : '_';
    }
    if (name.empty() || std::isalpha(static_cast<unsigned char>(name[0])) == 0) name.insert(0, "d");
  }
  // `a__2` is no name that the rules above give to another device with the number of uses below 2.
  const int uses = ++used_[name];
  if (uses > 1 || is_hidden(device.kind)) name += fmt::format("__{}", uses);
  while (uses > 1 && used_.contains(name)) name += "_";
  ++used_[name];
  return place->second = name;
}

}  // namespace rung::hardwired
