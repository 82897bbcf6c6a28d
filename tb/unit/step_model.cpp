// SPDX-License-Identifier: Apache-2.0
#include "unit/step_model.hpp"

#include <algorithm>
#include <bit>
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
  const isa::Format format = isa::info(instruction.opcode).format;
  if (format == isa::Format::Word || format == isa::Format::Test) {
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
  const bool indexed_source =
      instruction.opcode == Opcode::Mvbx || instruction.opcode == Opcode::Ldx;
  const bool indexed_target =
      instruction.opcode == Opcode::Setx || instruction.opcode == Opcode::Rstx;
  const bool a = indexed_source ? bits[indexed_bit(slot)] : value(instruction.a);
  const auto write = [&](bool bit) {
    out.bit_we = true;
    out.bit_address = mpu1 ? instruction.a.device : instruction.c.device;
    if (indexed_target) out.bit_address = static_cast<std::uint16_t>(indexed_bit(slot));
    out.bit_value = bit;
  };
  const auto gather = [&](const isa::BitOperand& operand) {
    slot.acc =
        static_cast<std::uint16_t>(slot.acc << 1 | (!operand.n0 && bits[operand.device] ? 1 : 0));
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
    case Opcode::Ldx:
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
    case Opcode::Pop:
      slot.exc = pop(slot.block);
      break;
    case Opcode::Inv:
      slot.exc = !exc;
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
    case Opcode::Setx:
      if (exc || instruction.always) write(true);
      break;
    case Opcode::Rst:
    case Opcode::Rstx:
      if (exc || instruction.always) write(false);
      break;
    case Opcode::Mvbx:
      write(a);
      break;
    case Opcode::Get:
      if (instruction.always) slot.acc = 0;
      gather(instruction.a);
      if (!mpu1) gather(instruction.b);
      if (!mpu1) gather(instruction.c);
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
  // A sum's or a difference's carry or borrow is kept, executed or not.
  const auto sum = [&](int addend, int carry) {
    slot.carry = s1 + addend + carry > 0xffff;
    write(run, s1 + addend + carry);
  };
  const auto difference = [&](int borrow) {
    const int subtrahend = s2 + borrow;
    slot.carry = s1 < subtrahend;
    return s1 - subtrahend;
  };
  switch (instruction.opcode) {
    case Opcode::Mv:
      write(run, s2);
      break;
    case Opcode::Add:
      sum(s2, 0);
      break;
    case Opcode::Adc:
      sum(s2, slot.carry ? 1 : 0);
      break;
    case Opcode::Sub:
      write(run, difference(0));
      break;
    case Opcode::Sbc:
      write(run, difference(slot.carry ? 1 : 0));
      break;
    case Opcode::Cmp:
      difference(0);
      break;
    case Opcode::Wand:
      write(run, s1 & s2);
      break;
    case Opcode::Wor:
      write(run, s1 | s2);
      break;
    case Opcode::Wxor:
      write(run, s1 ^ s2);
      break;
    case Opcode::Rol:
      write(run, std::rotl(s1, s2 & 15));
      break;
    case Opcode::Minu:
      write(run, std::min(s1, s2));
      break;
    case Opcode::Eq:
    case Opcode::Lt:
    case Opcode::Ltu:
    case Opcode::Ltc:
    case Opcode::Tb:
      out.bit_value = test(instruction.opcode, s1, s2, slot);
      out.bit_we = run;
      out.bit_address = mpu_ == isa::Mpu::Mpu1 ? instruction.a.device : instruction.c.device;
      break;
    case Opcode::Mva:
      write(run, slot.acc);
      break;
    case Opcode::Ix:
      slot.ix = static_cast<std::uint16_t>(s1 + s2);
      break;
    case Opcode::Mvx:
      write(run, words[indexed_word(slot)]);
      break;
    case Opcode::Stx:
      write(run, s2);
      out.word_address = static_cast<std::uint16_t>(indexed_word(slot));
      break;
    case Opcode::Ldh:
      slot.high1 = s1;
      slot.high2 = s2;
      break;
    case Opcode::Mul:
    case Opcode::Div:
    case Opcode::Muld:
    case Opcode::Divd:
      start_unit(instruction.opcode, s1, s2, run, slot);
      write(slot.unit_valid, slot.unit[0]);
      break;
    case Opcode::Muls:
    case Opcode::Divs:
    case Opcode::Mulds:
    case Opcode::Divds:
      start_unit(instruction.opcode, s1, s2, run, slot);
      break;
    case Opcode::Mvl:
      write(slot.unit_valid, slot.unit[0]);
      break;
    case Opcode::Mvh:
      write(slot.unit_valid, slot.unit[1]);
      break;
    case Opcode::Mv2:
      write(slot.unit_valid, slot.unit[2]);
      break;
    case Opcode::Mv3:
      write(slot.unit_valid, slot.unit[3]);
      break;
    default:
      break;
  }
}

bool StepModel::test(Opcode opcode, std::uint16_t s1, std::uint16_t s2, Slot& slot) {
  const auto signed1 = static_cast<std::int16_t>(s1);
  const auto signed2 = static_cast<std::int16_t>(s2);
  switch (opcode) {
    case Opcode::Eq:
      return s1 == s2;
    case Opcode::Lt:
      return signed1 < signed2;
    case Opcode::Ltc:
      return signed1 - (slot.carry ? 1 : 0) < signed2;
    case Opcode::Ltu:
      slot.carry = s1 < s2;
      return slot.carry;
    default:  // TB
      return (s1 >> (s2 & 15) & 1) != 0;
  }
}

void StepModel::start_unit(Opcode opcode, std::uint16_t s1, std::uint16_t s2, bool run,
                           Slot& slot) {
  const bool wide = opcode == Opcode::Muld || opcode == Opcode::Divd || opcode == Opcode::Mulds ||
                    opcode == Opcode::Divds;
  const bool divide = opcode == Opcode::Div || opcode == Opcode::Divs || opcode == Opcode::Divd ||
                      opcode == Opcode::Divds;
  const auto join = [](std::uint16_t high, std::uint16_t low) {
    return std::int64_t{static_cast<std::int32_t>(static_cast<std::uint32_t>(high) << 16 | low)};
  };
  const std::int64_t a = wide ? join(slot.high1, s1) : std::int64_t{static_cast<std::int16_t>(s1)};
  const std::int64_t b = wide ? join(slot.high2, s2) : std::int64_t{static_cast<std::int16_t>(s2)};
  slot.unit_valid = run && !(divide && b == 0);
  if (run && divide && b == 0) error = true;
  if (!slot.unit_valid) return;
  // The result's words from the lowest; a quotient and a remainder stand side by side.
  const int width = wide ? 32 : 16;
  const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
  const std::uint64_t result = divide ? (static_cast<std::uint64_t>(a / b) & mask) |
                                            static_cast<std::uint64_t>(a % b) << width
                                      : static_cast<std::uint64_t>(a * b);
  for (std::size_t i = 0; i < (wide ? 4U : 2U); ++i) {
    slot.unit[i] = static_cast<std::uint16_t>(result >> 16 * i);
  }
}

std::size_t StepModel::indexed_bit(const Slot& slot) const { return slot.ix % bits.size(); }
std::size_t StepModel::indexed_word(const Slot& slot) const { return slot.ix % words.size(); }

}  // namespace rung::tb
