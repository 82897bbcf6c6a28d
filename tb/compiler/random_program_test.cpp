// SPDX-License-Identifier: Apache-2.0
// The random programs: valid, the same everywhere, and of every kind.
#include "programs/random_program.hpp"

#include <gtest/gtest.h>

#include <map>

#include "melsec/paper.hpp"
#include "support.hpp"

namespace rung {
namespace {

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return hash;
}

TEST(RandomProgram, IsTheSameEverywhere) {
  RandomProgramOptions options;
  EXPECT_EQ(random_program(7, options), random_program(7, options));
  EXPECT_NE(random_program(7, options), random_program(8, options));
  EXPECT_EQ(fnv1a(random_program(7, options)), 13084831490316153833U);
}

TEST(RandomProgram, IsValidAndHasEveryBasicInstruction) {
  for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q}) {
    RandomProgramOptions options;
    options.dialect = dialect;
    std::map<Op, int> seen;
    int networks = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const std::string text = random_program(seed, options);
      const ParseResult result = parse(text, dialect);
      ASSERT_TRUE(result.program) << "seed " << seed << "\n" << result.messages << text;
      networks += static_cast<int>(result.program->networks.size());
      for (const Instruction& instruction : result.program->instructions) ++seen[instruction.op];
    }
    EXPECT_EQ(networks, 100 * options.networks);
    for (const Op op : {Op::Nop, Op::Ld,  Op::Ldi, Op::And, Op::Ani, Op::Or,  Op::Ori,
                        Op::Anb, Op::Orb, Op::Mps, Op::Mrd, Op::Mpp, Op::Out, Op::Set,
                        Op::Rst, Op::Mov, Op::Add, Op::Sub, Op::Mul, Op::Div}) {
      EXPECT_GT(seen[op], 20) << static_cast<int>(op);
    }
  }
}

TEST(RandomProgram, OptionsAtTheirEnds) {
  for (const int percent : {0, 100}) {
    RandomProgramOptions options;
    options.networks = 5;
    options.inputs = options.outputs = options.relays = 1;
    options.words = 2;
    options.run_lengths = {0, 0, 1};
    for (int RandomProgramOptions::*chance :
         {&RandomProgramOptions::block_percent, &RandomProgramOptions::branch_percent,
          &RandomProgramOptions::more_outputs_percent, &RandomProgramOptions::continue_percent,
          &RandomProgramOptions::word_percent, &RandomProgramOptions::multiply_percent,
          &RandomProgramOptions::set_reset_percent, &RandomProgramOptions::nop_percent}) {
      RandomProgramOptions one = options;
      one.*chance = percent;
      for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const ParseResult result = parse(random_program(seed, one), one.dialect);
        ASSERT_TRUE(result.program) << result.messages;
      }
    }
  }
}

TEST(RandomProgram, RunLengthsFollowTheirWeights) {
  RandomProgramOptions options = paper_options();
  options.networks = 2000;
  options.continue_percent = 0;
  options.nop_percent = 0;
  options.run_lengths = {1, 0, 3};
  std::map<int, int> lengths;
  for (const int length :
       count(good_program(random_program(1, options), Dialect::Paper)).run_lengths) {
    ++lengths[length];
  }
  EXPECT_EQ(lengths.size(), 2U);
  EXPECT_NEAR(lengths[1], 500, 80);
  EXPECT_NEAR(lengths[3], 1500, 80);
}

TEST(RandomProgram, PaperOptionsKeepToTable4) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Program program = good_program(random_program(seed, paper_options()), Dialect::Paper);
    Diagnostics diagnostics;
    EXPECT_TRUE(check_paper(program, diagnostics)) << printed(diagnostics);
    EXPECT_EQ(program.networks.size(), 20U);
  }
}

}  // namespace
}  // namespace rung
