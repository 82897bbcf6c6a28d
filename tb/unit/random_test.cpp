// SPDX-License-Identifier: Apache-2.0
// Random programs on few devices, so that every hazard comes up again and again, against the step
// model. RUNG_SEED=n runs one seed; RUNG_PROGRAMS=n says how many programs a processor gets.
#include <fmt/format.h>

#include <cstdlib>
#include <random>

#include "unit/bench.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

class Generator {
 public:
  Generator(const Target& target, std::uint32_t seed) : target_(target), random_(seed) {
    for (const isa::OpcodeInfo& info : isa::opcodes()) {
      if (target.mpu == isa::Mpu::Mpu1 ? info.on_mpu1 : info.on_slot)
        opcodes_.push_back(info.opcode);
    }
  }

  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  std::uint16_t word() {
    static constexpr std::uint16_t kCorners[] = {0, 1, 0xffff, 0x7fff, 0x8000, 2};
    return below(2) == 0 ? kCorners[below(6)] : static_cast<std::uint16_t>(below(0x10000));
  }
  // Few devices, at both ends of the memory.
  std::uint16_t device(int devices) {
    const int n = below(kDevices);
    return static_cast<std::uint16_t>(n < kDevices / 2 ? n : devices - 1 - n);
  }

  std::vector<Step> program(int steps) {
    std::vector<Step> program;
    std::vector<int> ready(static_cast<std::size_t>(isa::slots(target_.mpu)), 0);
    int clock = 0;
    for (int i = 0; i < steps; ++i) {
      Step step;
      int clocks = 1;
      for (int& slot_ready : ready) {
        isa::SlotInstruction instruction = this->instruction();
        // Only a result that is there may be collected, and no device may be written twice.
        while ((collects(instruction) && clock < slot_ready) || conflicts(instruction, step)) {
          instruction = this->instruction();
        }
        if (instruction.opcode == Opcode::Muls) slot_ready = clock + target_.config->mul_latency;
        if (instruction.opcode == Opcode::Divs) slot_ready = clock + target_.config->div_latency;
        clocks = std::max(clocks, target_.config->clocks(instruction.opcode));
        if (clocks > 1 &&
            (instruction.opcode == Opcode::Mul || instruction.opcode == Opcode::Div)) {
          slot_ready = 0;
        }
        step.push_back(instruction);
      }
      clock += clocks;
      program.push_back(step);
    }
    return program;
  }

 private:
  static constexpr int kDevices = 6;

  isa::SlotInstruction instruction() {
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
        if (info.gate == isa::Gate::Exc) out.always = below(2) == 0;
        if (target_.mpu == isa::Mpu::Mpu1) {
          out.a.n0 = false;
          break;
        }
        out.b = operand(bit_devices);
        out.c = operand(bit_devices);
        if (info.gate != isa::Gate::Exc) {
          out.row = static_cast<std::uint8_t>(below(isa::constant::lut_rows));
        }
        break;
      case isa::Format::Word:
        out.kind = static_cast<isa::WordKind>(below(3));
        out.rs = device(word_devices);
        out.rd = device(word_devices);
        out.source = out.kind == isa::WordKind::Devices ? device(word_devices) : word();
        out.always = below(3) != 0;
        break;
    }
    return out;
  }

  isa::BitOperand operand(int devices) { return {device(devices), below(4) == 0}; }

  static bool collects(const isa::SlotInstruction& instruction) {
    return instruction.opcode == Opcode::Mvl || instruction.opcode == Opcode::Mvh;
  }
  static bool conflicts(const isa::SlotInstruction& instruction, const Step& step) {
    for (const isa::SlotInstruction& other : step) {
      const auto format = isa::info(instruction.opcode).format;
      if (format != isa::info(other.opcode).format) continue;
      if (format == isa::Format::Bit && other.c.device == instruction.c.device) return true;
      if (format == isa::Format::Word && other.rd == instruction.rd) return true;
    }
    return false;
  }

  Target target_;
  std::mt19937 random_;
  std::vector<Opcode> opcodes_;
};

int from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoi(text);
}

class RandomPrograms : public testing::TestWithParam<Target> {};

TEST_P(RandomPrograms, EqualTheStepModel) {
  constexpr int kSteps = 200;
  constexpr int kScans = 2;
  const int seed_only = from_environment("RUNG_SEED", -1);
  const int programs = seed_only >= 0 ? 1 : from_environment("RUNG_PROGRAMS", 40);
  Bench bench(GetParam());
  for (int i = 0; i < programs; ++i) {
    const int seed = seed_only >= 0 ? seed_only : 1 + i;
    Generator generator(GetParam(), static_cast<std::uint32_t>(seed));
    for (int row = 0; row < isa::constant::lut_rows; ++row) {
      bench.set_lut(row, static_cast<std::uint8_t>(generator.below(256)));
    }
    for (int device = 0; device < bench.config().bit_devices; ++device) {
      bench.set_bit(device, generator.below(2) != 0);
    }
    for (int device = 0; device < bench.config().word_devices; ++device) {
      bench.set_word(device, generator.word());
    }
    const std::string replay = fmt::format(
        "seed {}; replay: RUNG_SEED={} unit_rtl --gtest_filter='*RandomPrograms*/mpu{}_{}'", seed,
        seed, static_cast<int>(bench.mpu()), bench.config().name);
    const std::vector<Step> program = generator.program(kSteps);
    ASSERT_TRUE(bench.scan(program)) << replay;
    for (int scan = 1; scan < kScans; ++scan) ASSERT_TRUE(bench.scan_again()) << replay;
    ASSERT_TRUE(bench.devices_equal()) << replay;
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, RandomPrograms, testing::ValuesIn(targets(kAllMpus)), target_name);

}  // namespace
}  // namespace rung::tb
