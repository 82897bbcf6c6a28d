// SPDX-License-Identifier: Apache-2.0
#include "image/image.hpp"

#include <algorithm>

#include "image/image_file.hpp"
#include "passes/support.hpp"

namespace rung::image {
namespace {

Image example() {
  return compile_for(parse("LD X0\nOR M0\nANI X1\nOUT M0\nLD M0\nMUL D0 K3 D2\nOUT Y0\nEND\n"),
                     isa::Mpu::Mpu3)
      .image;
}

TEST(Isa, EveryInstructionReadsBackFromItsBits) {
  for (const isa::Config& config : isa::configs()) {
    for (const isa::Mpu mpu : {isa::Mpu::Mpu1, isa::Mpu::Mpu2}) {
      for (const isa::OpcodeInfo& info : isa::opcodes()) {
        const bool has = mpu == isa::Mpu::Mpu1 ? info.on_mpu1 : info.on_slot;
        isa::SlotInstruction instruction;
        instruction.opcode = info.opcode;
        if (info.format == isa::Format::Bit) {
          instruction.a = {static_cast<std::uint16_t>(config.bit_devices - 1),
                           mpu != isa::Mpu::Mpu1};
          if (mpu != isa::Mpu::Mpu1) {
            instruction.b = {1, false};
            instruction.c = {static_cast<std::uint16_t>(config.bit_devices / 2), true};
          }
          // A flag stands where a look-up has its row.
          instruction.always = info.gate == isa::Gate::Exc || info.opcode == isa::Opcode::Get;
          if (mpu != isa::Mpu::Mpu1 && !instruction.always) instruction.row = 127;
        } else if (info.format == isa::Format::Test) {
          auto& target = mpu == isa::Mpu::Mpu1 ? instruction.a : instruction.c;
          target.device = static_cast<std::uint16_t>(config.bit_devices - 1);
          instruction.source = 0x8001;
          instruction.kind = isa::WordKind::DeviceConstant;
        } else if (info.format == isa::Format::Word) {
          instruction.rd = static_cast<std::uint16_t>(config.word_devices - 1);
          instruction.rs = 1;
          instruction.source = 0x8001;
          instruction.kind = isa::WordKind::ConstantDevice;
          instruction.always = true;
        }
        const auto bits = isa::encode(instruction, mpu, config);
        EXPECT_LT(bits, std::uint64_t{1} << isa::slot_bits(mpu, config));
        const auto back = isa::decode(bits, mpu, config);
        EXPECT_EQ(back.has_value(), has) << info.name;
        if (has) {
          EXPECT_EQ(*back, instruction) << info.name;
        }
      }
    }
  }
}

TEST(Image, ReadsBackTheSame) {
  const Image image = example();
  Diagnostics diagnostics;
  const auto back = from_bytes(to_bytes(image), "x.img", diagnostics);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->steps, image.steps);
  EXPECT_EQ(back->origins, image.origins);
  EXPECT_EQ(back->lut, image.lut);
  EXPECT_EQ(back->clocks, image.clocks);
  EXPECT_EQ(listing(*back), listing(image));
}

// Whatever byte is damaged, and wherever the file is cut, nothing of it runs.
TEST(Image, DamageIsFound) {
  const std::string good = to_bytes(example());
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const char flip : {'\x01', '\x80'}) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ flip);
      Diagnostics diagnostics;
      ASSERT_FALSE(from_bytes(bad, "x.img", diagnostics)) << "byte " << i;
      ASSERT_EQ(diagnostics.error_count(), 1);
    }
    Diagnostics diagnostics;
    ASSERT_FALSE(from_bytes(good.substr(0, i), "x.img", diagnostics)) << "cut at " << i;
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(from_bytes(good + "x", "x.img", diagnostics));
}

TEST(Image, AnotherFormatVersionIsNamed) {
  std::string bytes = to_bytes(example());
  bytes[7] = 9;
  Diagnostics diagnostics;
  EXPECT_FALSE(from_bytes(bytes, "x.img", diagnostics));
  EXPECT_NE(diagnostics.all()[0].what.find("format version 9"), std::string::npos);
}

TEST(Image, MoreThanTheConfigurationHasIsRefused) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "LD X0\nOUT M" + std::to_string(i) + "\n";
  const Program program = parse(text + "END\n");
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu1;
  options.config = isa::find_config("hx8k");
  Diagnostics diagnostics;
  EXPECT_FALSE(compile(program, options, diagnostics));
  EXPECT_EQ(diagnostics.all()[0].what, "the program needs 600 steps; configuration hx8k has 512");
}

TEST(Image, PaperOpcodesFillTheirRows) {
  const Image image = compile_for(parse("LDI X0\nORI X1\nANI X2\nOUT Y0\nEND\n", Dialect::Paper),
                                  isa::Mpu::Mpu2, true)
                          .image;
  const std::uint8_t row = isa::paper_row(1, 4, 2);
  EXPECT_EQ(image.steps[0][0].row, row);
  EXPECT_EQ(image.lut[row], isa::paper_row_function(row));
  // (not X0 or not X1) and not X2
  EXPECT_EQ(isa::paper_row_function(row), 0b00010101);
  EXPECT_EQ(image.statistics.lut_rows, 1);
}

// A program with every function of its own coil, so that look-ups that write need more than 128
// rows.
TEST(Image, RowsNeverRunOut) {
  std::string text;
  int relay = 0;
  for (int function = 0; function < 256; ++function) {
    // The function as a sum of products over X0, X1 and the coil itself.
    const std::string coil = "M" + std::to_string(relay++);
    bool first = true;
    for (int address = 0; address < 8; ++address) {
      if ((function >> address & 1) == 0) continue;
      text += std::string(address & 4 ? "LD" : "LDI") + " X0\n";
      text += std::string(address & 2 ? "AND" : "ANI") + " X1\n";
      text += std::string(address & 1 ? "AND " : "ANI ") + coil + "\n";
      if (!first) text += "ORB\n";
      first = false;
    }
    if (first) text += "LD X0\nANI X0\n";
    text += "OUT " + coil + "\n";
  }
  const Compiled compiled = compile_for(parse(text + "END\n"), isa::Mpu::Mpu3);
  EXPECT_LE(compiled.image.statistics.lut_rows, 128);
  EXPECT_GE(compiled.image.statistics.lut_rows, 80);
}

}  // namespace
}  // namespace rung::image
