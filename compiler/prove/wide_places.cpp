// SPDX-License-Identifier: Apache-2.0
#include "prove/wide_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "rungs/special.hpp"

namespace rung::prove {

WidePlaces::WidePlaces(const image::Image& image, const image::Meaning& meaning,
                       const wide::Machine& machine)
    : image_(image), wide_(*image.wide), meaning_(meaning), machine_(machine) {
  std::set<Device> all;
  for (const auto& [device, address] : meaning.places) all.insert(device);
  for (const core::ConstantWord& word : meaning.program.constants) all.insert(word.device);
  int bits = 0;
  int words = 0;
  for (const Device device : all) {
    numbers_[device] = is_word(device) ? words++ : bits++;
    devices_[in_start(device)] = device;
  }
}

Device WidePlaces::device_at(Place in_start) const { return devices_.at(in_start); }

std::string WidePlaces::name(Device device) const {
  for (const image::ImageDevice& each : image_.devices) {
    if (each.device == device) return each.name;
  }
  const char* kind = is_word(device) ? "word" : "bit";
  if (is_port(device.kind)) return fmt::format("port {} {}", kind, device.number);
  return fmt::format("the compiler's {} {}", kind, device.number);
}

std::optional<std::string> WidePlaces::check() const {
  for (const auto& each :
       {&WidePlaces::check_sizes, &WidePlaces::check_named, &WidePlaces::check_latch}) {
    if (auto problem = (this->*each)()) return problem;
  }
  return std::nullopt;
}

std::optional<std::string> WidePlaces::check_sizes() const {
  const auto steps = static_cast<int>(wide_.code.size());
  if (steps < 1 || steps > machine_.steps) return fmt::format("{} steps", steps);
  if (wide_.latch_rows < 0 || wide_.first_latch_row < steps ||
      wide_.first_latch_row + wide_.latch_rows > machine_.rows ||
      static_cast<int>(wide_.latched.size()) > wide_.latch_rows * machine_.slots) {
    return "the rows of the latch lie among those of the steps, or beyond the memory";
  }
  for (const auto& [device, address] : meaning_.places) {
    const bool word = is_word(device);
    const int size = word ? machine_.word_rows * machine_.units : machine_.rows * machine_.slots;
    if (address < 0 || address >= size) return name(device) + " is beyond the memory";
  }
  return std::nullopt;
}

std::optional<std::string> WidePlaces::check_named() const {
  const auto is_at = [&](Device device, int address) {
    const auto found = meaning_.places.find(device);
    return found != meaning_.places.end() && found->second == address;
  };
  for (const image::ImageDevice& each : image_.devices) {
    if (!is_at(each.device, each.address)) return each.name + " is not where the image says";
  }
  for (const image::WidePort& each : wide_.ports) {
    if (!is_at(each.device, each.address)) return name(each.device) + " is not where it has to be";
  }
  for (const auto& [device, address] : meaning_.places) {
    const auto is_this = [&](const image::WidePort& port) { return port.device == device; };
    if (is_port(device.kind) && std::none_of(wide_.ports.begin(), wide_.ports.end(), is_this)) {
      return name(device) + " is none of the image's";
    }
  }
  for (const core::TickWord& word : meaning_.program.ticks) {
    const int address = meaning_.places.at(word.device);
    const auto there = [&](const image::ImageTicks& ticks) {
      return ticks.address == address && ticks.base_us == word.base_us;
    };
    if (std::none_of(image_.ticks.begin(), image_.ticks.end(), there)) {
      return name(word.device) + " gets no ticks in the image";
    }
  }
  return std::nullopt;
}

bool WidePlaces::is_latch(Device device, int address) const {
  const int row = address / machine_.slots;
  return !is_word(device) && row >= wide_.first_latch_row &&
         row < wide_.first_latch_row + wide_.latch_rows;
}

// What the controller gives the program before a scan comes by the latch, and only that.
std::optional<std::string> WidePlaces::check_latch() const {
  std::set<Device> latched;
  for (std::size_t i = 0; i < wide_.latched.size(); ++i) {
    const int number = wide_.latched[i];
    if (number < 0 || number >= static_cast<int>(image_.devices.size())) {
      return fmt::format("position {} of the latch has no device", i);
    }
    const image::ImageDevice& device = image_.devices[static_cast<std::size_t>(number)];
    latched.insert(device.device);
    if (is_word(device.device) ||
        device.address != wide_.first_latch_row * machine_.slots + static_cast<int>(i)) {
      return device.name + " is not where the latch puts it";
    }
  }
  std::set<Device> written;
  for (const core::Instruction& instruction : meaning_.program.instructions) {
    if (core::is_output(instruction.op)) {
      written.insert(instruction.targets.begin(), instruction.targets.end());
    }
  }
  const auto dialect = find_dialect(image_.dialect);
  for (const image::ImageDevice& each : image_.devices) {
    const Device device = each.device;
    const bool in_latch = latched.contains(device);
    if (is_latch(device, each.address) && !in_latch) {
      return each.name + " is in a row of the latch, which does not have it";
    }
    const SpecialRange* special = dialect ? find_special(device, *dialect) : nullptr;
    const bool driven = special != nullptr && is_driven(special->role);
    if (!is_word(device) && (device.kind == DeviceKind::X || driven) && !written.contains(device) &&
        !in_latch) {
      return each.name + " is an input that the latch does not have";
    }
  }
  return std::nullopt;
}

std::map<Place, Word> WidePlaces::memory(Start& start) const {
  std::map<Place, Word> out;
  std::set<Place> shared;
  for (const auto& [device, address] : meaning_.places) {
    if (is_latch(device, address)) continue;
    const Place place{is_word(device), address};
    if (!out.emplace(place, start.at(in_start(device))).second) shared.insert(place);
  }
  for (const Place place : shared) out.erase(place);
  return out;
}

std::vector<Bit> WidePlaces::latched(Start& start) const {
  std::vector<Bit> out;
  for (const int number : wide_.latched) {
    const Device device = image_.devices[static_cast<std::size_t>(number)].device;
    out.push_back(start.at(in_start(device))[0]);
  }
  return out;
}

}  // namespace rung::prove
