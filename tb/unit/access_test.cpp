// SPDX-License-Identifier: Apache-2.0
// Every way to write a device against every way to read it, at each distance, from either slot to
// either: what a test writes and what an indexed access reads or writes is forwarded like the rest,
// and what was not executed is not.
#include <fmt/format.h>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

constexpr int kMaxDistance = 6;
constexpr int kDevice = 30;  // written and read
constexpr int kOther = 31;
constexpr int kCopy = 32;    // where a read goes
constexpr int kZero = 2;     // word that is 0
constexpr int kTrue = 1;     // bit that is 1
constexpr int kFalse = 0;    // bit that is 0
constexpr int kSource = 40;  // bit that a copy takes

class Access : public testing::TestWithParam<Target> {
 protected:
  struct Way {
    const char* name;
    isa::SlotInstruction instruction;
    int index = kDevice;  // what the slot's ix has to be
  };

  // ix of both slots; then nothing until it may be used.
  static std::vector<Step> indexes(const Bench& bench, int slot, int index, int other_index) {
    Step step(static_cast<std::size_t>(bench.slots()));
    for (int s = 0; s < bench.slots(); ++s) {
      step[static_cast<std::size_t>(s)] = with_constant(
          Opcode::Ix, kZero, static_cast<std::uint16_t>(s == slot ? index : other_index));
    }
    std::vector<Step> program{step};
    for (int i = 1; i < isa::constant::index_latency; ++i) program.push_back(bench.step(nop()));
    return program;
  }

  static std::vector<Way> bit_writes(const Bench& bench, bool value, bool always) {
    const isa::Mpu mpu = bench.mpu();
    // What its rs, which is 0, and its constant have to be compared by.
    const auto compare = [&](Opcode opcode, bool greater) {
      isa::SlotInstruction out = test(mpu, opcode, kZero, 0, kDevice, always);
      out.kind = isa::WordKind::DeviceConstant;
      out.source = greater ? 1 : 0;
      return out;
    };
    isa::SlotInstruction bit =
        test(mpu, Opcode::Tb, kZero, value ? 0x0040 : 0xffbf, kDevice, always);
    bit.kind = isa::WordKind::ConstantDevice;
    bit.rs = kCopy + 1;  // 6
    std::vector<Way> ways{
        {"SET, RST", coil(mpu, value ? Opcode::Set : Opcode::Rst, kDevice, always)},
        {"EQ", compare(Opcode::Eq, !value)},
        {"LT", compare(Opcode::Lt, value)},
        {"LTU", compare(Opcode::Ltu, value)},
        {"LTC", compare(Opcode::Ltc, value)},
        {"TB", bit},
        {"SETX, RSTX", indexed_coil(value ? Opcode::Setx : Opcode::Rstx, always)}};
    if (mpu != isa::Mpu::Mpu1 && always) {
      isa::SlotInstruction copy;
      copy.opcode = Opcode::Mvbx;
      copy.c = device(kDevice);
      ways.push_back({"MVBX", copy, kSource});
    }
    return ways;
  }

  // All give the bit as the lowest of acc, or in exc, or in bit kCopy.
  static std::vector<Way> bit_reads(const Bench& bench) {
    isa::SlotInstruction indexed;
    if (bench.mpu() == isa::Mpu::Mpu1) {
      indexed.opcode = Opcode::Ldx;
      return {{"LD", contact(Opcode::Ld, kDevice)},
              {"LDX", indexed},
              {"GET", contact(Opcode::Get, kDevice)}};
    }
    indexed.opcode = Opcode::Mvbx;
    indexed.c = device(kCopy);
    isa::SlotInstruction gather = contact(Opcode::Get, kFalse);
    gather.c = device(kDevice);
    gather.always = true;
    return {{"LD", contact(Opcode::Ld, kDevice)}, {"MVBX", indexed}, {"GET", gather}};
  }

  static std::vector<Way> word_writes(std::uint16_t value, bool always) {
    isa::SlotInstruction indexed = with_constant(Opcode::Stx, kOther, value, 0, always);
    isa::SlotInstruction from_rs = word(Opcode::Stx, kCopy + 2, 0x1111, 0, always);
    from_rs.kind = isa::WordKind::ConstantDevice;
    return {{"MV", move_constant(value, kDevice, always)},
            {"MINU", with_constant(Opcode::Minu, kCopy + 3, value, kDevice, always)},
            {"STX", indexed},
            {"STX of rs", from_rs}};
  }

  static std::vector<Way> word_reads() {
    isa::SlotInstruction second = word(Opcode::Wor, kDevice, 0, kCopy);
    second.kind = isa::WordKind::ConstantDevice;
    isa::SlotInstruction indexed = into(Opcode::Mvx, kCopy, true);
    indexed.kind = isa::WordKind::ConstantDevice;  // its fields do not matter
    return {{"s1", word(Opcode::Add, kDevice, kZero, kCopy)},
            {"s2", word(Opcode::Wor, kZero, kDevice, kCopy)},
            {"s2 in rs", second},
            {"MVX", into(Opcode::Mvx, kCopy, true)},
            {"MVX of any kind", indexed}};
  }

  // The program that writes, waits and reads; nothing if one slot would need two indexes.
  static std::vector<Step> program(const Bench& bench, const Way& write, int writer,
                                   const Way& read, int reader, int distance) {
    const bool one_slot = writer == reader;
    if (one_slot && write.index != read.index) return {};
    std::vector<Step> program = indexes(bench, writer, write.index, read.index);
    program.push_back(bench.step(write.instruction, writer));
    for (int i = 1; i < distance; ++i) program.push_back(bench.step(nop()));
    program.push_back(bench.step(read.instruction, reader));
    program.push_back(bench.step(into(Opcode::Mva, kCopy + 4, true), reader));
    return program;
  }
};

TEST_P(Access, Bits) {
  Bench bench(GetParam());
  bench.set_bit(kTrue, true);
  bench.set_word(kCopy + 1, 6);
  int compared = 0;
  for (int writer = 0; writer < bench.slots(); ++writer) {
    for (int reader = 0; reader < bench.slots(); ++reader) {
      for (int distance = 1; distance <= kMaxDistance; ++distance) {
        for (int variant = 0; variant < 8; ++variant) {
          const bool old = (variant & 1) != 0;
          const bool value = (variant & 2) != 0;
          const bool always = (variant & 4) != 0;  // exc is 0: without u nothing is written
          for (const Way& write : bit_writes(bench, value, always)) {
            for (const Way& read : bit_reads(bench)) {
              const std::vector<Step> steps = program(bench, write, writer, read, reader, distance);
              if (steps.empty()) continue;
              bench.set_bit(kDevice, old);
              bench.set_bit(kSource, value);
              bench.set_bit(kCopy, false);
              const auto where =
                  fmt::format("{} by slot {}, {} by slot {}, distance {}, {:d} over {:d}, u {:d}",
                              write.name, writer, read.name, reader, distance, value, old, always);
              ASSERT_TRUE(bench.scan(steps)) << where;
              const bool want = always ? value : old;
              const Retired& r =
                  bench.retired()[(steps.size() - 2) * static_cast<std::size_t>(bench.slots()) +
                                  static_cast<std::size_t>(reader)];
              if (read.instruction.opcode == Opcode::Get) {
                ASSERT_EQ(bench.rtl().read_word(kCopy + 4), want ? 1 : 0) << where;
              } else if (read.instruction.opcode == Opcode::Mvbx) {
                ASSERT_TRUE(r.bit_we) << where;
                ASSERT_EQ(r.bit_value, want) << where;
              } else {
                ASSERT_EQ(r.exc, want) << where;
              }
              ++compared;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 0);
}

TEST_P(Access, Words) {
  Bench bench(GetParam());
  constexpr std::uint16_t kOldValue = 0x5aa5;
  constexpr std::uint16_t kNewValue = 0xc33c;
  bench.set_word(kCopy + 2, kNewValue);
  bench.set_word(kCopy + 3, 0xffff);
  for (int writer = 0; writer < bench.slots(); ++writer) {
    for (int reader = 0; reader < bench.slots(); ++reader) {
      for (int distance = 1; distance <= kMaxDistance; ++distance) {
        for (const bool always : {false, true}) {
          for (const Way& write : word_writes(kNewValue, always)) {
            for (const Way& read : word_reads()) {
              bench.set_word(kDevice, kOldValue);
              const auto where =
                  fmt::format("{} by slot {}, {} by slot {}, distance {}, u {:d}", write.name,
                              writer, read.name, reader, distance, always);
              ASSERT_TRUE(bench.scan(program(bench, write, writer, read, reader, distance)))
                  << where;
              ASSERT_EQ(bench.rtl().read_word(kCopy), always ? kNewValue : kOldValue) << where;
            }
          }
        }
      }
    }
  }
}

// What a slot's bank gets depends on the other's: tests and indexed writes over each other's
// devices, at all distances, in all sequences of slots and ways.
TEST_P(Access, SlotsRewriteEachOthersDevices) {
  Bench bench(GetParam());
  bench.set_word(kCopy + 1, 6);
  bench.set_word(kCopy + 3, 0xffff);
  constexpr std::uint16_t kValues[] = {0x1248, 0xfffe, 0x0f0f};
  const std::vector<Step> before = indexes(bench, 0, kDevice, kDevice);
  const std::size_t bit_ways = bit_writes(bench, false, true).size();
  for (int sequence = 0; sequence < (bench.slots() == 2 ? 8 : 1); ++sequence) {
    for (int gaps = 0; gaps < kMaxDistance * kMaxDistance; ++gaps) {
      for (std::size_t way = 0; way < bit_ways; ++way) {
        std::vector<Step> program = before;
        for (int i = 0; i < 3; ++i) {
          const int slot = sequence >> i & 1;
          const bool bit = (kValues[i] >> way & 1) != 0;
          const std::vector<Way> words = word_writes(kValues[i], true);
          isa::SlotInstruction write_word =
              words[(way + static_cast<std::size_t>(i)) % 3].instruction;
          const std::vector<Way> bits = bit_writes(bench, bit, true);
          const std::size_t which = (way + 3 * static_cast<std::size_t>(i)) % bit_ways;
          isa::SlotInstruction write_bit = bits[which].instruction;
          if (bits[which].index != kDevice) write_bit = bits[0].instruction;
          program.push_back(bench.step(write_word, slot));
          const int distance = i == 0 ? gaps % kMaxDistance : gaps / kMaxDistance;
          if (bench.slots() == 2) {
            program.back()[static_cast<std::size_t>(1 - slot)] = write_bit;
          } else {
            program.push_back(bench.step(write_bit));
          }
          for (int k = 0; k < distance && i < 2; ++k) program.push_back(bench.step(nop()));
        }
        const auto where = fmt::format("sequence {} gaps {} way {}", sequence, gaps, way);
        ASSERT_TRUE(bench.scan(program)) << where;
        ASSERT_EQ(bench.rtl().read_word(kDevice), kValues[2]) << where;
        ASSERT_EQ(bench.rtl().read_bit(kDevice), (kValues[2] >> way & 1) != 0) << where;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, Access, testing::ValuesIn(targets(kAllMpus)), target_name);

}  // namespace
}  // namespace rung::tb
