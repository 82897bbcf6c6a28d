// SPDX-License-Identifier: Apache-2.0
// 32-bit products and divisions: corner values with each other and with random ones, results after
// exactly the latency, in any order and as long as nothing new starts; beside 16-bit operations.
#include <fmt/format.h>

#include <array>
#include <random>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

constexpr int kA = 3;  // two words each, the lower first
constexpr int kB = 5;
constexpr int kResult = 10;  // four words
constexpr int kOne = 1;      // bit that is 1
constexpr Opcode kWords[] = {Opcode::Mvl, Opcode::Mvh, Opcode::Mv2, Opcode::Mv3};
constexpr std::uint16_t kOld = 0x7777;

constexpr std::uint32_t kWide[] = {0,          1,          2,          7,          0x7fff,
                                   0x8000,     0xffff,     0x10000,    0x10001,    0x7fff0000,
                                   0x7fffffff, 0x80000000, 0x80000001, 0x8000ffff, 0xffff0000,
                                   0xffff8000, 0xfffffff9, 0xfffffffe, 0xffffffff};

class Units32 : public testing::TestWithParam<Target> {
 protected:
  static bool mpu1(const Bench& bench) { return bench.mpu() == isa::Mpu::Mpu1; }
  static Opcode opcode(const Bench& bench, bool divide) {
    if (mpu1(bench)) return divide ? Opcode::Divd : Opcode::Muld;
    return divide ? Opcode::Divds : Opcode::Mulds;
  }
  static int latency(const Bench& bench, bool divide) {
    return divide ? bench.config().div32_latency : bench.config().mul32_latency;
  }
  static void set_wide(Bench& bench, int address, std::uint32_t value) {
    bench.set_word(address, static_cast<std::uint16_t>(value));
    bench.set_word(address + 1, static_cast<std::uint16_t>(value >> 16));
  }
  // The operation on kA and kB, and its words into kResult, beginning with word `first` at the
  // earliest clock.
  static std::vector<Step> program(const Bench& bench, bool divide, int slot, int first,
                                   bool always = true) {
    std::vector<Step> program{
        bench.step(word(Opcode::Ldh, kA + 1, kB + 1, 0, false), slot),
        bench.step(word(opcode(bench, divide), kA, kB, kResult + 4, always), slot)};
    if (!mpu1(bench)) {
      for (int i = 1; i < latency(bench, divide); ++i) program.push_back(bench.step(nop()));
    }
    for (int i = 0; i < 4; ++i) {
      const int which = (first + i) % 4;
      program.push_back(bench.step(into(kWords[which], kResult + which), slot));
    }
    return program;
  }
  static std::array<std::uint16_t, 4> expected(bool divide, std::uint32_t a, std::uint32_t b) {
    const auto x = std::int64_t{static_cast<std::int32_t>(a)};
    const auto y = std::int64_t{static_cast<std::int32_t>(b)};
    if (divide && y == 0) return {kOld, kOld, kOld, kOld};
    const std::int64_t low = divide ? x / y : x * y;
    const std::int64_t high = divide ? x % y : low >> 32;
    return {static_cast<std::uint16_t>(low), static_cast<std::uint16_t>(low >> 16),
            static_cast<std::uint16_t>(high), static_cast<std::uint16_t>(high >> 16)};
  }
  // One scan of `program` for these operands, and what it left in kResult.
  static testing::AssertionResult scan(Bench& bench, bool loaded, const std::vector<Step>& program,
                                       bool divide, std::uint32_t a, std::uint32_t b) {
    set_wide(bench, kA, a);
    set_wide(bench, kB, b);
    for (int i = 0; i < 4; ++i) bench.set_word(kResult + i, kOld);
    const testing::AssertionResult result = loaded ? bench.scan_again() : bench.scan(program);
    if (!result) return result;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint16_t got = bench.rtl().read_word(kResult + static_cast<int>(i));
      const std::uint16_t want = expected(divide, a, b)[i];
      if (got == want) continue;
      return testing::AssertionFailure()
             << fmt::format("{:x}, {:x}: word {} is {:x}, expected {:x}", a, b, i, got, want);
    }
    return testing::AssertionSuccess();
  }
};

TEST_P(Units32, CornersWithCornersAndRandomValues) {
  Bench bench(GetParam());
  std::mt19937 random(5);
  for (const bool divide : {false, true}) {
    for (int slot = 0; slot < bench.slots(); ++slot) {
      const std::vector<Step> steps = program(bench, divide, slot, 0);
      bool loaded = false;
      for (const std::uint32_t corner : kWide) {
        for (const std::uint32_t other : kWide) {
          ASSERT_TRUE(scan(bench, loaded, steps, divide, corner, other)) << "slot " << slot;
          loaded = true;
        }
        for (int i = 0; i < 20; ++i) {
          const auto any = static_cast<std::uint32_t>(random()) >> (i % 4 == 0 ? random() % 32 : 0);
          ASSERT_TRUE(scan(bench, loaded, steps, divide, corner, any)) << "slot " << slot;
          ASSERT_TRUE(scan(bench, loaded, steps, divide, any, corner)) << "slot " << slot;
        }
      }
    }
  }
}

TEST_P(Units32, EachWordMayComeFirst) {
  Bench bench(GetParam());
  for (const bool divide : {false, true}) {
    for (int slot = 0; slot < bench.slots(); ++slot) {
      for (int first = 0; first < 4; ++first) {
        const std::vector<Step> steps = program(bench, divide, slot, first);
        bool loaded = false;
        // Quotients and remainders whose lower words are 0 need a carry in their upper ones.
        const std::pair<std::uint32_t, std::uint32_t> operands[] = {
            {0xfffe0000, 2},          {0xfff00000, 0x30000}, {0x12345678, 0xffffff87},
            {0x80000000, 0xffff0000}, {0xedcba988, 0x4321},  {0x80000000, 1}};
        for (const auto& [a, b] : operands) {
          ASSERT_TRUE(scan(bench, loaded, steps, divide, a, b)) << first;
          loaded = true;
        }
      }
    }
  }
}

TEST_P(Units32, DivisionByZeroAndNotExecuted) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  for (const bool divide : {false, true}) {
    for (int slot = 0; slot < bench.slots(); ++slot) {
      for (const bool exc : {false, true}) {
        for (const bool always : {false, true}) {
          // only low, only high, no bits of the divisor
          for (const std::uint32_t divisor : {0x00000001U, 0x00010000U, 0x00000000U}) {
            std::vector<Step> steps = program(bench, divide, slot, 0, always);
            steps.insert(steps.begin(), bench.step(contact(Opcode::Ld, exc ? kOne : 0), slot));
            set_wide(bench, kA, 0x10000);
            set_wide(bench, kB, divisor);
            bench.set_word(kResult, kOld);
            ASSERT_TRUE(bench.scan(steps));
            const bool run = exc || always;
            EXPECT_EQ(bench.model().error, run && divide && divisor == 0);
            const std::uint16_t low = expected(divide, 0x10000, divisor)[0];
            EXPECT_EQ(bench.rtl().read_word(kResult), run ? low : kOld);
          }
        }
      }
    }
  }
}

// LDH does not disturb an operation that runs or a result that waits, and 16-bit operations leave
// its words alone.
TEST_P(Units32, HighWordsStayBesideOtherOperations) {
  Bench bench(GetParam());
  set_wide(bench, kA, 0xfedcba98);
  set_wide(bench, kB, 0x00034567);
  for (const bool divide : {false, true}) {
    for (const bool small_divides : {false, true}) {
      for (int slot = 0; slot < bench.slots(); ++slot) {
        const isa::SlotInstruction high = word(Opcode::Ldh, kA + 1, kB + 1, 0, false);
        const isa::SlotInstruction start = word(opcode(bench, divide), kA, kB, kResult + 4);
        Opcode small = small_divides ? Opcode::Divs : Opcode::Muls;
        if (mpu1(bench)) small = small_divides ? Opcode::Div : Opcode::Mul;
        const isa::SlotInstruction small_start = word(small, kA, kB, kResult + 5);
        const int small_latency =
            small_divides ? bench.config().div_latency : bench.config().mul_latency;
        for (int at = 0; at < 4; ++at) {  // LDH before, into and behind the 16-bit operation
          std::vector<Step> steps;
          if (at == 0) steps.push_back(bench.step(high, slot));
          steps.push_back(bench.step(small_start, slot));
          if (at == 1) steps.push_back(bench.step(high, slot));
          for (int i = 1; i < small_latency; ++i) {
            steps.push_back(bench.step(at == 2 && i == 2 ? high : nop(), slot));
          }
          if (at == 3) steps.push_back(bench.step(high, slot));
          steps.push_back(bench.step(into(Opcode::Mvh, kResult + 6), slot));
          if (at == 2 && small_latency <= 2) steps.push_back(bench.step(high, slot));
          steps.push_back(bench.step(start, slot));
          for (int i = 1; !mpu1(bench) && i < latency(bench, divide); ++i) {
            steps.push_back(bench.step(nop()));
          }
          for (int i = 0; i < 4; ++i) {
            steps.push_back(bench.step(into(kWords[i], kResult + i), slot));
          }
          ASSERT_TRUE(bench.scan(steps)) << at;
          for (std::size_t i = 0; i < 4; ++i) {
            ASSERT_EQ(bench.rtl().read_word(kResult + static_cast<int>(i)),
                      expected(divide, 0xfedcba98, 0x00034567)[i])
                << fmt::format("word {} LDH at {} slot {}", i, at, slot);
          }
        }
      }
    }
  }
}

class LookUpUnits32 : public Units32 {};  // MPU1 waits for every result

// A 32-bit operation that a 16-bit one replaces, at every clock of its way.
TEST_P(LookUpUnits32, ANewStartReplacesTheOldOperation) {
  Bench bench(GetParam());
  set_wide(bench, kA, 0x9abcdef1);
  set_wide(bench, kB, 0x00000305);
  for (const bool divide : {false, true}) {
    for (const bool small_divides : {false, true}) {
      for (int gap = 0; gap < latency(bench, divide) + 2; ++gap) {
        const int slot = gap % bench.slots();
        std::vector<Step> steps{bench.step(word(Opcode::Ldh, kA + 1, kB + 1, 0, false), slot),
                                bench.step(word(opcode(bench, divide), kA, kB, 0), slot)};
        for (int i = 0; i < gap; ++i) steps.push_back(bench.step(nop()));
        steps.push_back(
            bench.step(word(small_divides ? Opcode::Divs : Opcode::Muls, kA, kB, 0), slot));
        const int wait = small_divides ? bench.config().div_latency : bench.config().mul_latency;
        for (int i = 1; i < wait; ++i) steps.push_back(bench.step(nop()));
        steps.push_back(bench.step(into(Opcode::Mvl, kResult), slot));
        steps.push_back(bench.step(into(Opcode::Mvh, kResult + 1), slot));
        ASSERT_TRUE(bench.scan(steps)) << gap;
      }
    }
  }
}

class TwoUnits32 : public Units32 {};

TEST_P(TwoUnits32, EachSlotHasItsOwn) {
  Bench bench(GetParam());
  set_wide(bench, kA, 0x89abcdef);
  set_wide(bench, kB, 0x0000a987);
  for (const bool swapped : {false, true}) {
    const auto both = [&](const isa::SlotInstruction& x, const isa::SlotInstruction& y) {
      return swapped ? Step{y, x} : Step{x, y};
    };
    std::vector<Step> steps{
        both(word(Opcode::Ldh, kA + 1, kB + 1, 0), word(Opcode::Ldh, kB + 1, kA + 1, 0)),
        both(word(Opcode::Mulds, kA, kB, 0), word(Opcode::Divds, kB, kA, 0))};
    for (int i = 1; i < latency(bench, true); ++i) steps.push_back(bench.step(nop()));
    for (int i = 0; i < 4; ++i) {
      steps.push_back(both(into(kWords[i], kResult + i), into(kWords[i], kResult + 4 + i)));
    }
    ASSERT_TRUE(bench.scan(steps));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(bench.rtl().read_word(kResult + static_cast<int>(i)),
                expected(false, 0x89abcdef, 0x0000a987)[i]);
      EXPECT_EQ(bench.rtl().read_word(kResult + 4 + static_cast<int>(i)),
                expected(true, 0x0000a987, 0x89abcdef)[i]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, Units32, testing::ValuesIn(targets(kAllMpus)), target_name);
INSTANTIATE_TEST_SUITE_P(Rtl, LookUpUnits32, testing::ValuesIn(targets(kLookUpMpus)), target_name);
INSTANTIATE_TEST_SUITE_P(Rtl, TwoUnits32, testing::ValuesIn(targets({isa::Mpu::Mpu3})),
                         target_name);

}  // namespace
}  // namespace rung::tb
