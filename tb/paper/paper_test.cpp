// SPDX-License-Identifier: Apache-2.0
// What the paper prints, against what this compiler does.
#include <gtest/gtest.h>

#include <algorithm>

#include "paper/reproduce.hpp"
#include "programs/samples.hpp"

namespace rung::paper {
namespace {

using Steps = std::vector<std::vector<std::string>>;

TEST(Paper, Figure14) {
  const Steps expected = {{"LD X0"}, {"OR M0"}, {"ANI X1"}, {"OUT M0"}, {"LD M0"}, {"OUT Y0"},
                          {"LD X2"}, {"OR X3"}, {"AND X4"}, {"ANI X5"}, {"OUT Y1"}};
  EXPECT_EQ(figure_steps(isa::Mpu::Mpu1), expected);
}

TEST(Paper, Figure15) {
  const Steps expected = {{"LD OR ANI X0 M0 X1"},
                          {"OUT M0"},
                          {"LD NOP NOP M0 N0 N0"},
                          {"OUT Y0"},
                          {"LD OR AND X2 X3 X4"},
                          {"LD ANI NOP N0 X5 N0"},
                          {"OUT Y1"}};
  EXPECT_EQ(figure_steps(isa::Mpu::Mpu2), expected);
}

TEST(Paper, Figure16) {
  const Steps expected = {{"LD OR ANI X0 M0 X1", "LD OR AND X2 X3 X4"},
                          {"OUT M0", "LD ANI NOP N0 X5 N0"},
                          {"LD NOP NOP M0 N0 N0", "OUT Y1"},
                          {"OUT Y0", "NOP"}};
  EXPECT_EQ(figure_steps(isa::Mpu::Mpu3), expected);
}

TEST(Paper, Table1) {
  const std::map<int, int> expected = {{1, 1}, {3, 1}};
  EXPECT_EQ(table1(), expected);
}

TEST(Paper, Table6) {
  const std::map<int, int> expected = {{1, 1}, {2, 1}, {3, 1}, {4, 2},  {5, 2},  {6, 3},
                                       {7, 3}, {8, 4}, {9, 4}, {10, 5}, {11, 5}, {27, 13}};
  for (const auto& [contacts, lookups] : expected) {
    EXPECT_EQ(lookups_of_run(contacts), lookups) << contacts;
    EXPECT_EQ(mapping::run_lookups(contacts), lookups) << contacts;
  }
}

TEST(Paper, Table7) {
  // length: runs, contacts, look-ups
  const std::map<int, std::array<int, 3>> expected = {
      {1, {78, 78, 78}},  {2, {74, 148, 74}}, {3, {30, 90, 30}}, {4, {34, 136, 68}},
      {5, {22, 110, 44}}, {6, {9, 54, 27}},   {7, {7, 49, 21}},  {8, {5, 40, 20}},
      {9, {1, 9, 4}},     {10, {1, 10, 5}},   {11, {2, 22, 10}}, {27, {1, 27, 13}}};
  const auto rows = table7();
  ASSERT_EQ(rows.size(), expected.size());
  for (const auto& [length, row] : rows) {
    const std::array<int, 3> got = {row.runs, row.contacts, row.lookups};
    EXPECT_EQ(got, expected.at(length)) << length;
  }
}

TEST(Paper, SamplesHaveTheirCounts) {
  const int instructions[] = {1425, 834, 454};
  const int contacts[] = {773, 561, 275};
  for (int sample = 1; sample <= 3; ++sample) {
    const ProgramCounts counts = count(parse(sample_program(sample, 30, 7)));
    EXPECT_EQ(counts.instructions, instructions[sample - 1]);
    EXPECT_EQ(counts.contacts, contacts[sample - 1]);
  }
}

// Table 8, with fewer seeds than the report.
class Table8 : public testing::TestWithParam<int> {};

TEST_P(Table8, Steps) {
  const int sample = GetParam();
  const int mpu1[] = {1425, 834, 454};
  const int mpu2[] = {1046, 542, 317};
  for (const int density : kDensities) {
    std::vector<int> above;
    int bound = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const SampleSteps steps = sample_steps(sample, density, seed);
      EXPECT_EQ(steps.mpu1, mpu1[sample - 1]);
      EXPECT_EQ(steps.mpu2, mpu2[sample - 1]);
      EXPECT_LT(steps.mpu3_default, steps.mpu3 * 0.95);
      EXPECT_LT(steps.mpu3_default_clocks, steps.mpu3_clocks);
      above.push_back(steps.mpu3 - steps.bound);
      bound = steps.bound;
    }
    std::sort(above.begin(), above.end());
    EXPECT_LE(above[2], std::max(2, bound / 100)) << "density " << density;
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, Table8, testing::Values(1, 2, 3));

}  // namespace
}  // namespace rung::paper
