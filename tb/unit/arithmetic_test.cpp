// SPDX-License-Identifier: Apache-2.0
// The word side's tests, the carry from one instruction to the next, rotation and bits by all
// amounts.
#include <fmt/format.h>

#include <random>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

// Devices of these tests.
constexpr int kZeroWord = 2;
constexpr int kA = 3;  // three words each, the lowest first
constexpr int kB = 6;
constexpr int kSum = 9;
constexpr int kOne = 7;   // bit that is 1
constexpr int kZero = 8;  // bit that is 0
constexpr int kTarget = 9;

constexpr Opcode kTests[] = {Opcode::Eq, Opcode::Lt, Opcode::Ltu, Opcode::Ltc, Opcode::Tb};

class Arithmetic : public testing::TestWithParam<Target> {
 protected:
  // `own` in `slot`, `beside` in the other one where there are two.
  static Step beside(const Bench& bench, int slot, const isa::SlotInstruction& own,
                     const isa::SlotInstruction& beside) {
    Step step(static_cast<std::size_t>(bench.slots()), beside);
    step[static_cast<std::size_t>(slot)] = own;
    return step;
  }
  static const Retired& at(const Bench& bench, std::size_t step, int slot) {
    return bench
        .retired()[step * static_cast<std::size_t>(bench.slots()) + static_cast<std::size_t>(slot)];
  }
};

// No borrow comes in, so LTC is LT.
bool expected_test(Opcode opcode, std::uint16_t s1, std::uint16_t s2) {
  switch (opcode) {
    case Opcode::Eq:
      return s1 == s2;
    case Opcode::Ltu:
      return s1 < s2;
    case Opcode::Tb:
      return (s1 & 1 << s2 % 16) != 0;
    default:
      return static_cast<std::int16_t>(s1) < static_cast<std::int16_t>(s2);
  }
}

TEST_P(Arithmetic, TestsOnCornerOperands) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  for (const Opcode opcode : kTests) {
    for (int variant = 0; variant < 3 * 2 * 2 * bench.slots(); ++variant) {
      const auto kind = static_cast<isa::WordKind>(variant % 3);
      const bool exc = variant / 3 % 2 != 0;
      const bool always = variant / 6 % 2 != 0;
      const int slot = variant / 12;
      for (const std::uint16_t s1 : kCorners) {
        for (const std::uint16_t s2 : kCorners) {
          isa::SlotInstruction instruction = test(bench.mpu(), opcode, kA, kB, kTarget, always);
          instruction.kind = kind;
          if (kind == isa::WordKind::DeviceConstant) instruction.source = s2;
          if (kind == isa::WordKind::ConstantDevice) instruction.source = s1;
          const bool want = expected_test(opcode, s1, s2);
          bench.set_word(kA, kind == isa::WordKind::ConstantDevice ? s2 : s1);
          bench.set_word(kB, s2);
          bench.set_bit(kTarget, !want);
          ASSERT_TRUE(bench.scan({bench.step(contact(Opcode::Ld, exc ? kOne : kZero), slot),
                                  bench.step(instruction, slot),
                                  // exc is what it was
                                  bench.step(coil(bench.mpu(), Opcode::Out, kTarget + 1), slot)}));
          ASSERT_EQ(bench.rtl().read_bit(kTarget), exc || always ? want : !want)
              << fmt::format("{} {} {} kind {} exc {:d} u {:d} slot {}", isa::info(opcode).name, s1,
                             s2, static_cast<int>(kind), exc, always, slot);
          ASSERT_EQ(bench.rtl().read_bit(kTarget + 1), exc);
        }
      }
    }
  }
}

TEST_P(Arithmetic, RotationAndBitsByAllAmounts) {
  Bench bench(GetParam());
  for (const std::uint16_t value : {0x0001, 0x8000, 0xa53c, 0x7ffe}) {
    for (int by = 0; by < 32; ++by) {  // only four bits count
      bench.set_word(kA, value);
      bench.set_word(kB, static_cast<std::uint16_t>(by));
      ASSERT_TRUE(bench.scan({bench.step(word(Opcode::Rol, kA, kB, kSum)),
                              bench.step(test(bench.mpu(), Opcode::Tb, kA, kB, kTarget))}));
      std::uint16_t want = value;
      for (int i = 0; i < by; ++i) want = static_cast<std::uint16_t>(want << 1 | want >> 15);
      ASSERT_EQ(bench.rtl().read_word(kSum), want) << value << " by " << by;
      ASSERT_EQ(bench.rtl().read_bit(kTarget), (value >> by % 16 & 1) != 0) << value << " " << by;
    }
  }
}

// What each instruction does to the carry, executed or not: ADC of zeros shows it.
TEST_P(Arithmetic, WhichInstructionsSetTheCarry) {
  Bench bench(GetParam());
  const bool mpu1 = bench.mpu() == isa::Mpu::Mpu1;
  bench.set_word(kA, 0x8001);
  bench.set_word(kB, 0xffff);
  for (const isa::OpcodeInfo& info : isa::opcodes()) {
    if (!(mpu1 ? info.on_mpu1 : info.on_slot)) continue;
    for (const bool before : {false, true}) {
      for (const bool always : {false, true}) {
        for (int slot = 0; slot < bench.slots(); ++slot) {
          isa::SlotInstruction instruction = plain(info.opcode);
          if (info.format == isa::Format::Word) {
            instruction = word(info.opcode, kA, kB, kSum + 1, always);
          } else if (info.format == isa::Format::Test) {
            instruction = test(bench.mpu(), info.opcode, kA, kB, kTarget, always);
          }
          // exc is 0 all the time; 0 - 1 gives a borrow, 0 - 0 none
          ASSERT_TRUE(
              bench.scan({bench.step(with_constant(Opcode::Ix, kZeroWord, 20), slot),
                          bench.step(with_constant(Opcode::Cmp, kZeroWord, before ? 1 : 0), slot),
                          bench.step(word(Opcode::Ldh, kA, kB, 0), slot), bench.step(nop()),
                          bench.step(instruction, slot),
                          bench.step(word(Opcode::Adc, kZeroWord, kZeroWord, kSum), slot)}));
          bool want = before;
          switch (info.opcode) {  // of 0x8001 and 0xffff
            case Opcode::Add:
            case Opcode::Adc:
            case Opcode::Sub:
            case Opcode::Sbc:
            case Opcode::Cmp:
            case Opcode::Ltu:
              want = true;
              break;
            default:
              break;
          }
          ASSERT_EQ(bench.rtl().read_word(kSum), want ? 1 : 0)
              << fmt::format("{} u {:d} slot {}", info.name, always, slot);
        }
      }
    }
  }
}

// 48-bit sums and differences, with other instructions and the other slot's carry in between.
TEST_P(Arithmetic, CarryChains) {
  Bench bench(GetParam());
  std::mt19937 random(3);
  const auto limb = [&] {
    return random() % 2 == 0 ? kCorners[random() % 5] : static_cast<std::uint16_t>(random());
  };
  for (int trial = 0; trial < 200; ++trial) {
    const int slot = trial % bench.slots();
    const bool subtract = trial % 4 >= 2;
    const int gap = trial % 3;
    std::uint64_t a = 0;
    std::uint64_t b = 0;
    std::vector<Step> program;
    for (int i = 0; i < 3; ++i) {
      const std::uint16_t ai = limb();
      const std::uint16_t bi = limb();
      a |= std::uint64_t{ai} << 16 * i;
      b |= std::uint64_t{bi} << 16 * i;
      bench.set_word(kA + i, ai);
      bench.set_word(kB + i, bi);
      const Opcode first = subtract ? Opcode::Sub : Opcode::Add;
      const Opcode next = subtract ? Opcode::Sbc : Opcode::Adc;
      const isa::SlotInstruction noise = with_constant(Opcode::Cmp, kZeroWord, trial / 8 % 2);
      program.push_back(beside(bench, slot, word(i == 0 ? first : next, kA + i, kB + i, kSum + i),
                               bench.slots() == 2 ? noise : nop()));
      for (int k = 0; k < gap; ++k) {
        program.push_back(beside(bench, slot, move_constant(9, 20), nop()));
      }
    }
    ASSERT_TRUE(bench.scan(program)) << trial;
    const std::uint64_t want = subtract ? a - b : a + b;
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(bench.rtl().read_word(kSum + i), static_cast<std::uint16_t>(want >> 16 * i))
          << trial << " word " << i;
    }
  }
}

// The carry begins as 0, even if the scan before ended with one.
TEST_P(Arithmetic, CarryIsGoneInTheNextScan) {
  Bench bench(GetParam());
  for (int slot = 0; slot < bench.slots(); ++slot) {
    ASSERT_TRUE(bench.scan({bench.step(word(Opcode::Adc, kZeroWord, kZeroWord, kSum), slot),
                            bench.step(with_constant(Opcode::Cmp, kZeroWord, 1), slot)}));
    ASSERT_TRUE(bench.scan_again());
    EXPECT_EQ(bench.rtl().read_word(kSum), 0);
  }
}

// 32-bit compares: CMP of the low words, LTC of the high ones.
TEST_P(Arithmetic, CompareOf32Bits) {
  Bench bench(GetParam());
  const std::uint32_t values[] = {0,          1,          0xffff,     0x10000,    0x1ffff,
                                  0x7fffffff, 0x7fff0000, 0x80000000, 0x8000ffff, 0xffff0000,
                                  0xffffffff, 0xfffeffff, 0x00020001, 0x7ffeffff};
  for (int slot = 0; slot < bench.slots(); ++slot) {
    const std::vector<Step> program{
        bench.step(word(Opcode::Cmp, kA, kB, 0), slot),
        bench.step(test(bench.mpu(), Opcode::Ltc, kA + 1, kB + 1, kTarget), slot)};
    for (const std::uint32_t a : values) {
      for (const std::uint32_t b : values) {
        bench.set_word(kA, static_cast<std::uint16_t>(a));
        bench.set_word(kA + 1, static_cast<std::uint16_t>(a >> 16));
        bench.set_word(kB, static_cast<std::uint16_t>(b));
        bench.set_word(kB + 1, static_cast<std::uint16_t>(b >> 16));
        ASSERT_TRUE(bench.scan(program));
        ASSERT_EQ(at(bench, 1, slot).bit_value,
                  static_cast<std::int32_t>(a) < static_cast<std::int32_t>(b))
            << a << " " << b;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, Arithmetic, testing::ValuesIn(targets(kAllMpus)), target_name);

}  // namespace
}  // namespace rung::tb
