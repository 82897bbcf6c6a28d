// SPDX-License-Identifier: Apache-2.0
#include "wide/wide_machine.hpp"

#include <fmt/format.h>

namespace rung::tb {

WideMachine::WideMachine(const image::Image& image, std::int64_t tick_us)
    : image_(image),
      wide_(image.wide.value()),
      machine_(*wide::find_machine(wide_.slots)),
      simulator_(machine_),
      inputs_(wide_.latched.size(), 0),
      values_(image.devices.size(), 0),
      time_{0, image.cycle_us > 0 ? image.cycle_us : tick_us} {
  const Dialect dialect = find_dialect(image.dialect).value();
  for (std::size_t i = 0; i < image.devices.size(); ++i) {
    const Device device = image.devices[i].device;
    if (is_port(device.kind)) continue;
    by_device_[device] = static_cast<int>(i);
    const SpecialRange* special = find_special(device, dialect);
    if (special != nullptr && is_driven(special->role)) {
      driven_.emplace_back(static_cast<int>(i), special);
    }
  }
  for (const image::WidePort& port : wide_.ports) ports_[port.device] = port.address;
  for (std::size_t i = 0; i < wide_.latched.size(); ++i) {
    latched_[wide_.latched[i]] = static_cast<int>(i);
  }
  for (std::size_t step = 0; step < wide_.code.size(); ++step) {
    for (int slot = 0; slot < machine_.slots; ++slot) {
      simulator_.load(static_cast<int>(step), slot, wide_.code[step][slot]);
    }
  }
  simulator_.set_program(static_cast<int>(wide_.code.size()), wide_.first_latch_row,
                         wide_.latch_rows);
}

int WideMachine::find(Device device) const {
  const auto found = by_device_.find(device);
  return found == by_device_.end() ? -1 : found->second;
}

void WideMachine::put(Device device, int address, std::int16_t value) {
  if (is_word(device)) {
    simulator_.set_word(address, static_cast<std::uint16_t>(value));
  } else {
    simulator_.set_bit(address, value != 0);
  }
}

void WideMachine::set(Device device, std::int16_t value) {
  if (is_port(device.kind)) {
    const auto port = ports_.find(device);
    if (port != ports_.end()) put(device, port->second, value);
    return;
  }
  const int index = find(device);
  if (index < 0) return;
  if (!is_word(device)) value = value != 0 ? 1 : 0;
  values_[index] = value;
  const auto latched = latched_.find(index);
  if (latched != latched_.end()) inputs_[latched->second] = value != 0 ? 1 : 0;
  put(device, image_.devices[index].address, value);
}

void WideMachine::apply(std::span<const StimulusEvent> events) {
  for (const StimulusEvent& event : events) set(event.device, event.value);
}

void WideMachine::run_scan() {
  for (const auto& [device, special] : driven_) {
    set(image_.devices[device].device, driven_value(*special, time_) ? 1 : 0);
  }
  for (const image::ImageTicks& each : image_.ticks) {
    simulator_.set_word(each.address,
                        static_cast<std::uint16_t>(ticks_since_last(each.base_us, time_)));
  }
  simulator_.run_scan(inputs_);
  ++time_.scan;
  writes_.clear();
  for (const image::WideWrite& write : wide_.writes) {
    std::int16_t value = 0;
    if (is_word(image_.devices[write.device].device)) {
      if (simulator_.kept(write.step, write.lane)) continue;
      value = static_cast<std::int16_t>(simulator_.computed_word(write.step, write.lane));
    } else {
      value = simulator_.computed_bit(write.step, write.lane) ? 1 : 0;
    }
    if (write.quiet && values_[write.device] == value) continue;
    values_[write.device] = value;
    writes_.push_back({write.device, value, write.step, write.lane});
  }
}

std::int16_t WideMachine::value(std::size_t device) const {
  const image::ImageDevice& named = image_.devices[device];
  if (is_word(named.device)) return static_cast<std::int16_t>(simulator_.word(named.address));
  return simulator_.bit(named.address) ? 1 : 0;
}

std::string WideMachine::describe(const WideWritten& write) const {
  wide::Step step;
  step.bits.resize(machine_.slots);
  step.words.resize(machine_.units);
  const bool word = is_word(image_.devices[write.device].device);
  const int slot = word ? 2 * write.lane : write.lane;
  wide::decode(wide_.code[write.step][slot], slot, machine_, step);
  return fmt::format("step {}, lane {}: {}", write.step, write.lane,
                     wide::disassemble(step, slot, machine_));
}

}  // namespace rung::tb
