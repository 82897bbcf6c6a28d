// SPDX-License-Identifier: Apache-2.0
// The load port and the borders of a scan: every device can be written and read back, a scan sees
// what was written just before it and the host what the scan wrote last, and nothing leaks into the
// next scan.
#include <fmt/format.h>

#include <random>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

constexpr int kOne = 1;  // bit that is 1

class LoadPort : public testing::TestWithParam<Target> {};

TEST_P(LoadPort, EveryDeviceReadsBack) {
  Bench bench(GetParam());
  std::mt19937 random(7);
  for (int pass = 0; pass < 2; ++pass) {
    for (int i = 0; i < bench.config().bit_devices; ++i) bench.set_bit(i, random() % 2 != 0);
    for (int i = 0; i < bench.config().word_devices; ++i) {
      bench.set_word(i, static_cast<std::uint16_t>(random()));
    }
    ASSERT_TRUE(bench.devices_equal());
  }
}

// The banks of the other slot must not show through what the host writes over a program's write.
TEST_P(LoadPort, HostRewritesWhatASlotWrote) {
  Bench bench(GetParam());
  for (int slot = 0; slot < bench.slots(); ++slot) {
    ASSERT_TRUE(bench.scan({bench.step(move_constant(0xa55a, 2), slot),
                            bench.step(coil(bench.mpu(), Opcode::Set, 2, true), slot)}));
    EXPECT_EQ(bench.rtl().read_word(2), 0xa55a);
    EXPECT_TRUE(bench.rtl().read_bit(2));
    bench.set_word(2, 0x0ff0);
    bench.set_bit(2, false);
    EXPECT_EQ(bench.rtl().read_word(2), 0x0ff0);
    EXPECT_FALSE(bench.rtl().read_bit(2));
  }
}

TEST_P(LoadPort, WritesRightBeforeAScanAreSeenByItsFirstStep) {
  Bench bench(GetParam());
  const bool mpu1 = bench.mpu() == isa::Mpu::Mpu1;
  std::vector<Step> program{bench.step(contact(Opcode::Ld, 2)),
                            bench.step(word(Opcode::Mv, 0, 2, 3)),
                            bench.step(coil(bench.mpu(), Opcode::Out, 3))};
  ASSERT_TRUE(bench.scan(program));
  for (const std::uint16_t value : {0x8421, 0x0001, 0x0000, 0xffff}) {
    // The word last, then the bit last.
    bench.set_bit(2, (value & 1) != 0);
    bench.set_word(2, value);
    ASSERT_TRUE(bench.scan_again());
    EXPECT_EQ(bench.rtl().read_word(3), value);
    bench.set_bit(2, (value & 1) == 0);
    ASSERT_TRUE(bench.scan_again());
    EXPECT_EQ(bench.rtl().read_bit(3), (value & 1) == 0);
  }
  if (!mpu1) {
    ASSERT_TRUE(
        bench.scan({bench.step(look_up(Opcode::Luto, 9, device(0), device(0), device(4)))}));
    bench.set_lut(9, 0xff);
    ASSERT_TRUE(bench.scan_again());
    EXPECT_TRUE(bench.rtl().read_bit(4));
  }
}

// The program in full length: every step of the instruction memory is its own.
TEST_P(LoadPort, TheWholeInstructionMemory) {
  Bench bench(GetParam());
  const int steps = bench.config().steps(bench.mpu());
  std::vector<Step> program;
  std::mt19937 random(11);
  for (int i = 0; i < steps; ++i) {
    Step step;
    for (int slot = 0; slot < bench.slots(); ++slot) {
      step.push_back(move_constant(static_cast<std::uint16_t>(random()),
                                   2 * static_cast<int>(random() % 64) + slot));
    }
    program.push_back(step);
  }
  ASSERT_TRUE(bench.scan(program));
  EXPECT_TRUE(bench.devices_equal());
  // A step less: a length whose bits are all 1.
  program.pop_back();
  ASSERT_TRUE(bench.scan(program));
  EXPECT_TRUE(bench.devices_equal());
  program.resize(program.size() + 2, program.front());
  EXPECT_THROW(
      {
        std::vector<std::vector<std::uint64_t>> code(
            program.size(), std::vector<std::uint64_t>(static_cast<std::size_t>(bench.slots())));
        bench.rtl().load_program(code);
      },
      std::invalid_argument);
}

TEST_P(LoadPort, NothingLeaksIntoTheNextScan) {
  Bench bench(GetParam());
  const bool mpu1 = bench.mpu() == isa::Mpu::Mpu1;
  bench.set_bit(kOne, true);
  bench.set_word(2, 5);
  // Leaves exc 1, the stacks not empty and the unit with a result, or at work.
  std::vector<Step> leave;
  // Writes a device for each of them that is not as at the start.
  std::vector<Step> probe;
  if (mpu1) {
    for (int i = 0; i < 3; ++i) {
      leave.push_back({contact(Opcode::Ld, kOne)});
      leave.push_back({plain(Opcode::Mps)});
    }
    leave.push_back({word(Opcode::Mul, 2, 2, 3)});
    isa::SlotInstruction high = plain(Opcode::Mvh);
    high.rd = 10;
    probe = {{coil(bench.mpu(), Opcode::Out, 10)},
             {high},
             {plain(Opcode::Orb)},
             {coil(bench.mpu(), Opcode::Out, 11)},
             {plain(Opcode::Mpp)},
             {coil(bench.mpu(), Opcode::Out, 12)}};
  } else {
    for (const Opcode start : {Opcode::Muls, Opcode::Divs}) {
      const auto slots = static_cast<std::size_t>(bench.slots());
      leave = {Step(slots, contact(Opcode::Ld, kOne)), Step(slots, word(start, 2, 2, 0))};
      isa::SlotInstruction low = plain(Opcode::Mvl);
      Step collect(slots, low);
      Step out(slots, coil(bench.mpu(), Opcode::Out, 10));
      for (std::size_t slot = 0; slot < slots; ++slot) {
        collect[slot].rd = static_cast<std::uint16_t>(10 + slot);
        out[slot].c = device(10 + static_cast<int>(slot));
      }
      probe = {out};
      for (int i = 0; i < bench.config().div_latency; ++i) probe.push_back(bench.step(nop()));
      probe.push_back(collect);
      ASSERT_TRUE(bench.scan(leave));
      ASSERT_TRUE(bench.scan(probe));
      for (int slot = 0; slot < bench.slots(); ++slot) {
        EXPECT_FALSE(bench.rtl().read_bit(10 + slot));
        EXPECT_EQ(bench.rtl().read_word(10 + slot), 0);
      }
    }
    return;
  }
  ASSERT_TRUE(bench.scan(leave));
  ASSERT_TRUE(bench.scan(probe));
  for (int i = 10; i <= 12; ++i) EXPECT_FALSE(bench.rtl().read_bit(i)) << i;
  EXPECT_EQ(bench.rtl().read_word(10), 0);
}

// Between the scans of one program too, without the load port in between.
TEST_P(LoadPort, ScansBackToBack) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  isa::SlotInstruction increment = word(Opcode::Add, 2, 1, 2);
  increment.kind = isa::WordKind::DeviceConstant;
  const int slot = bench.slots() - 1;
  // The first coil shows the exc that the scan starts with, the last step leaves 1.
  ASSERT_TRUE(
      bench.scan({bench.step(coil(bench.mpu(), Opcode::Out, 5), slot), bench.step(increment, slot),
                  bench.step(contact(Opcode::Ld, kOne), slot)}));
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(bench.scan_again());
  EXPECT_EQ(bench.rtl().read_word(2), 21);
}

// Neither program, look-ups, devices nor length change, and no read is answered.
TEST_P(LoadPort, AccessesInAScanAreIgnored) {
  Bench bench(GetParam());
  const bool mpu1 = bench.mpu() == isa::Mpu::Mpu1;
  for (int row = 0; row < isa::constant::lut_rows; ++row) {
    bench.set_lut(row, static_cast<std::uint8_t>(0x35 * row + 7));
  }
  for (int i = 0; i < 64; ++i) bench.set_bit(i, i % 3 == 0);
  std::vector<Step> program;
  for (int i = 0; i < 60; ++i) {
    program.push_back(bench.step(contact(Opcode::Ld, i)));
    program.push_back(bench.step(coil(bench.mpu(), Opcode::Out, 100 + i)));
    program.push_back(bench.step(move_constant(0x1111 * (i % 15), 10 + i)));
    if (!mpu1) {
      program.push_back(
          bench.step(look_up(Opcode::Luto, 2 * i, device(i), device(i + 1), device(200 + i))));
    }
  }
  bench.rtl().disturb_load_port(true);
  testing::AssertionResult same = bench.scan(program);
  for (int i = 0; i < 40 && same; ++i) same = bench.scan_again();
  bench.rtl().disturb_load_port(false);
  ASSERT_TRUE(same);
  ASSERT_TRUE(bench.scan_again());
  EXPECT_TRUE(bench.devices_equal());
}

TEST_P(LoadPort, ResetKeepsMemoriesAndEndsTheScan) {
  Bench bench(GetParam());
  ASSERT_TRUE(bench.scan({bench.step(move_constant(0x7777, 2))}));
  bench.rtl().reset();
  EXPECT_EQ(bench.rtl().read_word(2), 0x7777);
  ASSERT_TRUE(bench.scan_again());
}

INSTANTIATE_TEST_SUITE_P(Rtl, LoadPort, testing::ValuesIn(targets(kAllMpus)), target_name);

}  // namespace
}  // namespace rung::tb
