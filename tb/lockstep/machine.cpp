// SPDX-License-Identifier: Apache-2.0
#include "lockstep/machine.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace rung::tb {
namespace {

Dialect dialect_of(const image::Image& image) {
  const auto dialect = find_dialect(image.dialect);
  if (!dialect) throw std::invalid_argument("the image has no known dialect");
  return *dialect;
}

}  // namespace

Machine::Machine(const image::Image& image, Processor& processor, std::int64_t tick_us)
    : image_(image),
      processor_(processor),
      peripherals_(image, processor),
      values_(image.devices.size(), 0),
      ticks_(image.ticks.size(), 0),
      time_{0, image.cycle_us > 0 ? image.cycle_us : tick_us} {
  const isa::Config& config = processor.config();
  bit_devices_.assign(config.bit_devices, -1);
  word_devices_.assign(config.word_devices, -1);
  for (std::size_t i = 0; i < image.devices.size(); ++i) {
    const image::ImageDevice& named = image.devices[i];
    // No write of a port is a write of the trace.
    if (is_port(named.device.kind)) continue;
    const int index = static_cast<int>(i);
    (is_word(named.device) ? word_devices_ : bit_devices_)[named.address] = index;
    by_device_[named.device] = index;
    const SpecialRange* special = find_special(named.device, dialect_of(image));
    if (special != nullptr && is_driven(special->role)) driven_.push_back({index, special});
  }
  std::vector<std::vector<std::uint64_t>> steps;
  steps.reserve(image.steps.size());
  for (const auto& step : image.steps) {
    auto& words = steps.emplace_back();
    for (const auto& slot : step) words.push_back(isa::encode(slot, image.mpu, config));
  }
  processor.load_program(steps);
  for (const image::ImageConstant& each : image.constants) {
    processor.write_word(each.address, static_cast<std::uint16_t>(each.value));
  }
  for (std::size_t row = 0; row < image.lut.size(); ++row) {
    processor.load_lut(static_cast<int>(row), image.lut[row]);
  }
}

Machine::~Machine() {
  const image::Statistics& used = image_.statistics;
  for (int address = 0; address < used.bit_devices - image_.port_bits; ++address) {
    processor_.write_bit(address, false);
  }
  for (int address = 0; address < used.word_devices - image_.port_words; ++address) {
    processor_.write_word(address, 0);
  }
  peripherals_.clear();
}

void Machine::set(int device, std::int16_t value) {
  const image::ImageDevice& named = image_.devices[device];
  if (is_word(named.device)) {
    processor_.write_word(named.address, static_cast<std::uint16_t>(value));
  } else {
    value = value != 0 ? 1 : 0;
    processor_.write_bit(named.address, value != 0);
  }
  values_[device] = value;
}

void Machine::apply(std::span<const StimulusEvent> events) {
  for (const StimulusEvent& event : events) {
    if (is_port(event.device.kind)) {
      peripherals_.set(event.device, event.value);
      continue;
    }
    const int device = find(event.device);
    if (device >= 0) set(device, event.value);
  }
}

void Machine::drive() {
  for (const Driven& driven : driven_) {
    const std::int16_t value = driven_value(*driven.special, time_) ? 1 : 0;
    if (values_[driven.device] != value) set(driven.device, value);
  }
  for (std::size_t i = 0; i < image_.ticks.size(); ++i) {
    const std::int16_t ticks = ticks_since_last(image_.ticks[i].base_us, time_);
    if (ticks == ticks_[i]) continue;
    processor_.write_word(image_.ticks[i].address, static_cast<std::uint16_t>(ticks));
    ticks_[i] = ticks;
  }
}

void Machine::retire(const Retired& retired) {
  const bool quiet = image_.quiet[retired.step][retired.slot] != 0;
  const auto add = [&](int device, std::int16_t value) {
    if (device < 0 || (quiet && values_[device] == value)) return;
    values_[device] = value;
    writes_.push_back({device, value, retired.step, retired.slot});
  };
  if (retired.bit_we) {
    add(bit_devices_[retired.bit_address], static_cast<std::int16_t>(retired.bit_value ? 1 : 0));
  }
  if (retired.word_we) {
    add(word_devices_[retired.word_address], static_cast<std::int16_t>(retired.word_value));
  }
}

ScanResult Machine::run_scan() {
  writes_.clear();
  drive();
  peripherals_.begin_scan();
  const ScanResult result = processor_.run_scan([this](const Retired& retired) {
    if (observer_) observer_(retired);
    retire(retired);
  });
  peripherals_.end_scan();
  ++time_.scan;
  return result;
}

std::int16_t Machine::value(std::size_t device) {
  const image::ImageDevice& named = image_.devices[device];
  if (is_word(named.device)) {
    return static_cast<std::int16_t>(processor_.read_word(named.address));
  }
  return processor_.read_bit(named.address) ? 1 : 0;
}

int Machine::find(Device device) const {
  const auto found = by_device_.find(device);
  return found == by_device_.end() ? -1 : found->second;
}

std::string Machine::describe(std::uint32_t step, std::uint8_t slot) const {
  std::string text = fmt::format("step {}, slot {}: {}", step, slot,
                                 image::disassemble(image_.steps[step][slot], image_));
  const int origin = image_.origins[step][slot];
  if (origin >= 0) {
    const image::SourceLine& line = image_.source[origin];
    text += fmt::format(" ({}:{}:{}: {})", image_.program, line.position.line, line.position.column,
                        line.text);
  }
  return text;
}

DeviceNames names_of(const image::Image& image) {
  std::map<Device, std::string> names;
  for (const image::ImageDevice& device : image.devices) names[device.device] = device.name;
  return DeviceNames(dialect_of(image), std::move(names));
}

MachineRun::MachineRun(Machine& machine, bool with_state)
    : machine_(machine),
      names_(names_of(machine.image())),
      with_state_(with_state),
      recorder_(with_state) {}

TraceHeader MachineRun::header() const {
  const image::Image& image = machine_.image();
  TraceHeader header{image.program, image.dialect, machine_.tick_us(), static_cast<int>(image.mpu)};
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

}  // namespace rung::tb
