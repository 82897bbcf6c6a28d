// SPDX-License-Identifier: Apache-2.0
#include "lockstep/wide_machine.hpp"

#include <fmt/format.h>

namespace rung::tb {

WideMachine::WideMachine(const image::Image& image, WideProcessor& processor, std::int64_t tick_us)
    : AnyMachine(image, processor, tick_us),
      wide_(image.wide.value()),
      processor_(processor),
      inputs_(wide_.latched.size(), 0) {
  for (std::size_t i = 0; i < wide_.latched.size(); ++i) {
    latched_[wide_.latched[i]] = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < image.devices.size(); ++i) {
    const bool word = is_word(image.devices[i].device);
    (word ? words_ : bits_).push_back(static_cast<int>(i));
    (word ? word_places_ : bit_places_).push_back(image.devices[i].address);
  }
  processor.load(image);
}

// What is latched gets into its place by the scan itself.
void WideMachine::put(int device, std::int16_t value) {
  read_.clear();
  const auto latched = latched_.find(device);
  if (latched == latched_.end()) return AnyMachine::put(device, value);
  inputs_[latched->second] = value != 0 ? 1 : 0;
}

ScanResult WideMachine::execute() {
  read_.clear();
  const ScanResult result = processor_.run_scan(inputs_);
  const rung::wide::Simulator& last = processor_.last();
  for (const image::WideWrite& write : wide_.writes) {
    std::int16_t value = 0;
    if (is_word(image_.devices[write.device].device)) {
      if (last.kept(write.step, write.lane)) continue;
      value = static_cast<std::int16_t>(last.computed_word(write.step, write.lane));
    } else {
      value = last.computed_bit(write.step, write.lane) ? 1 : 0;
    }
    add({write.device, value, static_cast<std::uint32_t>(write.step),
         static_cast<std::uint8_t>(write.lane)},
        write.quiet);
  }
  return result;
}

void WideMachine::read_back() {
  read_.assign(image_.devices.size(), 0);
  const auto keep = [&](const std::vector<int>& devices, const std::vector<std::uint16_t>& values) {
    for (std::size_t i = 0; i < devices.size(); ++i) {
      read_[devices[i]] = static_cast<std::int16_t>(values[i]);
    }
  };
  keep(bits_, processor_.read_bits(bit_places_));
  keep(words_, processor_.read_words(word_places_));
}

std::int16_t WideMachine::value(std::size_t device) {
  if (read_.empty()) read_back();
  return read_[device];
}

std::string WideMachine::describe(const MachineWrite& write) const {
  const rung::wide::Machine& machine = processor_.machine();
  rung::wide::Step step;
  step.bits.resize(machine.slots);
  step.words.resize(machine.units);
  const bool word = is_word(image_.devices[write.device].device);
  const int slot = word ? 2 * write.slot : write.slot;
  rung::wide::decode(wide_.code[write.step][slot], slot, machine, step);
  return fmt::format("step {}, slot {}: {}", write.step, slot,
                     rung::wide::disassemble(step, slot, machine)) +
         source_of(wide_.origins[write.step][slot]);
}

}  // namespace rung::tb
