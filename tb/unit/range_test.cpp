// SPDX-License-Identifier: Apache-2.0
// A run of part of the program: what its steps do, its clocks, none of what lies around it; beside
// it the whole program runs as ever. (The harness checks the write port in every run.)
#include <random>

#include "unit/bench.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Opcode;

class Range : public testing::TestWithParam<Target> {};

// Step i adds 1 to word 1 + i % 8 in one slot, and divides now and then, which waits.
std::vector<Step> counting(const Bench& bench, int steps) {
  std::vector<Step> program;
  for (int i = 0; i < steps; ++i) {
    const int device = 1 + i % 8;
    Step step = bench.step(with_constant(Opcode::Add, device, 1, device), i % bench.slots());
    if (bench.slots() > 1 && i % 3 == 0) {
      step[static_cast<std::size_t>((i + 1) % 2)] = move_constant(static_cast<std::uint16_t>(i), 9);
    }
    if (i % 11 == 5) step = bench.step(with_constant(Opcode::Div, device, 3, device));
    program.push_back(step);
  }
  return program;
}

TEST_P(Range, RunsItsStepsAlone) {
  Bench bench(GetParam());
  constexpr int kSteps = 60;
  const std::vector<Step> program = counting(bench, kSteps);
  ASSERT_TRUE(bench.scan(program));
  std::mt19937 random(5);
  for (int run = 0; run < 60; ++run) {
    const std::size_t entry = random() % (kSteps + 1);
    const std::size_t end = entry + random() % (kSteps + 1 - entry);
    ASSERT_TRUE(bench.scan_range(entry, end)) << entry << " to " << end;
    if (run % 5 == 0) {
      ASSERT_TRUE(bench.scan_again());
    }
    // Writes of the host are not the program's.
    bench.set_word(3, static_cast<std::uint16_t>(random()));
  }
  EXPECT_TRUE(bench.devices_equal());
}

TEST_P(Range, OfNoStepsEndsAsAnEmptyProgramDoes) {
  Bench bench(GetParam());
  ASSERT_TRUE(bench.scan({}));
  const std::uint32_t fill = bench.rtl().run_scan({}).clocks;
  ASSERT_TRUE(bench.scan(counting(bench, 8)));
  const std::uint16_t last = static_cast<std::uint16_t>(bench.config().steps(bench.mpu()));
  for (const std::uint16_t at : {std::uint16_t{0}, std::uint16_t{3}, std::uint16_t{8}, last}) {
    EXPECT_EQ(bench.rtl().run_range(at, at, {}).clocks, fill);
  }
  EXPECT_TRUE(bench.devices_equal());
}

// Steps behind the loaded length, as those of flow tasks are.
TEST_P(Range, ReachesTheEndOfTheMemory) {
  Bench bench(GetParam());
  const int steps = bench.config().steps(bench.mpu());
  std::vector<Step> program(static_cast<std::size_t>(steps), bench.step(nop()));
  program.back() = bench.step(move_constant(0x1234, 7));
  ASSERT_TRUE(bench.scan(program));
  bench.set_word(7, 0);
  ASSERT_TRUE(bench.scan_range(program.size() - 2, program.size()));
  EXPECT_EQ(bench.rtl().read_word(7), 0x1234);
}

INSTANTIATE_TEST_SUITE_P(Unit, Range, testing::ValuesIn(targets(kAllMpus)), target_name);

}  // namespace
}  // namespace rung::tb
