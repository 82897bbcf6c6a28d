// SPDX-License-Identifier: Apache-2.0
// What lowering makes of single instructions; that it means the same is for tb/agree.
#include "lower/lower.hpp"

#include <algorithm>
#include <set>

#include "passes/support.hpp"

namespace rung::lower {
namespace {

std::string core_of(const std::string& text, Dialect dialect = Dialect::Fx) {
  std::string out;
  for (const core::Instruction& instruction : lowered(text + "END\n", dialect).instructions) {
    out += core::to_string(instruction, dialect) + "\n";
  }
  return out;
}

std::set<Device> hidden_bits(const core::Program& program) {
  std::set<Device> bits;
  for (const Device device : core::devices(program)) {
    if (device.kind == DeviceKind::HB) bits.insert(device);
  }
  return bits;
}

TEST(Lower, BasicInstructionsStayAsTheyAre) {
  const std::string text =
      "LD X0\nORI M0\nLDI X1\nANB\nMPS\nAND X2\nOUT Y0\nMRD\nSET M1\nMPP\nRST M2\nNOP\nLD M1\n";
  EXPECT_EQ(core_of(text + "OUT M0\n"), text + "OUT M0\n");
  EXPECT_EQ(core_of("LD X0\nMOV K5 D0\nADD D0 D1 D2\n"), "LD X0\nMOV K5 -> D0\nADD D0 D1 -> D2\n");
}

TEST(Lower, EachRungIsANetwork) {
  const core::Program program = lowered("LD X0\nOUT Y0\nLDP X1\nOUT T0 K5\nOUT Y1\nEND\n");
  ASSERT_EQ(program.networks.size(), 2U);
  EXPECT_EQ(program.networks[0].count, 2U);
  EXPECT_EQ(program.networks[0].count + program.networks[1].count, program.instructions.size());
}

TEST(Lower, AnEdgeTakesOneMemory) {
  EXPECT_EQ(core_of("LD X0\nANDP X1\nOUT Y0\n"),
            "LD X0\nAND X1\nANI %B0\nLD X1\nOUT %B0\nPOP\nOUT Y0\n");
}

TEST(Lower, CopiesOfALoopShareTheirMemory) {
  const core::Program program = lowered("FOR K3\nLD X0\nINCP D0\nNEXT\nEND\n");
  EXPECT_EQ(hidden_bits(program).size(), 1U);
  EXPECT_EQ(std::count_if(program.instructions.begin(), program.instructions.end(),
                          [](const auto& i) { return i.op == core::Op::Add; }),
            3);
}

TEST(Lower, ASubroutineStandsWhereItIsCalled) {
  const core::Program program =
      lowered("LD X0\nCALL P0\nLD X1\nCALL P0\nFEND\nP0\nLD X2\nPLS M0\nSRET\nEND\n");
  const auto writes_m0 = [](const core::Instruction& i) {
    return i.op == core::Op::Out && i.targets[0] == Device{DeviceKind::M, 0};
  };
  EXPECT_EQ(std::count_if(program.instructions.begin(), program.instructions.end(), writes_m0), 2);
  // One bit for each call, one for the edge.
  EXPECT_EQ(hidden_bits(program).size(), 3U);
}

TEST(Lower, FlagsThatNobodyNamesAreNotComputed) {
  EXPECT_EQ(core_of("LD X0\nADD D0 D1 D2\n"), "LD X0\nADD D0 D1 -> D2\n");
  EXPECT_NE(core_of("LD X0\nADD D0 D1 D2\nLD M8020\nOUT Y0\n").find("SET M8020"),
            std::string::npos);
}

// LD M8000 stays for MPU1 and for what follows; a slot needs no look-up for it.
TEST(Lower, WhatIsAlwaysOnIsNoCondition) {
  EXPECT_EQ(core_of("LD M8000\nMOV D0 D1\nAND X0\nMOV D2 D3\n"),
            "LD M8000\nMOV D0 -> D1 (always)\nAND X0\nMOV D2 -> D3\n");
  const Program program = parse("LD M8000\nMOV D0 D1\nADD D1 K1 D2\nSET M0\nEND\n");
  EXPECT_EQ(compile_for(program, isa::Mpu::Mpu2).image.steps.size(), 3U);
}

TEST(Lower, AWindowIsReadAndWrittenAsAWhole) {
  const core::Program program = lowered("LD X0\nMOV D10Z0 D5\nMOV K1 D12Z0\nEND\n");
  ASSERT_EQ(program.windows.size(), 1U);
  EXPECT_EQ(program.windows[0].front(), (Device{DeviceKind::D, 5}));
  EXPECT_EQ(program.windows[0].back(), (Device{DeviceKind::D, 12 + 127}));
  for (const core::Instruction& instruction : program.instructions) {
    if (instruction.op == core::Op::LoadWord) {
      EXPECT_EQ(instruction.reads, program.windows[0]);
    }
    if (instruction.op == core::Op::StoreWord) {
      EXPECT_EQ(instruction.targets, program.windows[0]);
    }
  }
}

TEST(Lower, TimersOfOneBaseShareTheirTicks) {
  const core::Program program =
      lowered("LD X0\nOUT T0 K5\nOUT T1 K5\nOUT T200 K5\nOUT T246 K5\nEND\n");
  ASSERT_EQ(program.ticks.size(), 3U);
  EXPECT_EQ(program.ticks[0].base_us, 100'000);
  EXPECT_EQ(program.ticks[1].base_us, 10'000);
  EXPECT_EQ(program.ticks[2].base_us, 1'000);
}

// MPU1's stacks are 16 deep, as q allows; an edge in the sixteenth block needs one more.
TEST(Lower, ARungTooDeepForMpu1IsRefusedThereOnly) {
  std::string text;
  for (int i = 0; i < 15; ++i) text += "LD X" + std::to_string(i % 8) + "\n";
  text += "LDP X9\n";
  for (int i = 0; i < 15; ++i) text += "ANB\n";
  const Program program = parse(text + "OUT Y0\nEND\n", Dialect::Q);
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu1;
  Diagnostics diagnostics;
  EXPECT_FALSE(compile(program, options, diagnostics));
  std::ostringstream out;
  diagnostics.print(out);
  EXPECT_NE(out.str().find("test.il:16:1: error: LDP X9: this rung nests too deep for MPU1"),
            std::string::npos)
      << out.str();
  options.mpu = isa::Mpu::Mpu2;
  EXPECT_TRUE(compile(program, options, diagnostics));
}

}  // namespace
}  // namespace rung::lower
