// SPDX-License-Identifier: Apache-2.0
// The index: what IX makes of its operands, at exactly the latency, for every user of it; one a
// slot; held while the processor waits.
#include <fmt/format.h>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

constexpr int kLatency = isa::constant::index_latency;
constexpr int kZero = 2;    // word that is 0
constexpr int kBase = 3;    // word with a device number
constexpr int kTable = 50;  // some devices, in all of which are different values
constexpr int kSize = 8;
constexpr int kResult = 20;
constexpr int kOne = 1;  // bit that is 1

class Index : public testing::TestWithParam<Target> {
 protected:
  static void pad(const Bench& bench, std::vector<Step>& program, int distance) {
    for (int i = 1; i < distance; ++i) program.push_back(bench.step(nop()));
  }
  static void fill(Bench& bench) {
    bench.set_bit(kOne, true);
    for (int i = 0; i < kSize; ++i) {
      bench.set_word(kTable + i, static_cast<std::uint16_t>(0x100 * i + 7));
      bench.set_bit(kTable + i, i % 3 == 1);
    }
  }
  static isa::SlotInstruction read_bit(const Bench& bench) {
    isa::SlotInstruction out;
    out.opcode = bench.mpu() == isa::Mpu::Mpu1 ? Opcode::Ldx : Opcode::Mvbx;
    if (out.opcode == Opcode::Mvbx) out.c = device(kResult);
    return out;
  }
  // Every user of ix, and a value that it writes.
  static std::vector<isa::SlotInstruction> users(const Bench& bench) {
    return {into(Opcode::Mvx, kResult, true), with_constant(Opcode::Stx, kZero, 0xabcd),
            indexed_coil(Opcode::Setx), indexed_coil(Opcode::Rstx), read_bit(bench)};
  }
};

// The index just before is another one, so that one too early or too late shows.
TEST_P(Index, AtTheLatencyAndLater) {
  Bench bench(GetParam());
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (const int distance : {kLatency, kLatency + 1, kLatency + 6}) {
      for (const isa::SlotInstruction& user : users(bench)) {
        fill(bench);
        std::vector<Step> program{bench.step(with_constant(Opcode::Ix, kZero, kTable + 1), slot)};
        pad(bench, program, kLatency);
        program.push_back(bench.step(with_constant(Opcode::Ix, kZero, kTable + 5), slot));
        pad(bench, program, distance);
        program.push_back(bench.step(user, slot));
        program.push_back(bench.step(user, slot));
        ASSERT_TRUE(bench.scan(program))
            << fmt::format("{} slot {} distance {}", isa::info(user.opcode).name, slot, distance);
        ASSERT_TRUE(bench.devices_equal());
      }
    }
  }
}

// An index for each step: the last one counts, and each slot has its own.
TEST_P(Index, ANewIndexEveryStep) {
  Bench bench(GetParam());
  fill(bench);
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (int count = 1; count <= kSize; ++count) {
      std::vector<Step> program;
      for (int i = 0; i < count; ++i) {
        program.push_back(bench.step(
            with_constant(Opcode::Ix, kZero, static_cast<std::uint16_t>(kTable + i * 5 % kSize)),
            slot));
      }
      pad(bench, program, kLatency);
      program.push_back(bench.step(into(Opcode::Mvx, kResult, true), slot));
      if (bench.slots() == 2) {
        const auto other = static_cast<std::size_t>(1 - slot);
        program.front()[other] = with_constant(Opcode::Ix, kZero, kTable + 3);
        program.back()[other] = into(Opcode::Mvx, kResult + 1, true);
      }
      ASSERT_TRUE(bench.scan(program));
      EXPECT_EQ(bench.rtl().read_word(kResult), 0x100 * ((count - 1) * 5 % kSize) + 7);
      if (bench.slots() == 2) {
        EXPECT_EQ(bench.rtl().read_word(kResult + 1), 0x307);
      }
    }
  }
}

// s1 + s2 of any two operands, also such as were written just before; modulo the devices.
TEST_P(Index, SumOfItsOperands) {
  Bench bench(GetParam());
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (int distance = 1; distance <= 6; ++distance) {
      for (const int base : {kTable, kTable - 0x8000, 0x7fff + kTable}) {
        const auto offset = static_cast<std::uint16_t>(kTable + 5 - base);
        fill(bench);
        bench.set_word(kBase + 1, offset);
        std::vector<Step> program{
            bench.step(move_constant(static_cast<std::uint16_t>(base), kBase), slot)};
        pad(bench, program, distance);
        program.push_back(bench.step(word(Opcode::Ix, kBase, kBase + 1, 0, false), slot));
        pad(bench, program, kLatency);
        program.push_back(bench.step(into(Opcode::Mvx, kResult, true), slot));
        ASSERT_TRUE(bench.scan(program)) << base << " at " << distance;
        ASSERT_EQ(bench.rtl().read_word(kResult), 0x507) << base << " at " << distance;
      }
    }
    for (const isa::SlotInstruction& user : users(bench)) {
      fill(bench);
      bench.set_word(kBase,
                     static_cast<std::uint16_t>(kTable + 2 + 3 * bench.config().bit_devices));
      std::vector<Step> program{bench.step(word(Opcode::Ix, kBase, kZero, 0), slot)};
      pad(bench, program, kLatency);
      program.push_back(bench.step(user, slot));
      ASSERT_TRUE(bench.scan(program)) << isa::info(user.opcode).name;
      ASSERT_TRUE(bench.devices_equal());
    }
  }
}

// A step that waits in ID1, or one that waits there before it, does not lose the index.
TEST_P(Index, AroundWaitingSteps) {
  Bench bench(GetParam());
  const bool two = bench.slots() == 2;
  for (const Opcode waiting : {Opcode::Mul, Opcode::Div}) {
    for (int slot = 0; slot < bench.slots(); ++slot) {
      for (int before = 0; before <= kLatency + 1; ++before) {
        for (const isa::SlotInstruction& user : users(bench)) {
          fill(bench);
          const isa::SlotInstruction wait = word(waiting, kTable + 1, kTable, kResult + 5);
          std::vector<Step> program{bench.step(with_constant(Opcode::Ix, kZero, kTable + 6), slot)};
          for (int i = 0; i < before; ++i) program.push_back(bench.step(nop()));
          program.push_back(bench.step(wait, two ? 1 - slot : slot));
          // The wait makes up for the steps that are missing, if it is long enough.
          const int clocks = 1 + before + bench.config().clocks(waiting);
          if (clocks < kLatency) pad(bench, program, kLatency - clocks + 1);
          program.push_back(bench.step(user, slot));
          if (two && before + 1 >= kLatency) {
            program.push_back(bench.step(user, slot));
            program.back()[static_cast<std::size_t>(1 - slot)] = wait;
          }
          ASSERT_TRUE(bench.scan(program))
              << fmt::format("{} {} steps before {}", isa::info(user.opcode).name, before,
                             isa::info(waiting).name);
          ASSERT_TRUE(bench.devices_equal());
        }
      }
    }
  }
}

// Indexed writes without u obey exc, and leave it.
TEST_P(Index, WritesAreGated) {
  Bench bench(GetParam());
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (const bool exc : {false, true}) {
      for (const bool always : {false, true}) {
        fill(bench);
        std::vector<Step> program{bench.step(with_constant(Opcode::Ix, kZero, kTable + 1), slot),
                                  bench.step(contact(Opcode::Ld, exc ? kOne : kTable), slot)};
        pad(bench, program, kLatency);
        program.push_back(bench.step(with_constant(Opcode::Stx, kZero, 9, 0, always), slot));
        program.push_back(bench.step(indexed_coil(Opcode::Rstx, always), slot));
        program.push_back(bench.step(into(Opcode::Mvx, kResult, always), slot));
        program.push_back(bench.step(coil(bench.mpu(), Opcode::Out, kResult + 1), slot));
        bench.set_word(kResult, 1);
        ASSERT_TRUE(bench.scan(program));
        const bool run = exc || always;
        EXPECT_EQ(bench.rtl().read_word(kTable + 1), run ? 9 : 0x107);
        EXPECT_EQ(bench.rtl().read_bit(kTable + 1), !run);
        EXPECT_EQ(bench.rtl().read_word(kResult), run ? 9 : 1);
        EXPECT_EQ(bench.rtl().read_bit(kResult + 1), exc);
      }
    }
  }
}

// LDX pushes like LD.
class ContactIndex : public Index {};

TEST_P(ContactIndex, IndexedLoadPushes) {
  Bench bench(GetParam());
  fill(bench);
  for (const bool pushed : {false, true}) {
    std::vector<Step> program{{with_constant(Opcode::Ix, kZero, kTable + 4)}};
    pad(bench, program, kLatency);
    program.push_back({contact(Opcode::Ld, pushed ? kOne : kTable)});
    program.push_back({read_bit(bench)});
    program.push_back({plain(Opcode::Anb)});
    ASSERT_TRUE(bench.scan(program));
    EXPECT_TRUE(bench.retired()[program.size() - 2].exc);
    EXPECT_EQ(bench.retired()[program.size() - 1].exc, pushed);
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, Index, testing::ValuesIn(targets(kAllMpus)), target_name);
INSTANTIATE_TEST_SUITE_P(Rtl, ContactIndex, testing::ValuesIn(targets({isa::Mpu::Mpu1})),
                         target_name);

}  // namespace
}  // namespace rung::tb
