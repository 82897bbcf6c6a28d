// SPDX-License-Identifier: Apache-2.0
#include "image/frame.hpp"

#include <algorithm>
#include <cassert>
#include <set>

#include "rungs/footprint.hpp"

namespace rung::image {

using isa::SlotInstruction;
using isa::WordKind;

Addresses::Addresses(const Program& source, const core::Program& program,
                     const isa::Config& config) {
  std::set<Device> all;
  for (const Device device : visible_devices(source)) all.insert(device);
  for (const Device device : core::devices(program)) all.insert(device);
  // Hidden kinds stand last among the bits and among the words.
  for (const Device device : all) {
    const bool word = is_word(device);
    if (is_port(device.kind)) {
      const int number = static_cast<int>(device.number);
      int& ports = word ? port_words_ : port_bits_;
      ports = std::max(ports, number + 1);
      devices_[device] = (word ? config.word_devices : config.bit_devices) - 1 - number;
    } else {
      devices_[device] = word ? words_++ : bits_++;
    }
  }
}

namespace {

// What an LDmicro program asks of the controller around it.
void set_peripherals(const Program& source, Image& image) {
  const LdmicroSettings& settings = *source.ldmicro;
  image.cycle_us = settings.cycle_us;
  image.baud = settings.baud;
  image.own_pins = std::any_of(settings.pins.begin(), settings.pins.end(),
                               [](const LdmicroSettings::Pin& pin) { return pin.pin != 0; });
  for (const Instruction& instruction : source.instructions) {
    if (instruction.op == Op::UartSend || instruction.op == Op::UartRecv ||
        instruction.op == Op::FormattedString) {
      image.uart = true;
    } else if (instruction.op == Op::SetPwm) {
      image.pwm = true;
    } else if (instruction.op == Op::Persist) {
      const auto index = static_cast<std::size_t>(instruction.operand(1).value);
      if (image.persist.size() <= index) image.persist.resize(index + 1);
      image.persist[index] = device_name(instruction.operand(0).device, source);
    }
  }
}

}  // namespace

Image start_image(const Program& source, const core::Program& program, const Addresses& addresses,
                  const isa::Config& config, isa::Mpu mpu) {
  Image image;
  image.program = source.file;
  image.dialect = dialect_name(source.dialect);
  image.mpu = mpu;
  image.config = config.name;
  for (const auto& [device, address] : addresses.devices()) {
    // Of the ports only analogue channels have names.
    const bool channel = is_port(device.kind) && source.names.contains(device);
    if (is_hidden(device.kind) && !channel) continue;
    const auto comment = source.comments.find(device);
    image.devices.push_back({device_name(device, source), device, address,
                             comment == source.comments.end() ? std::string() : comment->second});
    if (channel) continue;
    int& hidden = is_word(device) ? image.first_hidden_word : image.first_hidden_bit;
    hidden = address + 1;
  }
  for (const core::TickWord& word : program.ticks) {
    image.ticks.push_back({addresses.of(word.device), word.base_us});
  }
  for (const core::ConstantWord& word : program.constants) {
    image.constants.push_back({addresses.of(word.device), word.value});
  }
  for (const Instruction& instruction : source.instructions) {
    image.source.push_back({instruction.position, instruction.text});
  }
  const ProgramCounts counts = count(source);
  image.statistics.rungs = counts.networks;
  image.statistics.instructions = counts.instructions;
  image.statistics.contacts = counts.contacts;
  image.statistics.runs = static_cast<int>(counts.run_lengths.size());
  image.statistics.bit_devices = addresses.bits() + addresses.port_bits();
  image.statistics.word_devices = addresses.words() + addresses.port_words();
  image.port_bits = addresses.port_bits();
  image.port_words = addresses.port_words();
  if (source.ldmicro) set_peripherals(source, image);
  return image;
}

void set_sources(SlotInstruction& out, const core::WordSource& first,
                 const core::WordSource& second, const Addresses& addresses) {
  const bool one_operand = out.opcode == isa::Opcode::Mv || out.opcode == isa::Opcode::Stx;
  assert(!first.constant || !second.constant || one_operand);
  const auto value = [](const core::WordSource& source) {
    return static_cast<std::uint16_t>(source.value);
  };
  if (second.constant) {
    out.kind = WordKind::DeviceConstant;
    out.rs = first.constant ? std::uint16_t{0} : addresses.of(first.device);
    out.source = value(second);
  } else if (first.constant && !one_operand) {
    out.kind = WordKind::ConstantDevice;
    out.rs = addresses.of(second.device);
    out.source = value(first);
  } else {
    out.kind = WordKind::Devices;
    out.rs = first.constant ? std::uint16_t{0} : addresses.of(first.device);
    out.source = addresses.of(second.device);
  }
}

}  // namespace rung::image
