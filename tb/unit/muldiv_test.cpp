// SPDX-License-Identifier: Apache-2.0
// The multiply-divide units: results are there after exactly the latency and stay, one unit a slot,
// no result of an operation that was not executed or divided by 0, and both slots waiting at once.
#include <fmt/format.h>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

constexpr int kS1 = 3;
constexpr int kS2 = 4;
constexpr int kLow = 5;
constexpr int kHigh = 6;
constexpr int kOne = 1;  // bit that is 1

class Units : public testing::TestWithParam<Target> {};
class LookUpUnits : public Units {};   // MULS, DIVS and their collectors
class TwoSlotUnits : public Units {};  // one unit beside the other

TEST_P(LookUpUnits, CollectAtTheLatencyAndLater) {
  Bench bench(GetParam());
  for (const Opcode start : {Opcode::Muls, Opcode::Divs}) {
    const int latency =
        start == Opcode::Muls ? bench.config().mul_latency : bench.config().div_latency;
    for (int slot = 0; slot < bench.slots(); ++slot) {
      for (const int wait : {latency, latency + 1, latency + 7}) {
        for (const std::uint16_t s1 : kCorners) {
          for (const std::uint16_t s2 : kCorners) {
            bench.set_word(kS1, s1);
            bench.set_word(kS2, s2);
            bench.set_word(kLow, 77);
            bench.set_word(kHigh, 88);
            std::vector<Step> program{bench.step(word(start, kS1, kS2, 0), slot)};
            for (int i = 1; i < wait; ++i) program.push_back(bench.step(nop()));
            // The high word first: either may come at the latency.
            program.push_back(bench.step(into(Opcode::Mvh, kHigh), slot));
            program.push_back(bench.step(into(Opcode::Mvl, kLow), slot));
            ASSERT_TRUE(bench.scan(program)) << wait;
            const auto a = static_cast<std::int16_t>(s1);
            const auto b = static_cast<std::int16_t>(s2);
            int low = 77;
            int high = 88;
            if (start == Opcode::Muls) {
              low = a * b;
              high = (a * b) >> 16;
            } else if (b != 0) {
              low = a / b;
              high = a % b;
            }
            ASSERT_EQ(bench.rtl().read_word(kLow), static_cast<std::uint16_t>(low))
                << a << " " << b;
            ASSERT_EQ(bench.rtl().read_word(kHigh), static_cast<std::uint16_t>(high))
                << a << " " << b;
          }
        }
      }
    }
  }
}

TEST_P(TwoSlotUnits, EachSlotHasItsOwn) {
  Bench bench(GetParam());
  bench.set_word(kS1, 1000);
  bench.set_word(kS2, 7);
  for (const bool swapped : {false, true}) {
    const auto both = [&](const isa::SlotInstruction& x, const isa::SlotInstruction& y) {
      return swapped ? Step{y, x} : Step{x, y};
    };
    std::vector<Step> program{
        both(word(Opcode::Muls, kS1, kS2, 0), word(Opcode::Divs, kS1, kS2, 0))};
    for (int i = 1; i < bench.config().div_latency; ++i) program.push_back(bench.step(nop()));
    program.push_back(both(into(Opcode::Mvl, 10), into(Opcode::Mvl, 11)));
    program.push_back(both(into(Opcode::Mvh, 12), into(Opcode::Mvh, 13)));
    ASSERT_TRUE(bench.scan(program));
    EXPECT_EQ(bench.rtl().read_word(10), 7000);
    EXPECT_EQ(bench.rtl().read_word(11), 142);
    EXPECT_EQ(bench.rtl().read_word(12), 0);
    EXPECT_EQ(bench.rtl().read_word(13), 6);
  }
}

// What stands beside a waiting instruction is done once, and a step with two takes the longer.
TEST_P(TwoSlotUnits, WaitingBesideOtherInstructions) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  bench.set_word(kS1, 0xfc18);  // -1000
  bench.set_word(kS2, 7);
  const isa::SlotInstruction waiting[] = {word(Opcode::Mul, kS1, kS2, 10),
                                          word(Opcode::Div, kS1, kS2, 10)};
  isa::SlotInstruction count = word(Opcode::Add, 20, 1, 20);
  count.kind = isa::WordKind::DeviceConstant;
  isa::SlotInstruction other_mul = word(Opcode::Mul, kS2, kS2, 11);
  isa::SlotInstruction other_div = word(Opcode::Div, kS1, kS1, 11);
  for (const isa::SlotInstruction& instruction : waiting) {
    for (const isa::SlotInstruction& beside :
         {nop(), count, contact(Opcode::Ld, kOne), coil(bench.mpu(), Opcode::Set, 40, true),
          move_constant(3, kS2), other_mul, other_div}) {
      for (int slot = 0; slot < 2; ++slot) {
        bench.set_word(20, 100);
        bench.set_word(kS2, 7);
        Step step = bench.step(instruction, slot);
        step[static_cast<std::size_t>(1 - slot)] = beside;
        Step after = bench.step(into(Opcode::Mvh, 12), slot);
        ASSERT_TRUE(bench.scan({step, after, step, step}));
        if (beside == count) {
          EXPECT_EQ(bench.rtl().read_word(20), 103);
        }
      }
    }
  }
  EXPECT_TRUE(bench.devices_equal());
}

TEST_P(Units, DivisionByZeroAndNotExecuted) {
  Bench bench(GetParam());
  const bool mpu1 = bench.mpu() == isa::Mpu::Mpu1;
  bench.set_bit(kOne, true);
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (const bool waiting : {true, false}) {
      if (mpu1 && !waiting) continue;
      for (const bool exc : {false, true}) {
        for (const bool always : {false, true}) {
          for (const std::uint16_t divisor : {0, 3}) {
            bench.set_word(kS1, 100);
            bench.set_word(kS2, divisor);
            bench.set_word(kLow, 77);
            bench.set_word(kHigh, 88);
            std::vector<Step> program{bench.step(contact(Opcode::Ld, exc ? kOne : 0), slot)};
            program.push_back(bench.step(
                word(waiting ? Opcode::Div : Opcode::Divs, kS1, kS2, waiting ? kLow : 0, always),
                slot));
            if (!waiting) {
              for (int i = 1; i < bench.config().div_latency; ++i) {
                program.push_back(bench.step(nop()));
              }
              program.push_back(bench.step(into(Opcode::Mvl, kLow), slot));
            }
            program.push_back(bench.step(into(Opcode::Mvh, kHigh), slot));
            ASSERT_TRUE(bench.scan(program));
            const bool run = exc || always;
            const bool valid = run && divisor != 0;
            EXPECT_EQ(bench.model().error, run && divisor == 0);
            EXPECT_EQ(bench.rtl().read_word(kLow), valid ? 33 : 77);
            EXPECT_EQ(bench.rtl().read_word(kHigh), valid ? 1 : 88);
          }
        }
      }
    }
  }
}

// The flag is up with done even if the very last step divides, and down in the next scan.
TEST_P(Units, ErrorFlagOfTheLastStep) {
  Bench bench(GetParam());
  const Opcode opcode = bench.mpu() == isa::Mpu::Mpu1 ? Opcode::Div : Opcode::Divs;
  bench.set_word(kS1, 1);
  for (int slot = 0; slot < bench.slots(); ++slot) {
    bench.set_word(kS2, 0);
    ASSERT_TRUE(bench.scan({bench.step(nop()), bench.step(word(opcode, kS1, kS2, 0), slot)}));
    EXPECT_TRUE(bench.rtl().run_scan({}).error);
    bench.set_word(kS2, 1);
    EXPECT_FALSE(bench.rtl().run_scan({}).error);
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, Units, testing::ValuesIn(targets(kAllMpus)), target_name);
INSTANTIATE_TEST_SUITE_P(Rtl, LookUpUnits, testing::ValuesIn(targets(kLookUpMpus)), target_name);
INSTANTIATE_TEST_SUITE_P(Rtl, TwoSlotUnits, testing::ValuesIn(targets({isa::Mpu::Mpu3})),
                         target_name);

}  // namespace
}  // namespace rung::tb
