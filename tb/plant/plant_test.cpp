// SPDX-License-Identifier: Apache-2.0
// A minute of each plant with the controller; `make plant` runs an hour (plant_main.cpp).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "plant/controlled_plant.hpp"

namespace rung::tb {
namespace {

void run(std::unique_ptr<Plant> plant) {
  const PlantResult result = run_plant(*plant, {});
  EXPECT_EQ(result.difference, "");
  EXPECT_EQ(result.scans, 6000);
  EXPECT_EQ(result.overruns, 0);
  EXPECT_EQ(result.least_clocks, result.expected_clocks);
  EXPECT_EQ(result.most_clocks, result.expected_clocks);
  EXPECT_GT(result.polls, 1000);
  fmt::print("{}: {} scans of {} clocks, {} replies; {}\n", plant->name(), result.scans,
             result.most_clocks, result.polls, plant->work());
}

TEST(Plant, CrossingForAMinute) { run(make_crossing(1)); }
TEST(Plant, ConveyorForAMinute) { run(make_conveyor(1)); }

}  // namespace
}  // namespace rung::tb
