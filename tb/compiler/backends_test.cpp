// SPDX-License-Identifier: Apache-2.0
// Programs as lists.
#include <gtest/gtest.h>

#include "backends/list_writer.hpp"
#include "programs/random_program.hpp"
#include "support.hpp"

namespace rung {
namespace {

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
