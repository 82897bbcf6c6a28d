// SPDX-License-Identifier: Apache-2.0
// A sample of `make flow-report`: the scenario with everything in it, at the most tasks, and the
// paper's effect.
#include "flow_units/experiment.hpp"

#include <gtest/gtest.h>

namespace rung::tb {
namespace {

constexpr int kEverything = 6;

TEST(FlowExperiment, InsideItsBoundWithEverything) {
  const FlowCell cell{kEverything, 100, FlowMode::Sampled, 20, 1};
  const FlowResult result = run_flow_cell(cell);
  EXPECT_LE(result.most_clocks, static_cast<std::uint64_t>(result.bound_clocks));
  EXPECT_LE(result.most_round, static_cast<std::uint64_t>(result.round_bound));
  EXPECT_LE(result.most_clocks, 10'000U);  // 100 us at 100 MHz
  EXPECT_GT(result.pc_commands, 0);
  EXPECT_TRUE(result.complaints.empty()) << result.complaints.front();
}

// A step that waits in its place: its panel holds up everything.
TEST(FlowExperiment, WithoutSuspensionThePanelIsFelt) {
  const FlowResult result = run_flow_cell({4, 10, FlowMode::Waiting, 4, 1});
  EXPECT_GT(milliseconds(result.most), 10);
  EXPECT_GT(result.panel_answers, 0);
}

}  // namespace
}  // namespace rung::tb
