// SPDX-License-Identifier: Apache-2.0
#include "unit/step_model.hpp"

#include <algorithm>
#include <cstddef>

namespace rung::tb {

using isa::Opcode;

StepModel::StepModel(isa::Mpu mpu, const isa::Config& config)
    : bits(static_cast<std::size_t>(config.bit_devices)),
      words(static_cast<std::size_t>(config.word_devices)),
      mpu_(mpu),
      config_(config) {}

std::vector<Retired> StepModel::scan(const std::vector<Step>& program, std::uint32_t& clocks) {
  std::vector<Slot> slots(static_cast<std::size_t>(isa::slots(mpu_)));
  std::vector<Retired> retired;
  clocks = isa::constant::fill_clocks;
  error = false;
  for (std::size_t number = 0; number < program.size(); ++number) {
    const std::size_t first = retired.size();
    int step_clocks = 1;
    for (std::size_t s = 0; s < slots.size(); ++s) {
      const isa::SlotInstruction& instruction = program[number][s];
      retired.push_back(execute(instruction, slots[s]));
      retired.back().step = static_cast<std::uint32_t>(number);
      retired.back().slot = static_cast<std::uint8_t>(s);
      step_clocks = std::max(step_clocks, config_.clocks(instruction.opcode));
    }
    // All slots have read before any of them writes.
    for (std::size_t i = first; i < retired.size(); ++i) {
      if (retired[i].bit_we) bits[retired[i].bit_address] = retired[i].bit_value;
      if (retired[i].word_we) words[retired[i].word_address] = retired[i].word_value;
    }
    clocks += static_cast<std::uint32_t>(step_clocks);
  }
  return retired;
}

Retired StepModel::execute(const isa::SlotInstruction& instruction, Slot& slot) {
  Retired out;
  if (isa::info(instruction.opcode).format == isa::Format::Word) {
    execute_word(instruction, slot, out);
  } else {
    execute_bit(instruction, slot, out);
  }
  out.exc = slot.exc;
  return out;
}

void StepModel::execute_bit(const isa::SlotInstruction& instruction, Slot& slot,
                            Retired& out) const {
  const auto value = [&](const isa::BitOperand& operand) {
    return operand.n0 ? slot.exc : bits[operand.device];
  };
  const auto pop = [](std::uint16_t& stack) {
    const bool top = (stack & 1) != 0;
    stack = static_cast<std::uint16_t>(stack >> 1);
    return top;
  };
  const auto push = [](std::uint16_t& stack, bool bit) {
    stack = static_cast<std::uint16_t>(stack << 1 | (bit ? 1 : 0));
  };
  const bool mpu1 = mpu_ == isa::Mpu::Mpu1;
  const bool exc = slot.exc;
  const bool a = value(instruction.a);
  const auto write = [&](bool bit) {
    out.bit_we = true;
    out.bit_address = mpu1 ? instruction.a.device : instruction.c.device;
    out.bit_value = bit;
  };
  switch (instruction.opcode) {
    case Opcode::Lut:
    case Opcode::Luto:
    case Opcode::Luts:
    case Opcode::Lutr: {
      const int address =
          (a ? 4 : 0) + (value(instruction.b) ? 2 : 0) + (value(instruction.c) ? 1 : 0);
      slot.exc = (lut[instruction.row] >> address & 1) != 0;
      if (instruction.opcode == Opcode::Luto) write(slot.exc);
      if (instruction.opcode == Opcode::Luts && slot.exc) write(true);
      if (instruction.opcode == Opcode::Lutr && slot.exc) write(false);
      break;
    }
    case Opcode::Ld:
    case Opcode::Ldi:
      if (mpu1) push(slot.block, exc);
      slot.exc = a != (instruction.opcode == Opcode::Ldi);
      break;
    case Opcode::And:
      slot.exc = exc && a;
      break;
    case Opcode::Ani:
      slot.exc = exc && !a;
      break;
    case Opcode::Or:
      slot.exc = exc || a;
      break;
    case Opcode::Ori:
      slot.exc = exc || !a;
      break;
    case Opcode::Anb:
      slot.exc = pop(slot.block) && exc;
      break;
    case Opcode::Orb:
      slot.exc = pop(slot.block) || exc;
      break;
    case Opcode::Mps:
      push(slot.branch, exc);
      break;
    case Opcode::Mrd:
      slot.exc = (slot.branch & 1) != 0;
      break;
    case Opcode::Mpp:
      slot.exc = pop(slot.branch);
      break;
    case Opcode::Out:
      write(exc);
      break;
    case Opcode::Set:
    case Opcode::Rst:
      if (exc || instruction.always) write(instruction.opcode == Opcode::Set);
      break;
    default:
      break;
  }
}

void StepModel::execute_word(const isa::SlotInstruction& instruction, Slot& slot, Retired& out) {
  const std::uint16_t rs = words[instruction.rs];
  const std::uint16_t constant = instruction.source;
  const auto device = static_cast<std::size_t>(constant % config_.word_devices);
  std::uint16_t s1 = rs;
  std::uint16_t s2 = constant;
  if (instruction.kind == isa::WordKind::Devices) s2 = words[device];
  if (instruction.kind == isa::WordKind::ConstantDevice) {
    s1 = constant;
    s2 = rs;
  }
  const bool run = slot.exc || instruction.always;
  const auto write = [&](bool enable, int value) {
    out.word_we = enable;
    out.word_address = instruction.rd;
    out.word_value = static_cast<std::uint16_t>(value);
  };
  const bool divide = instruction.opcode == Opcode::Div || instruction.opcode == Opcode::Divs;
  switch (instruction.opcode) {
    case Opcode::Mv:
      write(run, s2);
      break;
    case Opcode::Add:
      write(run, s1 + s2);
      break;
    case Opcode::Sub:
      write(run, s1 - s2);
      break;
    case Opcode::Mul:
    case Opcode::Div:
    case Opcode::Muls:
    case Opcode::Divs:
      start_unit(divide, static_cast<std::int16_t>(s1), static_cast<std::int16_t>(s2), run, slot);
      if (instruction.opcode == Opcode::Mul || instruction.opcode == Opcode::Div) {
        write(slot.unit_valid, slot.unit_low);
      }
      break;
    case Opcode::Mvl:
      write(slot.unit_valid, slot.unit_low);
      break;
    case Opcode::Mvh:
      write(slot.unit_valid, slot.unit_high);
      break;
    default:
      break;
  }
}

void StepModel::start_unit(bool divide, std::int16_t s1, std::int16_t s2, bool run, Slot& slot) {
  slot.unit_valid = run && !(divide && s2 == 0);
  if (run && divide && s2 == 0) error = true;
  if (!slot.unit_valid) return;
  if (divide) {
    slot.unit_low = static_cast<std::uint16_t>(s1 / s2);
    slot.unit_high = static_cast<std::uint16_t>(s1 % s2);
  } else {
    const std::int32_t product = s1 * s2;
    slot.unit_low = static_cast<std::uint16_t>(product);
    slot.unit_high = static_cast<std::uint16_t>(product >> 16);
  }
}

}  // namespace rung::tb
