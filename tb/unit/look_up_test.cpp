// SPDX-License-Identifier: Apache-2.0
// Look-ups: every three-input function at every address in every slot, the opcodes of the paper's
// Table 2, the four forms of the instruction, and chains over N0.
#include <fmt/format.h>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

class LookUps : public testing::TestWithParam<Target> {
 protected:
  // Bit devices 0 to 7 hold their own number's bits: operands a, b, c of `address` are devices
  // 2 * position + bit.
  static void set_operands(Bench& bench) {
    for (int position = 0; position < 3; ++position) bench.set_bit(2 * position + 1, true);
  }
  static isa::BitOperand operand(int position, int address) {
    return device(2 * position + (address >> (2 - position) & 1));
  }
};

TEST_P(LookUps, AllFunctionsAtAllAddresses) {
  Bench bench(GetParam());
  set_operands(bench);
  constexpr int kRows = isa::constant::lut_rows;
  for (int half = 0; half < 256; half += kRows) {
    for (int row = 0; row < kRows; ++row) bench.set_lut(row, static_cast<std::uint8_t>(half + row));
    for (int address = 0; address < 8; ++address) {
      std::vector<Step> program;
      for (int row = 0; row < kRows; ++row) {
        Step step;
        for (int slot = 0; slot < bench.slots(); ++slot) {
          step.push_back(look_up(Opcode::Lut, slot == 0 ? row : kRows - 1 - row,
                                 operand(0, address), operand(1, address), operand(2, address)));
        }
        program.push_back(step);
      }
      ASSERT_TRUE(bench.scan(program));
      for (const Retired& retired : bench.retired()) {
        const int row =
            static_cast<int>(retired.slot == 0 ? retired.step : kRows - 1 - retired.step);
        ASSERT_EQ(retired.exc, ((half + row) >> address & 1) != 0)
            << fmt::format("function {} address {} slot {}", half + row, address, retired.slot);
      }
    }
  }
}

// Table 2 of the paper: LD or LDI, then NOP, AND, ANI, OR or ORI, twice.
TEST_P(LookUps, PaperOpcodesGiveThePapersFunction) {
  Bench bench(GetParam());
  set_operands(bench);
  const auto apply = [](int code, bool exc, bool operand) {
    const bool results[] = {exc, exc && operand, exc && !operand, exc || operand, exc || !operand};
    return results[code];
  };
  for (int opcode = 0; opcode < 50; ++opcode) {
    const int row = isa::paper_row(opcode / 25, opcode / 5 % 5, opcode % 5);
    bench.set_lut(row, isa::paper_row_function(static_cast<std::uint8_t>(row)));
  }
  for (int address = 0; address < 8; ++address) {
    std::vector<Step> program;
    for (int opcode = 0; opcode < 50; ++opcode) {
      const int row = isa::paper_row(opcode / 25, opcode / 5 % 5, opcode % 5);
      program.push_back(Step(static_cast<std::size_t>(bench.slots()),
                             look_up(Opcode::Lut, row, operand(0, address), operand(1, address),
                                     operand(2, address))));
    }
    ASSERT_TRUE(bench.scan(program));
    for (const Retired& retired : bench.retired()) {
      const int opcode = static_cast<int>(retired.step);
      bool want = ((address & 4) != 0) != (opcode / 25 == 1);
      want = apply(opcode / 5 % 5, want, (address & 2) != 0);
      want = apply(opcode % 5, want, (address & 1) != 0);
      ASSERT_EQ(retired.exc, want) << "opcode " << opcode << " address " << address;
    }
  }
}

TEST_P(LookUps, FormsThatWrite) {
  Bench bench(GetParam());
  constexpr int kTarget = 20;
  constexpr int kAnother = 21;
  for (const Opcode opcode : {Opcode::Lut, Opcode::Luto, Opcode::Luts, Opcode::Lutr}) {
    for (int variant = 0; variant < 8 * bench.slots(); ++variant) {
      const bool result = variant % 2 != 0;
      const bool old = variant / 2 % 2 != 0;
      const bool c_is_n0 = variant / 4 % 2 != 0;
      const int slot = variant / 8;
      bench.set_bit(kTarget, old);
      bench.set_lut(5, result ? 0xff : 0x00);
      const isa::BitOperand c = c_is_n0 ? n0(kTarget) : device(kTarget);
      ASSERT_TRUE(bench.scan({bench.step(look_up(opcode, 5, device(0), device(1), c), slot),
                              bench.step(coil(bench.mpu(), Opcode::Out, kAnother), slot)}));
      bool want = old;
      if (opcode == Opcode::Luto) want = result;
      if (opcode == Opcode::Luts && result) want = true;
      if (opcode == Opcode::Lutr && result) want = false;
      EXPECT_EQ(bench.rtl().read_bit(kTarget), want)
          << isa::info(opcode).name << " variant " << variant;
      EXPECT_EQ(bench.rtl().read_bit(kAnother), result);
    }
  }
}

// A look-up right after, and some steps after, takes the previous look-up's result as each operand;
// what the other slot looks up meanwhile does not matter.
TEST_P(LookUps, ChainsOverN0) {
  Bench bench(GetParam());
  constexpr int kCopyA = 1, kCopyB = 2, kCopyC = 3, kOne = 4, kZero = 5;
  bench.set_lut(kCopyA, 0xf0);
  bench.set_lut(kCopyB, 0xcc);
  bench.set_lut(kCopyC, 0xaa);
  bench.set_lut(kOne, 0xff);
  bench.set_lut(kZero, 0x00);
  for (int slot = 0; slot < bench.slots(); ++slot) {
    for (int row = kCopyA; row <= kCopyC; ++row) {
      for (const bool value : {false, true}) {
        for (int distance = 1; distance <= 5; ++distance) {
          const auto both = [&](const isa::SlotInstruction& own,
                                const isa::SlotInstruction& other) {
            Step step(static_cast<std::size_t>(bench.slots()), other);
            step[static_cast<std::size_t>(slot)] = own;
            return step;
          };
          const auto constant = [&](bool bit) {
            return look_up(Opcode::Lut, bit ? kOne : kZero, device(0), device(0), device(0));
          };
          std::vector<Step> program{both(constant(value), constant(!value))};
          for (int i = 1; i < distance; ++i) program.push_back(both(nop(), constant(!value)));
          program.push_back(both(look_up(Opcode::Lut, row, n0(), n0(), n0()), constant(!value)));
          program.push_back(both(look_up(Opcode::Lut, row, n0(), n0(), n0()), nop()));
          ASSERT_TRUE(bench.scan(program));
          EXPECT_EQ(
              bench
                  .retired()[bench.retired().size() - static_cast<std::size_t>(bench.slots()) +
                             static_cast<std::size_t>(slot)]
                  .exc,
              value)
              << fmt::format("slot {} row {} distance {}", slot, row, distance);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, LookUps, testing::ValuesIn(targets(kLookUpMpus)), target_name);

}  // namespace
}  // namespace rung::tb
