// SPDX-License-Identifier: Apache-2.0
// GET and MVA: bits gathered into acc, in the order of their operands, and acc as a word.
#include <fmt/format.h>

#include <random>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

constexpr int kBits = 16;  // and the next bit devices
constexpr int kResult = 5;
constexpr int kOne = 7;  // bit that is 1

class Gather : public testing::TestWithParam<Target> {
 protected:
  // GETs of bits first, first - 1, ... first - count + 1; on a slot three go into one.
  static void get(const Bench& bench, std::vector<Step>& program, int slot, int first, int count,
                  bool clear = true) {
    const bool mpu1 = bench.mpu() == isa::Mpu::Mpu1;
    for (int i = 0; i < count; i += mpu1 ? 1 : 3) {
      isa::SlotInstruction instruction = contact(Opcode::Get, first - i);
      instruction.always = clear && i == 0;
      if (!mpu1) instruction.b = device(first - i - 1);
      if (!mpu1) instruction.c = device(first - i - 2);
      program.push_back(bench.step(instruction, slot));
    }
  }
};

TEST_P(Gather, BitsInOrderAndTheOldOnesMoveOut) {
  Bench bench(GetParam());
  std::mt19937 random(11);
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (const int count : {3, 6, 12, 15, 18}) {
      for (int trial = 0; trial < 8; ++trial) {
        const std::uint32_t pattern = random();
        for (int i = 0; i < 18; ++i) bench.set_bit(kBits + i, (pattern >> i & 1) != 0);
        std::vector<Step> program;
        get(bench, program, slot, kBits + 17, 15);  // what stood in acc before
        get(bench, program, slot, kBits + count - 1, count);
        program.push_back(bench.step(into(Opcode::Mva, kResult, true), slot));
        ASSERT_TRUE(bench.scan(program));
        ASSERT_EQ(bench.rtl().read_word(kResult),
                  static_cast<std::uint16_t>(pattern & ((1U << count) - 1)))
            << fmt::format("slot {} count {} pattern {:x}", slot, count, pattern);
      }
    }
  }
}

TEST_P(Gather, WithoutClearTheOldBitsMoveUp) {
  Bench bench(GetParam());
  for (int i = 0; i < 3; ++i) bench.set_bit(kBits + i, i != 1);
  for (int slot = 0; slot < bench.slots(); ++slot) {
    std::vector<Step> program;
    get(bench, program, slot, kBits + 2, 3);
    get(bench, program, slot, kBits + 2, 3, false);
    program.push_back(bench.step(into(Opcode::Mva, kResult, true), slot));
    ASSERT_TRUE(bench.scan(program));
    EXPECT_EQ(bench.rtl().read_word(kResult), 055);
    // A scan begins with acc 0.
    program.erase(program.begin(),
                  program.begin() + static_cast<std::ptrdiff_t>((program.size() - 1) / 2));
    ASSERT_TRUE(bench.scan(program));
    EXPECT_EQ(bench.rtl().read_word(kResult), 5);
  }
}

TEST_P(Gather, MoveIsGatedAndLeavesExc) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (const bool exc : {false, true}) {
      for (const bool always : {false, true}) {
        bench.set_word(kResult, 99);
        std::vector<Step> program{bench.step(contact(Opcode::Ld, exc ? kOne : kBits), slot)};
        get(bench, program, slot, kOne, 3);
        program.push_back(bench.step(into(Opcode::Mva, kResult, always), slot));
        program.push_back(bench.step(coil(bench.mpu(), Opcode::Out, kBits + 8), slot));
        ASSERT_TRUE(bench.scan(program));
        EXPECT_EQ(bench.rtl().read_word(kResult), exc || always ? 4 : 99);
        EXPECT_EQ(bench.rtl().read_bit(kBits + 8), exc);
      }
    }
  }
}

class SlotGather : public Gather {};  // operands with N0

TEST_P(SlotGather, N0CountsAsZero) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (int which = 0; which < 8; ++which) {
      isa::SlotInstruction instruction = contact(Opcode::Get, kOne);
      instruction.a.n0 = (which & 4) != 0;
      instruction.b = (which & 2) != 0 ? n0(kOne) : device(kOne);
      instruction.c = (which & 1) != 0 ? n0(kOne) : device(kOne);
      instruction.always = true;
      // exc is 1, and nobody sees it
      ASSERT_TRUE(
          bench.scan({bench.step(contact(Opcode::Ld, kOne), slot), bench.step(instruction, slot),
                      bench.step(into(Opcode::Mva, kResult), slot)}));
      EXPECT_EQ(bench.rtl().read_word(kResult), 7 - which) << "slot " << slot;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, Gather, testing::ValuesIn(targets(kAllMpus)), target_name);
INSTANTIATE_TEST_SUITE_P(Rtl, SlotGather, testing::ValuesIn(targets(kLookUpMpus)), target_name);

}  // namespace
}  // namespace rung::tb
