// SPDX-License-Identifier: Apache-2.0
// The C back end: what its files look like and how they are used.
#include "backends/c_writer.hpp"

#include <gtest/gtest.h>

#include "c_program.hpp"
#include "programs/random_program.hpp"
#include "support.hpp"

namespace rung {
namespace {

TEST(CWriter, ANetworkBeginsWithItsSource) {
  Program program = good_program(
      "LD X0 / OR M1\nMPS\nLDI X2\nORI X3\nANB\nOUT Y10\nMPP\nSET M0\nMUL D0 K-3 D2\nEND");
  program.comments[{DeviceKind::X, 2}] = "door */ shut?";
  const std::string text = to_c(program);
  const std::string network =
      "  /* Network 1, by the lines of its source\n"
      "   *     1: LD X0\n"
      "   *     1: OR M1\n"
      "   *     2: MPS\n"
      "   *     3: LDI X2  [door * / shut_]\n"
      "   *     4: ORI X3\n"
      "   *     5: ANB\n"
      "   *     6: OUT Y10\n"
      "   *     7: MPP\n"
      "   *     8: SET M0\n"
      "   *     9: MUL D0 K-3 D2 */\n"
      "  r0 = plc.X[0];\n"
      "  r0 |= plc.M[1];\n"
      "  s0 = r0;\n"
      "  r1 = plc.X[2] ^ 1u;\n"
      "  r1 |= plc.X[3] ^ 1u;\n"
      "  r0 &= r1;\n"
      "  plc.Y[010] = (uint8_t)(r0);\n"
      "  r0 = s0;\n"
      "  if (r0) plc.M[0] = 1;\n"
      "  if (r0) {\n"
      "    const int32_t a = plc.D[0];\n"
      "    const int32_t b = -3;\n"
      "    const uint32_t v = (uint32_t)(a * b);\n"
      "    plc.D[2] = plc_word(v);\n"
      "    plc.D[3] = plc_word(v >> 16);\n"
      "  }\n"
      "}\n";
  const std::size_t at = text.find("  /* Network 1");
  EXPECT_EQ(text.substr(at, network.size()), network);
}

TEST(CWriter, FileNamesCannotLeaveTheComment) {
  Program program = good_program("LD X0\nOUT Y0\nEND");
  program.file =
      "a*/b/*c\\\nd?"
      "?/@$\n";
  RandomSource random(1);
  expect_c_equals_reference(program, 4, random);
  EXPECT_NE(to_c(program).find("/* a* /b/ *c__d__/@$_, dialect fx"), std::string::npos)
      << to_c(program).substr(0, 80);
}

TEST(CWriter, PrefixesAndTheTableOfNames) {
  const Program program = good_program("LD X0\nOUT Y0\nEND");
  const std::string plain = to_c(program);
  EXPECT_NE(plain.find("void PlcCycle(void)"), std::string::npos);
  EXPECT_EQ(plain.find("PlcGet"), std::string::npos);
  const std::string named = write_c(program, {.prefix = "Door_", .table = true});
  EXPECT_NE(named.find("long Door_Get(const char *device)"), std::string::npos);
  EXPECT_EQ(named.find("Plc"), std::string::npos);
  EXPECT_EQ(named.find("plc"), std::string::npos);
}

TEST(CWriter, AProgramOfNothing) {
  RandomSource random(1);
  expect_c_equals_reference(good_program("END"), 2, random);
}

TEST(CWriter, AccessorsKeepTheirBounds) {
  const std::vector<Program> programs = {good_program("LD X1\nOUT Y1\nMOV K7 D1\nOUT M8022\nEND")};
  const CPrograms c(programs);
  ASSERT_TRUE(c.good());
  c.write(0, {DeviceKind::X, 1}, 5);
  EXPECT_EQ(c.read(0, {DeviceKind::X, 1}), 1);
  c.write(0, {DeviceKind::X, 2}, 1);
  EXPECT_EQ(c.read(0, {DeviceKind::X, 2}), 0);
  c.write(0, {DeviceKind::D, 4000000000U}, 1);
  EXPECT_EQ(c.read(0, {DeviceKind::D, 4000000000U}), 0);
  EXPECT_FALSE(c.set(0, "X2", 1));
  EXPECT_EQ(c.get(0, "X"), 0);
  EXPECT_EQ(c.get(0, "D11"), 0);
  EXPECT_TRUE(c.set(0, "D1", 65535));
  EXPECT_EQ(c.get(0, "D1"), -1);
  c.cycle(0);
  EXPECT_EQ(c.read(0, {DeviceKind::D, 1}), 7);
  EXPECT_EQ(c.read(0, {DeviceKind::M, 8022}), 1);
  c.write(0, {DeviceKind::M, 8022}, 0);
  EXPECT_EQ(c.get(0, "M8022"), 0);
  c.reset(0);
  EXPECT_EQ(c.read(0, {DeviceKind::D, 1}), 0);
  EXPECT_EQ(c.read(0, {DeviceKind::X, 1}), 0);
}

// A reset keeps the time between scans, and the first scan after it has no ticks.
TEST(CWriter, TimeSurvivesAReset) {
  const std::vector<Program> programs = {good_program("LD X0\nOUT T0 K9\nEND")};
  const CPrograms c(programs);
  ASSERT_TRUE(c.good());
  c.elapsed(0, 250000);
  for (int run = 0; run < 2; ++run) {
    c.reset(0);
    c.set(0, "X0", 1);
    c.cycle(0);
    EXPECT_EQ(c.get(0, "TN0"), 0);
    c.cycle(0);
    EXPECT_EQ(c.get(0, "TN0"), 2);
    c.cycle(0);
    EXPECT_EQ(c.get(0, "TN0"), 5);
  }
  c.elapsed(0, 4000000000U);
  c.cycle(0);
  EXPECT_EQ(c.get(0, "TS0"), 1);
}

TEST(CWriter, CornersOfArithmetic) {
  for (const Dialect dialect : {Dialect::Paper, Dialect::Fx}) {
    std::string text = "LD X0\n";
    int target = 10;
    for (const char* const name : {"ADD", "SUB", "MUL", "DIV"}) {
      for (const char* const first : {"K0", "K1", "K-1", "K32767", "K-32768", "D0"}) {
        for (const char* const second : {"K0", "K1", "K-1", "K32767", "K-32768", "D1"}) {
          text += fmt::format("{} {} {} D{}\n", name, first, second, target);
          target += 2;
        }
      }
    }
    const ParseResult result = parse(text + "END", dialect);
    ASSERT_TRUE(result.program) << result.messages;
    RandomSource random(2);
    expect_c_equals_reference(*result.program, 300, random);
  }
}

TEST(CWriter, CornersOf32BitArithmetic) {
  std::string text = "LD X0\n";
  int target = 100;
  for (const char* const name : {"DADD", "DSUB", "DMUL", "DDIV"}) {
    for (const char* const first : {"K0", "K-1", "K2147483647", "K-2147483648", "D0"}) {
      for (const char* const second : {"K0", "K-1", "K2147483647", "K-2147483648", "D2"}) {
        text += fmt::format("{} {} {} D{}\n", name, first, second, target);
        target += 4;
      }
    }
  }
  const Program program =
      good_program(text + "LD M8020\nOR M8021\nOR M8022\nOR M8067\nOUT Y0\nEND", Dialect::Fx);
  ASSERT_FALSE(program.instructions.empty());
  RandomSource random(2);
  expect_c_equals_reference(program, 300, random);
}

class RandomC : public testing::TestWithParam<Dialect> {};

TEST_P(RandomC, EqualsTheReference) {
  std::vector<Program> programs;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    RandomProgramOptions options;
    options.dialect = GetParam();
    options.networks = 60;
    options.word_percent = 40;
    const ParseResult result = parse(random_program(seed, options), options.dialect);
    ASSERT_TRUE(result.program) << "seed " << seed << "\n" << result.messages;
    programs.push_back(*result.program);
  }
  RandomSource random(1);
  expect_c_equals_reference(CPrograms(programs), programs, 200, random);
}

INSTANTIATE_TEST_SUITE_P(Dialects, RandomC,
                         testing::Values(Dialect::Paper, Dialect::Fx, Dialect::Q),
                         [](const auto& info) { return std::string(dialect_name(info.param)); });

}  // namespace
}  // namespace rung
