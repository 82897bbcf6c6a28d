// SPDX-License-Identifier: Apache-2.0
#include "device/pace.hpp"

#include <gtest/gtest.h>

namespace rung::device {
namespace {

using namespace std::chrono_literals;

const Pace::Clock::time_point kStart{1000s};

TEST(Pace, ClocksComeWithTime) {
  Pace pace(250'000, kStart);
  EXPECT_EQ(pace.due(kStart, 0), 0U);
  EXPECT_EQ(pace.due(kStart + 1ms, 0), 250U);
  EXPECT_EQ(pace.due(kStart + 1ms, 250), 0U);
  EXPECT_EQ(pace.due(kStart + 1ms, 400), 0U);
  EXPECT_EQ(pace.when(250), kStart + 1ms);
  EXPECT_EQ(pace.due(kStart + 90ms, 250), 89U * 250);
  EXPECT_EQ(pace.lost_ms(), 0);
}

TEST(Pace, NoDriftInAYear) {
  constexpr std::uint64_t kRate = 250'007;
  Pace pace(kRate, kStart);
  const auto year = 365 * 24h;
  const std::uint64_t clocks = 365ULL * 24 * 3600 * kRate;
  EXPECT_EQ(pace.when(clocks), kStart + year);
  EXPECT_EQ(pace.due(kStart + year, clocks), 0U);
  EXPECT_EQ(pace.due(kStart + year, clocks - 3), 3U);
}

TEST(Pace, MoreThanTheSlackIsGivenUpAndTold) {
  Pace pace(250'000, kStart);
  EXPECT_EQ(pace.due(kStart + 350ms, 0), 25'000U);
  EXPECT_NEAR(pace.lost_ms(), 250, 0.001);
  // From there on time goes on as before.
  EXPECT_EQ(pace.due(kStart + 350ms, 25'000), 0U);
  EXPECT_EQ(pace.due(kStart + 351ms, 25'000), 250U);
  EXPECT_FALSE(pace.report(kStart + 1s));
  const auto lag = pace.report(kStart + 2s);
  ASSERT_TRUE(lag);
  EXPECT_NEAR(lag->lost_ms, 250, 0.001);
  EXPECT_NEAR(lag->over_ms, 2000, 0.001);
  EXPECT_NEAR(lag->total_ms, 250, 0.001);
  // Nothing new: nothing to tell.
  EXPECT_FALSE(pace.report(kStart + 5s));
}

}  // namespace
}  // namespace rung::device
