// SPDX-License-Identifier: Apache-2.0
#include "lockstep/machine.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "rungs/devices.hpp"

namespace rung::tb {
namespace {

Dialect dialect_of(const image::Image& image) {
  for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q}) {
    if (dialect_name(dialect) == image.dialect) return dialect;
  }
  throw std::invalid_argument("the image has no known dialect");
}

}  // namespace

Machine::Machine(const image::Image& image, Processor& processor)
    : image_(image), processor_(processor) {
  const isa::Config& config = processor.config();
  bit_devices_.assign(config.bit_devices, -1);
  word_devices_.assign(config.word_devices, -1);
  for (std::size_t i = 0; i < image.devices.size(); ++i) {
    const image::ImageDevice& device = image.devices[i];
    auto& table = device.kind == DeviceKind::D ? word_devices_ : bit_devices_;
    table[device.address] = static_cast<int>(i);
    const auto parsed = parse_device_name(device.name, dialect_of(image));
    if (!parsed) throw std::invalid_argument("the image names a device that does not exist");
    by_device_[*parsed] = static_cast<int>(i);
  }
  std::vector<std::vector<std::uint64_t>> steps;
  steps.reserve(image.steps.size());
  for (const auto& step : image.steps) {
    auto& words = steps.emplace_back();
    for (const auto& slot : step) words.push_back(isa::encode(slot, image.mpu, config));
  }
  processor.load_program(steps);
  for (std::size_t row = 0; row < image.lut.size(); ++row) {
    processor.load_lut(static_cast<int>(row), image.lut[row]);
  }
}

Machine::~Machine() {
  for (const image::ImageDevice& device : image_.devices) set(device, 0);
  for (int address = image_.first_temporary; address < image_.statistics.bit_devices; ++address) {
    processor_.write_bit(address, false);
  }
}

void Machine::set(const image::ImageDevice& device, std::int16_t value) {
  if (device.kind == DeviceKind::D) {
    processor_.write_word(device.address, static_cast<std::uint16_t>(value));
  } else {
    processor_.write_bit(device.address, value != 0);
  }
}

void Machine::apply(std::span<const StimulusEvent> events) {
  for (const StimulusEvent& event : events) {
    const int device = find(event.device);
    if (device >= 0) set(image_.devices[device], event.value);
  }
}

ScanResult Machine::run_scan() {
  writes_.clear();
  return processor_.run_scan([this](const Retired& retired) {
    if (observer_) observer_(retired);
    if (retired.bit_we && bit_devices_[retired.bit_address] >= 0) {
      writes_.push_back({bit_devices_[retired.bit_address],
                         static_cast<std::int16_t>(retired.bit_value ? 1 : 0), retired.step,
                         retired.slot});
    }
    if (retired.word_we && word_devices_[retired.word_address] >= 0) {
      writes_.push_back({word_devices_[retired.word_address],
                         static_cast<std::int16_t>(retired.word_value), retired.step,
                         retired.slot});
    }
  });
}

std::int16_t Machine::value(std::size_t device) {
  const image::ImageDevice& named = image_.devices[device];
  if (named.kind == DeviceKind::D) {
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

MachineRun::MachineRun(Machine& machine, bool with_state)
    : machine_(machine), with_state_(with_state), recorder_(with_state) {}

TraceHeader MachineRun::header(std::int64_t tick_us) const {
  const image::Image& image = machine_.image();
  return {image.program, image.dialect, tick_us, static_cast<int>(image.mpu)};
}

TraceScan MachineRun::scan(std::span<const StimulusEvent> events) {
  machine_.apply(events);
  const ScanResult result = machine_.run_scan();
  return record(events, result);
}

TraceScan MachineRun::record(std::span<const StimulusEvent> events, const ScanResult& result) {
  const image::Image& image = machine_.image();
  for (const StimulusEvent& event : events) {
    const std::string name = device_name(event.device, dialect_of(image));
    if (is_input(event.device)) {
      recorder_.input(name, event.value);
    } else {
      recorder_.preset(name, event.value);
    }
  }
  for (const MachineWrite& write : machine_.writes()) {
    recorder_.write(image.devices[write.device].name, write.value);
  }
  for (std::size_t i = 0; i < image.devices.size(); ++i) {
    const image::ImageDevice& device = image.devices[i];
    const bool output = device.kind == DeviceKind::Y;
    if (!output && !with_state_) continue;
    const std::int16_t value = machine_.value(i);
    if (output) recorder_.output(device.name, value);
    recorder_.state(device.name, value);
  }
  return recorder_.finish(result.clocks);
}

}  // namespace rung::tb
