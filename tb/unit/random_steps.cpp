// SPDX-License-Identifier: Apache-2.0
#include "unit/random_steps.hpp"

#include <algorithm>

namespace rung::tb {

using isa::Opcode;

namespace {

// Whether both slots could write one device; where an indexed write goes is not known here.
bool conflicts(const isa::SlotInstruction& instruction, const Step& step) {
  const auto writes_bit = [](const isa::SlotInstruction& i) {
    return isa::info(i.opcode).format == isa::Format::Bit ||
           isa::info(i.opcode).format == isa::Format::Test;
  };
  const auto indexed = [](const isa::SlotInstruction& i) {
    return i.opcode == Opcode::Stx || i.opcode == Opcode::Setx || i.opcode == Opcode::Rstx;
  };
  if (instruction.opcode == Opcode::Nop) return false;
  for (const isa::SlotInstruction& other : step) {
    if (other.opcode == Opcode::Nop || writes_bit(instruction) != writes_bit(other)) continue;
    if (indexed(instruction) || indexed(other)) return true;
    if (writes_bit(other) ? other.c.device == instruction.c.device : other.rd == instruction.rd) {
      return true;
    }
  }
  return false;
}

}  // namespace

RandomSteps::RandomSteps(const Target& target, std::uint32_t seed)
    : target_(target), random_(seed) {
  for (const isa::OpcodeInfo& info : isa::opcodes()) {
    if (target.mpu == isa::Mpu::Mpu1 ? info.on_mpu1 : info.on_slot) opcodes_.push_back(info.opcode);
  }
}

std::uint16_t RandomSteps::word() {
  static constexpr std::uint16_t kCorners[] = {0, 1, 0xffff, 0x7fff, 0x8000, 2};
  return below(2) == 0 ? kCorners[below(6)] : static_cast<std::uint16_t>(below(0x10000));
}

std::uint16_t RandomSteps::device(int devices) {
  const int n = below(kDevices);
  return static_cast<std::uint16_t>(n < kDevices / 2 ? n : devices - 1 - n);
}

std::vector<Step> RandomSteps::program(int steps) {
  std::vector<Step> program;
  std::vector<Slot> slots(static_cast<std::size_t>(isa::slots(target_.mpu)));
  int clock = 0;
  for (int i = 0; i < steps; ++i) {
    Step step;
    int clocks = 1;
    for (Slot& slot : slots) {
      isa::SlotInstruction instruction = this->instruction();
      // Only a result or an index that is there may be used, and no device may be written twice.
      while (too_early(instruction, slot, clock) || conflicts(instruction, step)) {
        instruction = this->instruction();
      }
      track(instruction, clock, slot);
      clocks = std::max(clocks, target_.config->clocks(instruction.opcode));
      step.push_back(instruction);
    }
    clock += clocks;
    program.push_back(step);
  }
  return program;
}

void RandomSteps::fill(Bench& bench) {
  for (int row = 0; row < isa::constant::lut_rows; ++row) {
    bench.set_lut(row, static_cast<std::uint8_t>(below(256)));
  }
  for (int device = 0; device < bench.config().bit_devices; ++device) {
    bench.set_bit(device, below(2) != 0);
  }
  for (int device = 0; device < bench.config().word_devices; ++device) {
    bench.set_word(device, word());
  }
  bench.set_word(kZeroWord, 0);
}

isa::SlotInstruction RandomSteps::instruction() {
  isa::SlotInstruction out;
  out.opcode = opcodes_[static_cast<std::size_t>(below(static_cast<int>(opcodes_.size())))];
  const isa::OpcodeInfo& info = isa::info(out.opcode);
  // Waiting instructions take many clocks; the others are where hazards are.
  if (info.clocks != isa::Clocks::One && below(4) != 0) out.opcode = Opcode::Add;
  const int bit_devices = target_.config->bit_devices;
  const int word_devices = target_.config->word_devices;
  switch (isa::info(out.opcode).format) {
    case isa::Format::None:
      break;
    case isa::Format::Bit:
      out.a = operand(bit_devices);
      if (info.gate == isa::Gate::Exc || out.opcode == Opcode::Get) out.always = below(2) == 0;
      if (out.opcode == Opcode::Mvbx) out.a.n0 = false;
      if (target_.mpu == isa::Mpu::Mpu1) {
        out.a.n0 = false;
        break;
      }
      out.b = operand(bit_devices);
      out.c = operand(bit_devices);
      if (info.gate != isa::Gate::Exc && out.opcode != Opcode::Get) {
        out.row = static_cast<std::uint8_t>(below(isa::constant::lut_rows));
      }
      break;
    case isa::Format::Test:
      (target_.mpu == isa::Mpu::Mpu1 ? out.a : out.c).device = device(bit_devices);
      word_sources(out);
      break;
    case isa::Format::Word:
      out.rd = device(word_devices);
      word_sources(out);
      if (out.opcode == Opcode::Ix && below(8) != 0) {
        out.kind = below(2) == 0 ? isa::WordKind::DeviceConstant : isa::WordKind::ConstantDevice;
        out.rs = kZeroWord;
        out.source = device(below(2) == 0 ? bit_devices : word_devices);
      }
      break;
  }
  return out;
}

void RandomSteps::word_sources(isa::SlotInstruction& out) {
  const int word_devices = target_.config->word_devices;
  out.kind = static_cast<isa::WordKind>(below(3));
  out.rs = device(word_devices);
  out.source = out.kind == isa::WordKind::Devices ? device(word_devices) : word();
  out.always = below(3) != 0;
}

bool RandomSteps::too_early(const isa::SlotInstruction& instruction, const Slot& slot, int clock) {
  switch (instruction.opcode) {
    case Opcode::Mvl:
    case Opcode::Mvh:
      return clock < slot.unit;
    case Opcode::Mv2:
    case Opcode::Mv3:
      return clock < slot.unit || !slot.wide;
    case Opcode::Muld:
    case Opcode::Divd:
    case Opcode::Mulds:
    case Opcode::Divds:
      return !slot.high;
    case Opcode::Mvx:
    case Opcode::Stx:
    case Opcode::Mvbx:
    case Opcode::Ldx:
    case Opcode::Setx:
    case Opcode::Rstx:
      return clock < slot.index;
    default:
      return false;
  }
}

void RandomSteps::track(const isa::SlotInstruction& instruction, int clock, Slot& slot) const {
  const isa::Config& config = *target_.config;
  const auto start = [&](int latency, bool wide) {
    slot.unit = clock + latency;
    slot.wide = wide;
  };
  switch (instruction.opcode) {
    case Opcode::Mul:
    case Opcode::Div:
      return start(0, false);  // the processor waits
    case Opcode::Muld:
    case Opcode::Divd:
      return start(0, true);
    case Opcode::Muls:
      return start(config.mul_latency, false);
    case Opcode::Divs:
      return start(config.div_latency, false);
    case Opcode::Mulds:
      return start(config.mul32_latency, true);
    case Opcode::Divds:
      return start(config.div32_latency, true);
    case Opcode::Ldh:
      slot.high = true;
      return;
    case Opcode::Ix:
      slot.index = clock + isa::constant::index_latency;
      return;
    default:
      return;
  }
}

}  // namespace rung::tb
