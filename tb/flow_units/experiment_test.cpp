// SPDX-License-Identifier: Apache-2.0
// A sample of `make flow-report`: the scenario with everything in it, at the most tasks, and the
// paper's effect.
#include "flow_units/experiment.hpp"

#include <gtest/gtest.h>

namespace rung::tb {
namespace {

TEST(FlowExperiment, InsideItsBoundWithEverything) {
  const FlowResult result =
      run_flow_cells(FlowMode::Sampled, 100, 20, 1, {6}, FlowLadder::Short).front();
  EXPECT_LE(result.most_clocks, static_cast<std::uint64_t>(result.bound_clocks));
  EXPECT_LE(result.most_round, static_cast<std::uint64_t>(result.round_bound));
  EXPECT_GT(result.pc_commands, 0);
  EXPECT_GT(result.event_commands, 0);
  EXPECT_GT(result.panel_answers, 0);
  EXPECT_EQ(result.ladder_min, result.ladder_max);
  EXPECT_TRUE(result.complaints.empty()) << result.complaints.front();
}

// A command that waits in its place: its panel holds up everything, beyond the paper's goal of 5
// ms.
TEST(FlowExperiment, WithoutSuspensionThePanelIsFelt) {
  const FlowResult result =
      run_flow_cells(FlowMode::Waiting, 1, 2, 1, {4}, FlowLadder::Short).front();
  EXPECT_GT(milliseconds(result.most), 5);
  EXPECT_GT(result.panel_answers, 0);
}

}  // namespace
}  // namespace rung::tb
