// SPDX-License-Identifier: Apache-2.0
#include "schedule/schedule.hpp"

#include <fmt/format.h>

#include "passes/support.hpp"
#include "programs/random_program.hpp"

namespace rung::schedule {
namespace {

struct Scheduled {
  core::Program program;
  logic::Logic logic;
  mapping::Mapping mapping;
  Problem problem;
  Schedule schedule;
  Temporaries temporaries;

  explicit Scheduled(const std::string& text, int slots = 2) : program(lowered(text)) {
    logic = logic::build(program);
    mapping = mapping::map_logic(logic, program, {});
    problem = make_problem(mapping, ecp5(), slots);
    schedule = search(problem, {});
    temporaries = allocate_temporaries(schedule, mapping);
  }
  std::string check(const Schedule& other) const {
    return verify(other, mapping, temporaries, ecp5());
  }
};

TEST(Schedule, IndependentRungsShareSteps) {
  const Scheduled s("LD X0\nOUT Y0\nLD X1\nOUT Y1\nLD X2\nOUT Y2\nLD X3\nOUT Y3\nEND\n");
  EXPECT_EQ(s.schedule.steps.size(), 2U);
  EXPECT_EQ(s.check(s.schedule), "");
}

TEST(Schedule, ADependentChainIsItsLowerBound) {
  const Scheduled s("LD X0\nOUT M0\nLD M0\nOUT M1\nLD M1\nOUT M2\nLD M2\nOUT M3\nEND\n");
  const Report r = report(s.schedule, s.problem);
  EXPECT_EQ(r.by_dependence, 4);
  EXPECT_EQ(r.lower_bound, 4);
  EXPECT_EQ(r.steps, 4);
  EXPECT_EQ(r.holes, 4);
}

TEST(Schedule, AProductIsCollectedWhenItIsReady) {
  const Scheduled s("LD X0\nMUL D0 D1 D2\nLD X1\nMOV D2 D4\nEND\n");
  EXPECT_EQ(s.check(s.schedule), "");
  // LUT, MULS, mul_latency later MVL, then MV
  EXPECT_EQ(s.problem.by_dependence, 1 + 1 + ecp5().mul_latency + 1);
}

// Every exchange of two neighbouring operations, in time or between slots, either keeps the
// meaning, and then the check agrees that it does, or is found. Taking an operation away is always
// found.
TEST(Schedule, VerifyFindsInjectedFaults) {
  int refused = 0;
  int accepted = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomProgramOptions options;
    options.networks = 8;
    options.inputs = 4;
    options.outputs = 3;
    options.relays = 4;
    options.words = 3;
    const Scheduled s(random_program(seed, options));
    ASSERT_EQ(s.check(s.schedule), "");
    for (std::size_t step = 0; step + 1 < s.schedule.steps.size(); ++step) {
      for (std::size_t slot = 0; slot < 2; ++slot) {
        if (s.schedule.steps[step][slot] == mapping::kNoOp) continue;
        Schedule lost = s.schedule;
        lost.steps[step][slot] = mapping::kNoOp;
        ASSERT_NE(s.check(lost), "") << "seed " << seed << " step " << step;
        Schedule twice = s.schedule;
        twice.steps[step + 1][slot] = twice.steps[step][slot];
        ASSERT_NE(s.check(twice), "") << "seed " << seed << " step " << step;
        Schedule later = s.schedule;
        std::swap(later.steps[step][slot], later.steps[step + 1][slot]);
        (s.check(later).empty() ? accepted : refused) += 1;
        Schedule across = s.schedule;
        std::swap(across.steps[step][slot], across.steps[step + 1][1 - slot]);
        (s.check(across).empty() ? accepted : refused) += 1;
      }
    }
  }
  EXPECT_GT(refused, accepted * 3);
  EXPECT_GT(accepted, 0);
}

TEST(Schedule, VerifyKnowsTheOrderOfTwoWrites) {
  const Scheduled s("LD X0\nOUT M0\nLD X1\nOUT M0\nEND\n", 1);
  ASSERT_EQ(s.schedule.steps.size(), 2U);
  Schedule swapped = s.schedule;
  std::swap(swapped.steps[0], swapped.steps[1]);
  EXPECT_NE(s.check(swapped), "");
  Schedule together;
  together.steps = {{s.schedule.steps[0][0], s.schedule.steps[1][0]}};
  EXPECT_EQ(s.check(together), "step 0: two writes of one device");
}

TEST(Schedule, VerifyFindsAProductCollectedTooEarly) {
  const Scheduled s("LD X0\nMUL D0 D1 D2\nEND\n", 1);
  Schedule early = s.schedule;
  // Take out the steps in which nothing runs while the product is made.
  std::erase_if(early.steps, [](const auto& step) { return step[0] == mapping::kNoOp; });
  ASSERT_LT(early.steps.size(), s.schedule.steps.size());
  EXPECT_NE(s.check(early).find("too early"), std::string::npos);
}

TEST(Schedule, VerifyFindsTemporariesThatShareAnAddress) {
  // Four sums of two products each, multiplied: three of them wait for the fourth.
  std::string text;
  for (int i = 0; i < 32; i += 8) {
    for (int k = 0; k < 8; k += 2) {
      text += fmt::format("LD X{:o}\nAND X{:o}\n", i + k, i + k + 1);
      if (k > 0) text += "ORB\n";
    }
    if (i > 0) text += "ANB\n";
  }
  const Scheduled s(text + "OUT Y0\nEND\n");
  ASSERT_GE(s.mapping.temporaries, 2);
  ASSERT_GE(s.temporaries.count, 2);
  Temporaries one = s.temporaries;
  std::fill(one.address.begin(), one.address.end(), 0);
  EXPECT_NE(verify(s.schedule, s.mapping, one, ecp5()), "");
}

}  // namespace
}  // namespace rung::schedule
