// SPDX-License-Identifier: Apache-2.0
// Time of a program: ticks and clock relays against the formulas of rungs/special.hpp, at captures
// of every distance, over many periods of the slowest relay.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "Vtime_base.h"
#include "harness/clocked.hpp"
#include "programs/random_source.hpp"
#include "rungs/special.hpp"

namespace rung::tb {
namespace {

constexpr std::int64_t kClocksPerMs = 5;  // tb/controller/scan.cmake
constexpr std::int64_t kClockUs = 1000 / kClocksPerMs;
constexpr std::array<std::int64_t, 3> kBases = {1000, 10000, 100000};
constexpr std::array<std::int64_t, 6> kPeriods = {10, 100, 200, 1000, 2000, 60000};

class TimeBase : public testing::Test {
 protected:
  TimeBase() {
    dut_->capture_i = 0;
    dut_->first_i = 0;
    dut_.reset();
  }

  // A capture `distance` clocks behind the last one.
  void capture(std::int64_t distance, bool first) {
    for (std::int64_t i = 1; i < distance; ++i) clock();
    dut_->capture_i = 1;
    dut_->first_i = first ? 1 : 0;
    clock();
    dut_->capture_i = 0;
    dut_->first_i = 0;
    before_us_ = first ? 0 : now_us_;
    now_us_ = first ? 0 : now_us_ + distance * kClockUs;
    check();
  }

  void check() {
    for (std::size_t i = 0; i < kBases.size(); ++i) {
      const std::int64_t ticks = now_us_ / kBases[i] - before_us_ / kBases[i];
      const auto got = static_cast<std::int64_t>(dut_->ticks_o >> 16 * i & 0xffff);
      ASSERT_EQ(got, std::min<std::int64_t>(ticks, 32767)) << kBases[i] << " us, t " << now_us_;
    }
    for (std::size_t i = 0; i < kPeriods.size(); ++i) {
      ASSERT_EQ(dut_->relays_o >> i & 1, 2 * now_us_ / (kPeriods[i] * 1000) % 2)
          << kPeriods[i] << " ms, t " << now_us_;
    }
  }

  void clock() {
    dut_.tick();
    ++clocks_;
    milliseconds_ += dut_->millisecond_o;
  }

  Clocked<Vtime_base> dut_;
  std::int64_t now_us_ = 0, before_us_ = 0, clocks_ = 0, milliseconds_ = 0;
};

TEST_F(TimeBase, EveryDistance) {
  RandomSource random(1);
  for (const std::int64_t distance :
       {1, 2, 3, 4, 5, 6, 7, 24, 25, 26, 49, 50, 51, 499, 500, 501, 2503}) {
    for (std::int64_t i = 1; i < 1 + random.below(50); ++i) clock();
    capture(1, true);
    for (int scan = 0; scan < 300; ++scan) ASSERT_NO_FATAL_FAILURE(capture(distance, false));
  }
}

TEST_F(TimeBase, AsTheReferenceCountsScans) {
  capture(1, true);
  for (ScanTime time{1, 37 * kClockUs}; time.scan < 30000; ++time.scan) {
    ASSERT_NO_FATAL_FAILURE(capture(37, false));
    ASSERT_EQ(dut_->ticks_o & 0xffff, ticks_since_last(1000, time));
  }
}

TEST_F(TimeBase, RandomDistancesOverTheSlowestRelay) {
  RandomSource random(2);
  capture(1, true);
  while (now_us_ < 400'000'000) {
    ASSERT_NO_FATAL_FAILURE(capture(1 + random.below(random.percent(5) ? 20000 : 300), false));
  }
}

TEST_F(TimeBase, TicksSaturate) {
  capture(1, true);
  capture(32'766 * kClocksPerMs, false);
  capture(32'767 * kClocksPerMs, false);
  capture(32'768 * kClocksPerMs, false);
  capture(70'000 * kClocksPerMs + 1, false);
  capture(3, false);
  EXPECT_EQ(before_us_ % 1000, 200);
}

TEST_F(TimeBase, TheFirmwaresMillisecondsRunOnTheirOwn) {
  const std::int64_t begin = dut_->milliseconds_o;
  for (int i = 0; i < 1000; ++i) capture(1 + i % 17, i % 3 == 0);
  EXPECT_LE(std::abs(milliseconds_ - clocks_ / kClocksPerMs), 1);
  EXPECT_LE(std::abs(dut_->milliseconds_o - begin - clocks_ / kClocksPerMs), 1);
}

}  // namespace
}  // namespace rung::tb
