// SPDX-License-Identifier: Apache-2.0
// A device just written is read at every distance, by every slot and operand; a gated write that
// did not happen is not forwarded; and the XOR banks stay consistent when slots rewrite each
// other's devices.
#include <fmt/format.h>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

constexpr int kMaxDistance = 6;
constexpr int kDevice = 30;
constexpr int kOther = 31;
constexpr int kOne = 1;   // bit that is 1
constexpr int kZero = 0;  // bit that is 0
constexpr int kCopyA = 1, kCopyB = 2, kCopyC = 3, kConst0 = 4, kConst1 = 5;

class Forwarding : public testing::TestWithParam<Target> {
 protected:
  static void prepare(Bench& bench) {
    bench.set_bit(kOne, true);
    bench.set_lut(kCopyA, 0xf0);
    bench.set_lut(kCopyB, 0xcc);
    bench.set_lut(kCopyC, 0xaa);
    bench.set_lut(kConst0, 0x00);
    bench.set_lut(kConst1, 0xff);
  }
  // SET or RST of a bit in any case: the shortest write of a known value.
  static isa::SlotInstruction write_bit(const Bench& bench, int number, bool value) {
    return coil(bench.mpu(), value ? Opcode::Set : Opcode::Rst, number, true);
  }
  // Reads a bit into exc as operand `position` (0 a, 1 b, 2 c); MPU1 has only `a`.
  static isa::SlotInstruction read_bit(const Bench& bench, int number, int position) {
    if (bench.mpu() == isa::Mpu::Mpu1) return contact(Opcode::Ld, number);
    isa::BitOperand operands[] = {device(kOther), device(kOther), device(kOther)};
    operands[position] = device(number);
    return look_up(Opcode::Lut, kCopyA + position, operands[0], operands[1], operands[2]);
  }
  static int positions(const Bench& bench) { return bench.mpu() == isa::Mpu::Mpu1 ? 1 : 3; }
  static void pad(const Bench& bench, std::vector<Step>& program, int distance) {
    for (int i = 1; i < distance; ++i) program.push_back(bench.step(nop()));
  }
  static const Retired& last(const Bench& bench, int slot) {
    return bench.retired()[bench.retired().size() - static_cast<std::size_t>(bench.slots()) +
                           static_cast<std::size_t>(slot)];
  }
};

class TwoSlotForwarding : public Forwarding {};

TEST_P(Forwarding, BitsFromEverySlotToEveryOperand) {
  Bench bench(GetParam());
  prepare(bench);
  for (int writer = 0; writer < bench.slots(); ++writer) {
    for (int reader = 0; reader < bench.slots(); ++reader) {
      for (int position = 0; position < positions(bench); ++position) {
        for (int distance = 1; distance <= kMaxDistance; ++distance) {
          // old and new value: reading a RAM word while it is written gives the old one's
          // complement
          for (int values = 0; values < 4; ++values) {
            const bool value = (values & 1) != 0;
            bench.set_bit(kDevice, (values & 2) != 0);
            std::vector<Step> program{bench.step(write_bit(bench, kDevice, value), writer)};
            pad(bench, program, distance);
            program.push_back(bench.step(read_bit(bench, kDevice, position), reader));
            const auto where = fmt::format("writer {} reader {} operand {} distance {}", writer,
                                           reader, position, distance);
            ASSERT_TRUE(bench.scan(program)) << where;
            EXPECT_EQ(last(bench, reader).exc, value) << where;
          }
        }
      }
    }
  }
}

TEST_P(Forwarding, BitsThatAreNotWritten) {
  Bench bench(GetParam());
  prepare(bench);
  std::vector<std::pair<isa::SlotInstruction, isa::SlotInstruction>> gated;  // after LD 0
  gated.push_back({contact(Opcode::Ld, kZero), coil(bench.mpu(), Opcode::Set, kDevice)});
  gated.push_back({contact(Opcode::Ld, kZero), coil(bench.mpu(), Opcode::Rst, kDevice)});
  gated.push_back({nop(), nop()});
  if (bench.mpu() != isa::Mpu::Mpu1) {
    for (const Opcode opcode : {Opcode::Luts, Opcode::Lutr, Opcode::Lut}) {
      gated.push_back(
          {nop(), look_up(opcode, kConst0, device(kOther), device(kOther), device(kDevice))});
    }
  }
  for (const auto& [before, instruction] : gated) {
    for (int writer = 0; writer < bench.slots(); ++writer) {
      for (int reader = 0; reader < bench.slots(); ++reader) {
        for (int position = 0; position < positions(bench); ++position) {
          for (int distance = 1; distance <= kMaxDistance; ++distance) {
            for (const bool value : {false, true}) {
              bench.set_bit(kDevice, value);
              std::vector<Step> program{bench.step(before, writer),
                                        bench.step(instruction, writer)};
              pad(bench, program, distance);
              program.push_back(bench.step(read_bit(bench, kDevice, position), reader));
              const auto where = fmt::format("{} writer {} reader {} operand {} distance {}",
                                             isa::info(instruction.opcode).name, writer, reader,
                                             position, distance);
              ASSERT_TRUE(bench.scan(program)) << where;
              EXPECT_EQ(last(bench, reader).exc, value) << where;
            }
          }
        }
      }
    }
  }
}

TEST_P(Forwarding, WordsFromEverySlotToEveryOperand) {
  Bench bench(GetParam());
  prepare(bench);
  for (int writer = 0; writer < bench.slots(); ++writer) {
    for (int reader = 0; reader < bench.slots(); ++reader) {
      // operands: s1 as rs, s2 in source, s2 as rs beside a constant
      for (int position = 0; position < 3; ++position) {
        for (int distance = 1; distance <= kMaxDistance; ++distance) {
          for (const bool written : {true, false}) {
            bench.set_word(kDevice, 0x5aa5);
            bench.set_word(kOther, 0);
            // exc is 0: without u nothing is written
            std::vector<Step> program{bench.step(move_constant(0xc33c, kDevice, written), writer)};
            pad(bench, program, distance);
            isa::SlotInstruction read = word(Opcode::Add, kDevice, kOther, kOther + 1);
            if (position == 1) read = word(Opcode::Add, kOther, kDevice, kOther + 1);
            if (position == 2) {
              read.kind = isa::WordKind::ConstantDevice;
              read.source = 0;
            }
            program.push_back(bench.step(read, reader));
            const auto where =
                fmt::format("writer {} reader {} operand {} distance {} written {:d}", writer,
                            reader, position, distance, written);
            ASSERT_TRUE(bench.scan(program)) << where;
            EXPECT_EQ(last(bench, reader).word_value, written ? 0xc33c : 0x5aa5) << where;
          }
        }
      }
    }
  }
}

// Four writes to one device at all distances 1 to 6, by all sequences of slots: the bank that a
// slot writes depends on what the others hold.
TEST_P(Forwarding, SlotsRewriteEachOthersDevices) {
  Bench bench(GetParam());
  prepare(bench);
  constexpr int kWrites = 4;
  constexpr std::uint16_t kValues[] = {0x1248, 0xfffe, 0x0f0f, 0x8001};
  int sequences = 1;
  for (int i = 0; i < kWrites; ++i) sequences *= bench.slots();
  for (int sequence = 0; sequence < sequences; ++sequence) {
    for (int gaps = 0; gaps < kMaxDistance * kMaxDistance * kMaxDistance; ++gaps) {
      std::vector<Step> program;
      int rest = gaps;
      for (int i = 0; i < kWrites; ++i) {
        const int slot = bench.slots() == 1 ? 0 : sequence >> i & 1;
        // A bit and a word in one go, by alternate slots where there are two.
        Step step = bench.step(move_constant(kValues[i], kDevice), slot);
        if (bench.slots() == 2) {
          step[static_cast<std::size_t>(1 - slot)] =
              write_bit(bench, kDevice, (kValues[i] >> (gaps & 3) & 1) != 0);
        }
        program.push_back(step);
        if (i + 1 < kWrites) pad(bench, program, 1 + rest % kMaxDistance);
        rest /= kMaxDistance;
      }
      ASSERT_TRUE(bench.scan(program)) << "sequence " << sequence << " gaps " << gaps;
      ASSERT_EQ(bench.rtl().read_word(kDevice), kValues[kWrites - 1])
          << "sequence " << sequence << " gaps " << gaps;
      if (bench.slots() == 2) {
        ASSERT_EQ(bench.rtl().read_bit(kDevice), (kValues[kWrites - 1] >> (gaps & 3) & 1) != 0)
            << "sequence " << sequence << " gaps " << gaps;
      }
    }
  }
}

// Both slots use one device in one step: the one that reads sees what was there before.
TEST_P(TwoSlotForwarding, ReadBesideAWriteSeesTheOldValue) {
  Bench bench(GetParam());
  prepare(bench);
  for (int writer = 0; writer < 2; ++writer) {
    for (const bool old : {false, true}) {
      bench.set_bit(kDevice, old);
      bench.set_word(kDevice, old ? 99 : 11);
      Step bits = bench.step(write_bit(bench, kDevice, !old), writer);
      bits[static_cast<std::size_t>(1 - writer)] = read_bit(bench, kDevice, 0);
      Step words = bench.step(move_constant(55, kDevice), writer);
      words[static_cast<std::size_t>(1 - writer)] = word(Opcode::Mv, 0, kDevice, kOther);
      ASSERT_TRUE(bench.scan({bits, words}));
      EXPECT_EQ(bench.retired()[static_cast<std::size_t>(1 - writer)].exc, old);
      EXPECT_EQ(bench.rtl().read_word(kOther), old ? 99 : 11);
    }
  }
}

// exc of the instruction just before gates.
TEST_P(Forwarding, ExcGatesTheNextInstruction) {
  Bench bench(GetParam());
  prepare(bench);
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (int distance = 1; distance <= kMaxDistance; ++distance) {
      for (const bool exc : {false, true}) {
        bench.set_word(kDevice, 1);
        std::vector<Step> program{bench.step(contact(Opcode::Ld, exc ? kZero : kOne), slot),
                                  bench.step(contact(Opcode::Ld, exc ? kOne : kZero), slot)};
        pad(bench, program, distance);
        program.push_back(bench.step(move_constant(2, kDevice, false), slot));
        ASSERT_TRUE(bench.scan(program));
        EXPECT_EQ(bench.rtl().read_word(kDevice), exc ? 2 : 1);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, Forwarding, testing::ValuesIn(targets(kAllMpus)), target_name);
INSTANTIATE_TEST_SUITE_P(Rtl, TwoSlotForwarding, testing::ValuesIn(targets({isa::Mpu::Mpu3})),
                         target_name);

}  // namespace
}  // namespace rung::tb
