// SPDX-License-Identifier: Apache-2.0
// Every opcode of every processor, in every slot, with corner operands, each kind of operand, exc 0
// and 1, with and without u.
#include <fmt/format.h>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

class Opcodes : public testing::TestWithParam<Target> {
 protected:
  static bool has(Opcode opcode) {
    const isa::OpcodeInfo& info = isa::info(opcode);
    return GetParam().mpu == isa::Mpu::Mpu1 ? info.on_mpu1 : info.on_slot;
  }
};

class ContactOpcodes : public Opcodes {};  // those of MPU1 alone

// Devices of these tests.
constexpr int kS1 = 3;
constexpr int kS2 = 4;
constexpr int kRd = 5;
constexpr int kRd2 = 6;
constexpr int kOne = 7;   // bit that is 1
constexpr int kZero = 8;  // bit that is 0
constexpr int kTarget = 9;

// What the arithmetic has to give, written here once more for the opcodes that have one result; no
// carry comes in.
std::uint16_t expected_result(Opcode opcode, std::int16_t s1, std::int16_t s2) {
  const auto u1 = static_cast<std::uint16_t>(s1);
  const auto u2 = static_cast<std::uint16_t>(s2);
  switch (opcode) {
    case Opcode::Add:
    case Opcode::Adc:
      return static_cast<std::uint16_t>(s1 + s2);
    case Opcode::Sub:
    case Opcode::Sbc:
      return static_cast<std::uint16_t>(s1 - s2);
    case Opcode::Mul:
      return static_cast<std::uint16_t>(s1 * s2);
    case Opcode::Div:
      return static_cast<std::uint16_t>(s1 / s2);
    case Opcode::Wand:
      return u1 & u2;
    case Opcode::Wor:
      return u1 | u2;
    case Opcode::Wxor:
      return u1 ^ u2;
    case Opcode::Rol:
      return static_cast<std::uint16_t>(u1 << u2 % 16 | u1 >> (16 - u2 % 16));
    case Opcode::Minu:
      return u1 < u2 ? u1 : u2;
    default:
      return static_cast<std::uint16_t>(s2);
  }
}

TEST_P(Opcodes, WordInstructionsOnCornerOperands) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  constexpr std::uint16_t kOld = 0x1234;
  for (const Opcode opcode :
       {Opcode::Mv, Opcode::Add, Opcode::Sub, Opcode::Mul, Opcode::Div, Opcode::Adc, Opcode::Sbc,
        Opcode::Wand, Opcode::Wor, Opcode::Wxor, Opcode::Rol, Opcode::Minu}) {
    for (int variant = 0; variant < 3 * 2 * 2 * bench.slots(); ++variant) {
      const auto kind = static_cast<isa::WordKind>(variant % 3);
      const bool exc = variant / 3 % 2 != 0;
      const bool always = variant / 6 % 2 != 0;
      const int slot = variant / 12;
      std::vector<Step> program;
      std::vector<std::size_t> at;
      for (const std::uint16_t s1 : kCorners) {
        for (const std::uint16_t s2 : kCorners) {
          isa::SlotInstruction instruction = word(opcode, kS1, kS2, kRd, always);
          instruction.kind = kind;
          std::uint16_t rs = s1;
          if (kind == isa::WordKind::DeviceConstant) instruction.source = s2;
          if (kind == isa::WordKind::ConstantDevice) {
            instruction.source = s1;
            rs = s2;
          }
          program.push_back(bench.step(contact(Opcode::Ld, exc ? kOne : kZero), slot));
          program.push_back(bench.step(move_constant(rs, kS1), slot));
          program.push_back(bench.step(move_constant(s2, kS2), slot));
          program.push_back(bench.step(move_constant(kOld, kRd), slot));
          program.push_back(bench.step(with_constant(Opcode::Cmp, kS1, 0), slot));  // no carry
          at.push_back(program.size() * static_cast<std::size_t>(bench.slots()) +
                       static_cast<std::size_t>(slot));
          program.push_back(bench.step(instruction, slot));
        }
      }
      SCOPED_TRACE(fmt::format("{} kind {} exc {:d} u {:d} slot {}", isa::info(opcode).name,
                               static_cast<int>(kind), exc, always, slot));
      ASSERT_TRUE(bench.scan(program));
      std::size_t pair = 0;
      for (const std::uint16_t s1 : kCorners) {
        for (const std::uint16_t s2 : kCorners) {
          const Retired& retired = bench.retired()[at[pair++]];
          const bool write = (exc || always) && !(opcode == Opcode::Div && s2 == 0);
          ASSERT_EQ(retired.word_we, write) << s1 << ", " << s2;
          if (!write) continue;
          ASSERT_EQ(retired.word_value, expected_result(opcode, static_cast<std::int16_t>(s1),
                                                        static_cast<std::int16_t>(s2)))
              << s1 << ", " << s2;
        }
      }
    }
  }
  EXPECT_TRUE(bench.devices_equal());
}

TEST_P(Opcodes, HighWordAndRemainderAfterTheWait) {
  Bench bench(GetParam());
  for (const Opcode opcode : {Opcode::Mul, Opcode::Div}) {
    for (int slot = 0; slot < bench.slots(); ++slot) {
      for (const std::uint16_t s1 : kCorners) {
        for (const std::uint16_t s2 : kCorners) {
          bench.set_word(kS1, s1);
          bench.set_word(kS2, s2);
          bench.set_word(kRd, 77);
          bench.set_word(kRd2, 88);
          isa::SlotInstruction high = plain(Opcode::Mvh);
          high.rd = kRd2;
          ASSERT_TRUE(
              bench.scan({bench.step(word(opcode, kS1, kS2, kRd), slot), bench.step(high, slot)}));
          const bool valid = opcode == Opcode::Mul || s2 != 0;
          const auto a = static_cast<std::int16_t>(s1);
          const auto b = static_cast<std::int16_t>(s2);
          int want = 88;
          if (valid) want = opcode == Opcode::Mul ? (a * b) >> 16 : a % b;
          ASSERT_EQ(bench.rtl().read_word(kRd2), static_cast<std::uint16_t>(want)) << a << " " << b;
        }
      }
    }
  }
}

TEST_P(Opcodes, CoilsForEachExcAndOldValue) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  for (const Opcode opcode : {Opcode::Out, Opcode::Set, Opcode::Rst}) {
    for (int variant = 0; variant < 8 * bench.slots(); ++variant) {
      const bool exc = variant % 2 != 0;
      const bool old = variant / 2 % 2 != 0;
      const bool always = variant / 4 % 2 != 0 && opcode != Opcode::Out;
      const int slot = variant / 8;
      SCOPED_TRACE(fmt::format("{} exc {:d} old {:d} u {:d} slot {}", isa::info(opcode).name, exc,
                               old, always, slot));
      bench.set_bit(kTarget, old);
      ASSERT_TRUE(bench.scan({bench.step(contact(Opcode::Ld, exc ? kOne : kZero), slot),
                              bench.step(coil(bench.mpu(), opcode, kTarget, always), slot),
                              // exc is what it was
                              bench.step(coil(bench.mpu(), Opcode::Out, kTarget + 1), slot)}));
      bool want = exc;
      if (opcode != Opcode::Out) want = exc || always ? opcode == Opcode::Set : old;
      EXPECT_EQ(bench.rtl().read_bit(kTarget), want);
      EXPECT_EQ(bench.rtl().read_bit(kTarget + 1), exc);
    }
  }
}

TEST_P(ContactOpcodes, ContactsAndBlocks) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  for (int values = 0; values < 8; ++values) {
    const auto bit = [&](int i) { return (values >> i & 1) != 0 ? kOne : kZero; };
    const bool exc = (values & 1) != 0;
    const bool a = (values & 2) != 0;
    const std::pair<Opcode, bool> contacts[] = {
        {Opcode::Ld, a},          {Opcode::Ldi, !a},      {Opcode::And, exc && a},
        {Opcode::Ani, exc && !a}, {Opcode::Or, exc || a}, {Opcode::Ori, exc || !a},
    };
    for (const auto& [opcode, want] : contacts) {
      ASSERT_TRUE(bench.scan({{contact(Opcode::Ld, bit(0))}, {contact(opcode, bit(1))}}));
      EXPECT_EQ(bench.retired()[1].exc, want) << isa::info(opcode).name << " " << values;
    }
    // (bit 0 op bit 1) op bit 2, with every combination of block instructions
    for (int ops = 0; ops < 4; ++ops) {
      const Opcode first = (ops & 1) != 0 ? Opcode::Anb : Opcode::Orb;
      const Opcode second = (ops & 2) != 0 ? Opcode::Anb : Opcode::Orb;
      ASSERT_TRUE(bench.scan({{contact(Opcode::Ld, bit(2))},
                              {contact(Opcode::Ld, bit(1))},
                              {contact(Opcode::Ldi, bit(0))},
                              {plain(first)},
                              {plain(second)}}));
      const bool b1 = (values & 2) != 0;
      const bool b2 = (values & 4) != 0;
      const bool inner = (ops & 1) != 0 ? !exc && b1 : !exc || b1;
      EXPECT_EQ(bench.retired()[4].exc, (ops & 2) != 0 ? inner && b2 : inner || b2) << values;
    }
    ASSERT_TRUE(bench.scan({{contact(Opcode::Ld, bit(0))},
                            {plain(Opcode::Mps)},
                            {contact(Opcode::And, bit(1))},
                            {plain(Opcode::Mps)},
                            {contact(Opcode::And, bit(2))},
                            {plain(Opcode::Mrd)},
                            {plain(Opcode::Mpp)},
                            {plain(Opcode::Mpp)}}));
    EXPECT_EQ(bench.retired()[5].exc, exc && a) << values;
    EXPECT_EQ(bench.retired()[6].exc, exc && a) << values;
    EXPECT_EQ(bench.retired()[7].exc, exc) << values;
  }
}

TEST_P(ContactOpcodes, InvertAndPop) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  for (int values = 0; values < 8; ++values) {
    const auto bit = [&](int i) { return (values >> i & 1) != 0; };
    const auto load = [&](int i) { return Step{contact(Opcode::Ld, bit(i) ? kOne : kZero)}; };
    ASSERT_TRUE(bench.scan({load(0),
                            load(1),
                            {plain(Opcode::Inv)},
                            load(2),
                            {plain(Opcode::Inv)},
                            {plain(Opcode::Inv)},
                            {plain(Opcode::Pop)},
                            {plain(Opcode::Pop)},
                            {plain(Opcode::Inv)}}));
    EXPECT_EQ(bench.retired()[2].exc, !bit(1)) << values;
    EXPECT_EQ(bench.retired()[5].exc, bit(2)) << values;
    EXPECT_EQ(bench.retired()[6].exc, !bit(1)) << values;
    EXPECT_EQ(bench.retired()[7].exc, bit(0)) << values;
    EXPECT_EQ(bench.retired()[8].exc, !bit(0)) << values;
  }
}

TEST_P(ContactOpcodes, StacksHoldWhatTheTableSays) {
  Bench bench(GetParam());
  bench.set_bit(kOne, true);
  const std::uint32_t pattern = 0xb2e5;
  std::vector<Step> program;
  // exc of every LD is pushed by the next; the last of 16 is the top.
  for (int i = 0; i <= isa::constant::block_stack; ++i) {
    program.push_back({contact(Opcode::Ld, (pattern >> i & 1) != 0 ? kOne : kZero)});
  }
  for (int i = 0; i < isa::constant::branch_stack; ++i) {
    program.push_back({contact(Opcode::Ld, (pattern >> i & 1) != 0 ? kOne : kZero)});
    program.push_back({plain(Opcode::Mps)});
  }
  const std::size_t pops = program.size();
  for (int i = 0; i < isa::constant::branch_stack; ++i) program.push_back({plain(Opcode::Mpp)});
  ASSERT_TRUE(bench.scan(program));
  for (int i = 0; i < isa::constant::branch_stack; ++i) {
    EXPECT_EQ(bench.retired()[pops + static_cast<std::size_t>(i)].exc,
              (pattern >> (isa::constant::branch_stack - 1 - i) & 1) != 0)
        << i;
  }

  program.resize(isa::constant::block_stack + 1);
  const std::size_t blocks = program.size();
  for (int i = 0; i < isa::constant::block_stack; ++i) {
    program.push_back({contact(Opcode::And, kZero)});  // so that ORB gives the popped bit alone
    program.push_back({plain(Opcode::Orb)});
  }
  ASSERT_TRUE(bench.scan(program));
  for (int i = 0; i < isa::constant::block_stack; ++i) {
    EXPECT_EQ(bench.retired()[blocks + 2 * static_cast<std::size_t>(i) + 1].exc,
              (pattern >> (isa::constant::block_stack - 1 - i) & 1) != 0)
        << i;
  }
}

TEST_P(Opcodes, ClocksOfEach) {
  Bench bench(GetParam());
  const isa::Config& config = bench.config();
  for (const isa::OpcodeInfo& info : isa::opcodes()) {
    if (!has(info.opcode)) continue;
    for (int slot = 0; slot < bench.slots(); ++slot) {
      for (const bool always : {false, true}) {
        isa::SlotInstruction instruction = plain(info.opcode);
        if (info.format == isa::Format::Word)
          instruction = word(info.opcode, kS1, kS2, kRd, always);
        ASSERT_TRUE(bench.scan({bench.step(instruction, slot), bench.step(nop(), slot)}));
        int clocks = 1;
        if (info.opcode == Opcode::Mul) clocks = config.mul_latency + 1;
        if (info.opcode == Opcode::Div) clocks = config.div_latency + 1;
        if (info.opcode == Opcode::Muld) clocks = config.mul32_latency + 1;
        if (info.opcode == Opcode::Divd) clocks = config.div32_latency + 1;
        const ScanResult result = bench.rtl().run_scan({});
        EXPECT_EQ(result.clocks,
                  static_cast<std::uint32_t>(isa::constant::fill_clocks + clocks + 1))
            << info.name;
        EXPECT_EQ(result.counted, result.clocks) << info.name;
      }
    }
  }
  ASSERT_TRUE(bench.scan({}));
  EXPECT_EQ(bench.rtl().run_scan({}).clocks,
            static_cast<std::uint32_t>(isa::constant::fill_clocks));
}

INSTANTIATE_TEST_SUITE_P(Rtl, Opcodes, testing::ValuesIn(targets(kAllMpus)), target_name);
INSTANTIATE_TEST_SUITE_P(Rtl, ContactOpcodes, testing::ValuesIn(targets({isa::Mpu::Mpu1})),
                         target_name);

}  // namespace
}  // namespace rung::tb
