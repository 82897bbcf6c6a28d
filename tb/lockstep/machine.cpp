// SPDX-License-Identifier: Apache-2.0
#include "lockstep/machine.hpp"

#include <fmt/format.h>

namespace rung::tb {

Machine::Machine(const image::Image& image, Processor& processor, std::int64_t tick_us)
    : AnyMachine(image, processor, tick_us), processor_(processor) {
  const isa::Config& config = processor.config();
  bit_devices_.assign(config.bit_devices, -1);
  word_devices_.assign(config.word_devices, -1);
  for (std::size_t i = 0; i < image.devices.size(); ++i) {
    const image::ImageDevice& named = image.devices[i];
    if (is_port(named.device.kind)) continue;
    (is_word(named.device) ? word_devices_ : bit_devices_)[named.address] = static_cast<int>(i);
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

void Machine::retire(const Retired& retired) {
  const bool quiet = image_.quiet[retired.step][retired.slot] != 0;
  if (retired.bit_we) {
    const auto value = static_cast<std::int16_t>(retired.bit_value ? 1 : 0);
    add({bit_devices_[retired.bit_address], value, retired.step, retired.slot}, quiet);
  }
  if (retired.word_we) {
    const auto value = static_cast<std::int16_t>(retired.word_value);
    add({word_devices_[retired.word_address], value, retired.step, retired.slot}, quiet);
  }
}

ScanResult Machine::execute() {
  return processor_.run_scan([this](const Retired& retired) {
    if (observer_) observer_(retired);
    retire(retired);
  });
}

std::string Machine::describe(const MachineWrite& write) const {
  return fmt::format("step {}, slot {}: {}", write.step, write.slot,
                     image::disassemble(image_.steps[write.step][write.slot], image_)) +
         source_of(image_.origins[write.step][write.slot]);
}

}  // namespace rung::tb
