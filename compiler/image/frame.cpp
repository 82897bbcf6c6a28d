// SPDX-License-Identifier: Apache-2.0
#include "image/frame.hpp"

#include <algorithm>
#include <cassert>
#include <set>
#include <stdexcept>

#include "rungs/footprint.hpp"

namespace rung::image {

using isa::SlotInstruction;
using isa::WordKind;

namespace {

std::set<Device> all_devices(const Program& source, const core::Program& program) {
  std::set<Device> all;
  for (const Device device : visible_devices(source)) all.insert(device);
  for (const Device device : core::devices(program)) all.insert(device);
  return all;
}

}  // namespace

Addresses::Addresses(const Program& source, const core::Program& program, const isa::Config& config)
    : Addresses(all_devices(source, program), config) {}

Addresses::Addresses(const std::set<Device>& devices, const isa::Config& config) {
  // Hidden kinds stand last among the bits and among the words.
  for (const Device device : devices) {
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

Addresses::Addresses(const Addresses& common, std::map<Device, int> own)
    : common_(&common),
      devices_(std::move(own)),
      bits_(common.bits_),
      words_(common.words_),
      port_bits_(common.port_bits_),
      port_words_(common.port_words_) {}

std::uint16_t Addresses::of(Device device) const {
  const auto found = devices_.find(device);
  if (found != devices_.end()) return static_cast<std::uint16_t>(found->second);
  if (common_ != nullptr) return common_->of(device);
  throw std::logic_error("internal error in assembly: a device has no address");
}

std::uint8_t Rows::of(const mapping::MappedOp& op) {
  if (op.paper_row) {
    if (lut_.size() <= *op.paper_row) lut_.resize(*op.paper_row + 1, 0);
    lut_[*op.paper_row] = op.function;
    used_.insert(*op.paper_row);
    return *op.paper_row;
  }
  const auto found = std::find(lut_.begin(), lut_.end(), op.function);
  const auto index = static_cast<std::size_t>(found - lut_.begin());
  if (found == lut_.end()) lut_.push_back(op.function);
  used_.insert(static_cast<int>(index));
  return static_cast<std::uint8_t>(index & 0x7f);
}

void append(Image& image, const Routine& routine, int first_origin) {
  image.steps.insert(image.steps.end(), routine.steps.begin(), routine.steps.end());
  image.quiet.insert(image.quiet.end(), routine.quiet.begin(), routine.quiet.end());
  for (const auto& origins : routine.origins) {
    auto& step = image.origins.emplace_back(origins);
    for (int& origin : step) origin += origin < 0 ? 0 : first_origin;
  }
  image.statistics.lookups += routine.lookups;
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
  describe_source(source, image);
  image.statistics.bit_devices = addresses.bits() + addresses.port_bits();
  image.statistics.word_devices = addresses.words() + addresses.port_words();
  image.port_bits = addresses.port_bits();
  image.port_words = addresses.port_words();
  return image;
}

void describe_source(const Program& source, Image& image) {
  for (const Instruction& instruction : source.instructions) {
    image.source.push_back({instruction.position, instruction.text});
  }
  const ProgramCounts counts = count(source);
  image.statistics.rungs = counts.networks;
  image.statistics.instructions = counts.instructions;
  image.statistics.contacts = counts.contacts;
  image.statistics.runs = static_cast<int>(counts.run_lengths.size());
  if (source.ldmicro) set_peripherals(source, image);
}

Meaning meaning(const Program& source, const core::Program& program, std::map<Device, int> places) {
  Meaning out;
  out.program = program;
  out.places = std::move(places);
  for (const Network& network : source.networks) out.rungs.push_back(network.first);
  return out;
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
