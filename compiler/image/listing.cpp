// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <optional>

#include "image/image.hpp"
#include "image/wide_file.hpp"
#include "rungs/ports.hpp"

namespace rung::image {
namespace {

using isa::Opcode;
using isa::SlotInstruction;
using isa::WordKind;

// The device port at `address` of a memory of this size, if the program has it.
std::optional<std::string> port_name(int address, int size, int ports, DeviceKind kind) {
  if (address < size - ports) return std::nullopt;
  return port::name({kind, static_cast<std::uint32_t>(size - 1 - address)});
}

std::string bit_name(int address, const Image& image) {
  for (const ImageDevice& device : image.devices) {
    if (!is_word(device.device) && device.address == address) return device.name;
  }
  const int size = isa::find_config(image.config)->bit_devices;
  const auto port = port_name(address, size, image.port_bits, DeviceKind::PB);
  if (port) return *port;
  return fmt::format("t{}", address - image.first_hidden_bit);
}

std::string word_name(int address, const Image& image) {
  for (const ImageDevice& device : image.devices) {
    const bool named = is_word(device.device) && !is_port(device.device.kind);
    if (named && device.address == address) return device.name;
  }
  const int size = isa::find_config(image.config)->word_devices;
  const auto port = port_name(address, size, image.port_words, DeviceKind::PW);
  if (port) return *port;
  return fmt::format("w{}", address - image.first_hidden_word);
}

std::string operand(const isa::BitOperand& operand, const Image& image) {
  return operand.n0 ? std::string("N0") : bit_name(operand.device, image);
}

std::string paper_lookup(const SlotInstruction& instruction, const Image& image) {
  static constexpr std::string_view kLater[] = {"NOP", "AND", "ANI", "OR", "ORI"};
  const int row = instruction.row;
  return fmt::format("{} {} {} {} {} {}", (row >> 6 & 1) != 0 ? "LDI" : "LD", kLater[row >> 3 & 7],
                     kLater[row & 7], operand(instruction.a, image), operand(instruction.b, image),
                     operand(instruction.c, image));
}

std::string word_operands(const SlotInstruction& instruction, const Image& image) {
  const std::string constant = fmt::format("K{}", static_cast<std::int16_t>(instruction.source));
  const std::string rs = word_name(instruction.rs, image);
  std::string first;
  std::string second;
  switch (instruction.kind) {
    case WordKind::Devices:
      first = rs;
      second = word_name(instruction.source, image);
      break;
    case WordKind::DeviceConstant:
      first = rs;
      second = constant;
      break;
    case WordKind::ConstantDevice:
      first = constant;
      second = rs;
      break;
  }
  return instruction.opcode == Opcode::Mv || instruction.opcode == Opcode::Stx
             ? second
             : first + " " + second;
}

// MULS and their kin leave their result in the unit, CMP, LDH and IX something in the slot.
bool has_word_target(Opcode opcode) {
  switch (opcode) {
    case Opcode::Muls:
    case Opcode::Divs:
    case Opcode::Mulds:
    case Opcode::Divds:
    case Opcode::Cmp:
    case Opcode::Ldh:
    case Opcode::Ix:
    case Opcode::Stx:
      return false;
    default:
      return true;
  }
}

std::string word_instruction(const SlotInstruction& instruction, const Image& image) {
  const isa::OpcodeInfo& info = isa::info(instruction.opcode);
  std::string text(info.name);
  if (instruction.opcode == Opcode::Ix) {
    return text + fmt::format(" {} {}", word_name(instruction.rs, image), instruction.source);
  }
  const bool has_sources = info.gate != isa::Gate::Unit && instruction.opcode != Opcode::Mva &&
                           instruction.opcode != Opcode::Mvx;
  if (has_sources) text += " " + word_operands(instruction, image);
  if (info.format == isa::Format::Test) {
    const bool mpu1 = image.mpu == isa::Mpu::Mpu1;
    text += " " + bit_name(mpu1 ? instruction.a.device : instruction.c.device, image);
  } else if (has_word_target(instruction.opcode)) {
    text += " " + word_name(instruction.rd, image);
  }
  return instruction.always ? text + " always" : text;
}

std::string get(const SlotInstruction& instruction, const Image& image) {
  std::string text = instruction.always ? "GET clear" : "GET";
  if (image.mpu == isa::Mpu::Mpu1) return text + " " + bit_name(instruction.a.device, image);
  for (const isa::BitOperand& bit : {instruction.a, instruction.b, instruction.c}) {
    text += bit.n0 ? " 0" : " " + bit_name(bit.device, image);
  }
  return text;
}

std::string lookup(const SlotInstruction& instruction, const Image& image) {
  std::string text = fmt::format("{} {:08b} {} {} {}", isa::info(instruction.opcode).name,
                                 image.lut.at(instruction.row), operand(instruction.a, image),
                                 operand(instruction.b, image), operand(instruction.c, image));
  if (instruction.opcode != Opcode::Lut) text += " -> " + bit_name(instruction.c.device, image);
  return text;
}

// "D10 to D13 <- panel, 400 to 403"
std::string transfer(const Image& image, int number, const char* arrow) {
  const FlowTransfer& transfer = image.flow->transfer(number);
  const auto range = [&](const std::string& first, const std::string& last) {
    return transfer.count == 1 ? first : first + " to " + last;
  };
  const int last = transfer.count - 1;
  return fmt::format(
      "{} {} {}, {}",
      range(word_name(transfer.address, image), word_name(transfer.address + last, image)), arrow,
      image.flow->board_of(transfer).name,
      range(std::to_string(transfer.first), std::to_string(transfer.first + last)));
}

// What stands before the routines of a program with flow tasks, by their first instruction step.
std::multimap<std::size_t, std::string> routine_heads(const Image& image) {
  std::multimap<std::size_t, std::string> heads;
  if (!image.flow) return heads;
  const FlowImage& flow = *image.flow;
  heads.emplace(0, fmt::format("; ladder, {} clocks\n", image.clocks));
  int task = -1;
  for (std::size_t i = 0; i < flow.steps.size(); ++i) {
    const FlowStep& step = flow.steps[i];
    std::string text;
    if (step.task != task) {
      task = step.task;
      const FlowTask& its = flow.tasks.at(static_cast<std::size_t>(task));
      text += fmt::format("; task {}, {}{}\n", task, its.name,
                          its.starts ? ", starts with the program" : "");
    }
    text += fmt::format(";   step {}, {}{}, {} clocks; {}: {}\n", i, step.name,
                        step.added ? " (a wait)" : "", step.clocks, step.position.line, step.text);
    if (step.read != 0) text += ";     " + transfer(image, step.read, "<-") + "\n";
    if (step.write != 0) text += ";     " + transfer(image, step.write, "->") + "\n";
    heads.emplace(static_cast<std::size_t>(step.entry), std::move(text));
  }
  return heads;
}

}  // namespace

std::string disassemble(const SlotInstruction& instruction, const Image& image) {
  const isa::OpcodeInfo& info = isa::info(instruction.opcode);
  if (mapping::is_lookup(instruction.opcode)) {
    return image.paper ? paper_lookup(instruction, image) : lookup(instruction, image);
  }
  switch (info.format) {
    case isa::Format::None:
      return std::string(info.name);
    case isa::Format::Word:
    case isa::Format::Test:
      return word_instruction(instruction, image);
    case isa::Format::Bit:
      break;
  }
  switch (instruction.opcode) {
    case Opcode::Get:
      return get(instruction, image);
    case Opcode::Ldx:
    case Opcode::Setx:
    case Opcode::Rstx:
      return std::string(info.name);
    case Opcode::Mvbx:
      return fmt::format("{} {}", info.name, bit_name(instruction.c.device, image));
    default:
      break;
  }
  const bool writes = instruction.opcode == Opcode::Out || instruction.opcode == Opcode::Set ||
                      instruction.opcode == Opcode::Rst;
  const isa::BitOperand& device =
      writes && image.mpu != isa::Mpu::Mpu1 ? instruction.c : instruction.a;
  return fmt::format("{} {}", info.name, bit_name(device.device, image));
}

std::string listing(const Image& image) {
  if (image.wide) return wide_listing(image);
  const isa::Config& config = *isa::find_config(image.config);
  const int digits = (isa::slot_bits(image.mpu, config) + 3) / 4;
  std::string out =
      fmt::format("; {}: MPU{}, configuration {}, {} steps, {} clocks a scan\n", image.program,
                  static_cast<int>(image.mpu), image.config, image.steps.size(), image.clocks);
  const std::multimap<std::size_t, std::string> heads = routine_heads(image);
  for (const ImageDevice& device : image.devices) {
    if (!device.comment.empty()) out += fmt::format("; {}: {}\n", device.name, device.comment);
  }
  const auto add_heads = [&](std::size_t step) {
    const auto [first, last] = heads.equal_range(step);
    for (auto head = first; head != last; ++head) out += head->second;
  };
  for (std::size_t step = 0; step < image.steps.size(); ++step) {
    add_heads(step);
    for (std::size_t slot = 0; slot < image.steps[step].size(); ++slot) {
      const SlotInstruction& instruction = image.steps[step][slot];
      std::string line = slot == 0 ? fmt::format("{:5}", step) : std::string(5, ' ');
      line += fmt::format("  {:0{}x}  {:<36}", isa::encode(instruction, image.mpu, config), digits,
                          disassemble(instruction, image));
      const int origin = image.origins[step][slot];
      if (origin >= 0) {
        const SourceLine& source = image.source[origin];
        line += fmt::format("; {}: {}", source.position.line, source.text);
      }
      line.erase(line.find_last_not_of(' ') + 1);
      out += line + "\n";
    }
  }
  add_heads(image.steps.size());
  return out;
}

}  // namespace rung::image
