// SPDX-License-Identifier: Apache-2.0
#include "lockstep/any_machine.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "lockstep/machine.hpp"
#include "lockstep/wide_machine.hpp"

namespace rung::tb {
namespace {

Dialect dialect_of(const image::Image& image) {
  const auto dialect = find_dialect(image.dialect);
  if (!dialect) throw std::invalid_argument("the image has no known dialect");
  return *dialect;
}

}  // namespace

AnyMachine::AnyMachine(const image::Image& image, DeviceMemory& memory, std::int64_t tick_us)
    : image_(image),
      memory_(memory),
      peripherals_(port_places(image), memory),
      values_(image.devices.size(), 0),
      ticks_(image.ticks.size(), 0),
      time_{0, image.cycle_us > 0 ? image.cycle_us : tick_us} {
  for (std::size_t i = 0; i < image.devices.size(); ++i) {
    const Device device = image.devices[i].device;
    // No write of a port is a write of the trace.
    if (is_port(device.kind)) continue;
    const int index = static_cast<int>(i);
    by_device_[device] = index;
    const SpecialRange* special = find_special(device, dialect_of(image));
    if (special != nullptr && is_driven(special->role)) driven_.push_back({index, special});
  }
}

void AnyMachine::put(int device, std::int16_t value) {
  const image::ImageDevice& named = image_.devices[device];
  if (is_word(named.device)) {
    memory_.write_word(named.address, static_cast<std::uint16_t>(value));
  } else {
    memory_.write_bit(named.address, value != 0);
  }
}

void AnyMachine::set(int device, std::int16_t value) {
  if (!is_word(image_.devices[device].device)) value = value != 0 ? 1 : 0;
  put(device, value);
  values_[device] = value;
}

void AnyMachine::apply(std::span<const StimulusEvent> events) {
  for (const StimulusEvent& event : events) {
    if (is_port(event.device.kind)) {
      peripherals_.set(event.device, event.value);
      continue;
    }
    const int device = find(event.device);
    if (device >= 0) set(device, event.value);
  }
}

void AnyMachine::drive() {
  for (const Driven& driven : driven_) {
    const std::int16_t value = driven_value(*driven.special, time_) ? 1 : 0;
    if (values_[driven.device] != value) set(driven.device, value);
  }
  for (std::size_t i = 0; i < image_.ticks.size(); ++i) {
    const std::int16_t ticks = ticks_since_last(image_.ticks[i].base_us, time_);
    if (ticks == ticks_[i]) continue;
    memory_.write_word(image_.ticks[i].address, static_cast<std::uint16_t>(ticks));
    ticks_[i] = ticks;
  }
}

void AnyMachine::add(const MachineWrite& write, bool quiet) {
  if (write.device < 0 || (quiet && values_[write.device] == write.value)) return;
  values_[write.device] = write.value;
  writes_.push_back(write);
}

ScanResult AnyMachine::run_scan() {
  writes_.clear();
  drive();
  peripherals_.begin_scan();
  const ScanResult result = execute();
  peripherals_.end_scan();
  ++time_.scan;
  return result;
}

std::int16_t AnyMachine::value(std::size_t device) {
  const image::ImageDevice& named = image_.devices[device];
  if (is_word(named.device)) return static_cast<std::int16_t>(memory_.read_word(named.address));
  return memory_.read_bit(named.address) ? 1 : 0;
}

int AnyMachine::find(Device device) const {
  const auto found = by_device_.find(device);
  return found == by_device_.end() ? -1 : found->second;
}

std::string AnyMachine::source_of(int origin) const {
  if (origin < 0) return {};
  const image::SourceLine& line = image_.source[origin];
  return fmt::format(" ({}:{}:{}: {})", image_.program, line.position.line, line.position.column,
                     line.text);
}

DeviceNames names_of(const image::Image& image) {
  std::map<Device, std::string> names;
  for (const image::ImageDevice& device : image.devices) names[device.device] = device.name;
  return DeviceNames(dialect_of(image), std::move(names));
}

MachineRun::MachineRun(AnyMachine& machine, bool with_state)
    : machine_(machine),
      names_(names_of(machine.image())),
      with_state_(with_state),
      recorder_(with_state) {}

TraceHeader MachineRun::header() const {
  const image::Image& image = machine_.image();
  TraceHeader header{image.program, image.dialect, machine_.tick_us(), static_cast<int>(image.mpu)};
  if (image.wide) {
    header.slots = image.wide->slots;
    header.merged = image.wide->merged;
  }
  for (const image::ImageDevice& device : image.devices) {
    if (!device.comment.empty()) header.comments[device.name] = device.comment;
  }
  return header;
}

TraceScan MachineRun::scan(std::span<const StimulusEvent> events) {
  machine_.apply(events);
  const ScanResult result = machine_.run_scan();
  return record(events, result);
}

TraceScan MachineRun::record(std::span<const StimulusEvent> events, const ScanResult& result) {
  const image::Image& image = machine_.image();
  for (const StimulusEvent& event : events) recorder_.event(event, names_);
  for (const MachineWrite& write : machine_.writes()) {
    recorder_.write(image.devices[write.device].name, write.value);
  }
  for (std::size_t i = 0; i < image.devices.size(); ++i) {
    const image::ImageDevice& device = image.devices[i];
    if (is_port(device.device.kind)) continue;
    const bool output = device.device.kind == DeviceKind::Y;
    if (!output && !with_state_) continue;
    const std::int16_t value = machine_.value(i);
    if (output) recorder_.output(device.name, value);
    recorder_.state(device.name, value);
  }
  for (const int byte : machine_.sent()) recorder_.sent(byte);
  return recorder_.finish(result.clocks);
}

LoadedMachine load_machine(const image::Image& image, std::int64_t tick_us) {
  LoadedMachine loaded;
  if (image.wide) {
    auto processor = make_wide_processor(image.wide->slots);
    loaded.machine = std::make_unique<WideMachine>(image, *processor, tick_us);
    loaded.processor = std::move(processor);
  } else {
    auto processor = make_processor(image.mpu, *isa::find_config(image.config));
    loaded.machine = std::make_unique<Machine>(image, *processor, tick_us);
    loaded.processor = std::move(processor);
  }
  return loaded;
}

}  // namespace rung::tb
