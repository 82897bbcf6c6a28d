// SPDX-License-Identifier: Apache-2.0
// Programs as C and as lists.
#include <gtest/gtest.h>

#include "backends/c_writer.hpp"
#include "backends/list_writer.hpp"
#include "c_program.hpp"
#include "programs/random_program.hpp"
#include "support.hpp"

namespace rung {
namespace {

TEST(CWriter, ANetworkIsABlockWithItsSource) {
  const std::string text = to_c(good_program(
      "LD X0 / OR M1\nMPS\nLDI X2\nORI X3\nANB\nOUT Y10\nMPP\nSET M0\nMUL D0 K-3 D2\nEND"));
  const std::string network =
      "  /* Network 1, by the lines of its source\n"
      "   *     1: LD X0\n"
      "   *     1: OR M1\n"
      "   *     2: MPS\n"
      "   *     3: LDI X2\n"
      "   *     4: ORI X3\n"
      "   *     5: ANB\n"
      "   *     6: OUT Y10\n"
      "   *     7: MPP\n"
      "   *     8: SET M0\n"
      "   *     9: MUL D0 K-3 D2 */\n"
      "  {\n"
      "    unsigned r0;\n"
      "    unsigned r1;\n"
      "    unsigned s0;\n"
      "    r0 = plc.x[0];\n"
      "    r0 |= plc.m[1];\n"
      "    s0 = r0;\n"
      "    r1 = plc.x[2] ^ 1u;\n"
      "    r1 |= plc.x[3] ^ 1u;\n"
      "    r0 &= r1;\n"
      "    plc.y[8] = (uint8_t)r0;\n"
      "    r0 = s0;\n"
      "    if (r0) plc.m[0] = 1;\n"
      "    if (r0) {\n"
      "      const int32_t a = (int32_t)plc.d[0], b = (int32_t)-3;\n"
      "      const uint32_t product = (uint32_t)(a * b);\n"
      "      plc.d[2] = plc_word(product);\n"
      "      plc.d[3] = plc_word(product >> 16);\n"
      "    }\n"
      "  }\n"
      "}\n";
  EXPECT_EQ(text.substr(text.find("  /* Network 1")), network);
}

TEST(CWriter, FileNamesCannotLeaveTheComment) {
  Program program = good_program("LD X0\nOUT Y0\nEND");
  program.file =
      "a*/b/*c\\\nd?"
      "?/\n";
  RandomSource random(1);
  expect_c_equals_reference(program, 4, random);
  EXPECT_NE(to_c(program).find("/* a* /b/ *c__d__/_, dialect fx"), std::string::npos)
      << to_c(program).substr(0, 80);
}

TEST(CWriter, AProgramOfNothing) {
  RandomSource random(1);
  expect_c_equals_reference(good_program("END"), 2, random);
}

TEST(CWriter, AccessorsKeepTheirBounds) {
  const CProgram c(good_program("LD X1\nOUT Y1\nMOV K7 D1\nEND"));
  ASSERT_TRUE(c.good());
  c.write({DeviceKind::X, 1}, 5);
  EXPECT_EQ(c.read({DeviceKind::X, 1}), 1);
  c.write({DeviceKind::X, 2}, 1);
  EXPECT_EQ(c.read({DeviceKind::X, 2}), 0);
  c.write({DeviceKind::D, 4000000000U}, 1);
  EXPECT_EQ(c.read({DeviceKind::D, 4000000000U}), 0);
  c.cycle();
  EXPECT_EQ(c.read({DeviceKind::D, 1}), 7);
  c.reset();
  EXPECT_EQ(c.read({DeviceKind::D, 1}), 0);
  EXPECT_EQ(c.read({DeviceKind::X, 1}), 0);
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

class RandomC : public testing::TestWithParam<Dialect> {};

TEST_P(RandomC, EqualsTheReference) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    RandomProgramOptions options;
    options.dialect = GetParam();
    options.networks = 60;
    options.word_percent = 40;
    const ParseResult result = parse(random_program(seed, options), options.dialect);
    ASSERT_TRUE(result.program) << "seed " << seed << "\n" << result.messages;
    RandomSource random(seed);
    expect_c_equals_reference(*result.program, 200, random);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Dialects, RandomC,
                         testing::Values(Dialect::Paper, Dialect::Fx, Dialect::Q),
                         [](const auto& info) { return std::string(dialect_name(info.param)); });

TEST(ListWriter, WritesEveryInstruction) {
  EXPECT_EQ(to_list(good_program("0 ld x007 nop\nLDI Y010 / ANB\nMPS\nAND M1 ANI M2 OR M3 ORI M4\n"
                                 "MRD\nSET Y1\nMPP\nRST D4\nOUT M0\nLD X0\nMOV HFFFF D1\n"
                                 "ADD D0 K2 D3\nSUB H10 D1 D0\nMUL D1 D2 D4\nDIV D1 D2 D4\nEND")),
            "; dialect fx: read it with --dialect fx\n"
            "LD X7\nNOP\nLDI Y10\nANB\nMPS\nAND M1\nANI M2\nOR M3\nORI M4\nMRD\nSET Y1\nMPP\n"
            "RST D4\nOUT M0\n\nLD X0\nMOV K-1 D1\nADD D0 K2 D3\nSUB K16 D1 D0\nMUL D1 D2 D4\n"
            "DIV D1 D2 D4\nEND\n");
  EXPECT_EQ(to_list(good_program("LD XA\n+ K1 D0\n- K1 D0 D1\n* D0 D1\n/ D0 D1 D2\nEND")),
            "; dialect q: read it with --dialect q\n"
            "LD XA\n+ K1 D0\n- K1 D0 D1\n* D0 D1\n/ D0 D1 D2\nEND\n");
  EXPECT_EQ(to_list(good_program("LD X10\nMOV K1 D0\nADD D1 D0\nMUL K2 D0 D0\nEND")),
            "; dialect paper: read it with --dialect paper\n"
            "LD X10\nMV K1 D0\nADD D1 D0\nMUL K2 D0 D0\nEND\n");
}

TEST(ListWriter, ReadsBackToTheSameProgram) {
  for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q}) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      RandomProgramOptions options;
      options.dialect = dialect;
      const ParseResult first = parse(random_program(seed, options), dialect);
      ASSERT_TRUE(first.program) << first.messages;
      const ParseResult second = parse(to_list(*first.program), dialect);
      ASSERT_TRUE(second.program) << second.messages;
      ASSERT_EQ(dump(*first.program), dump(*second.program)) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace rung
