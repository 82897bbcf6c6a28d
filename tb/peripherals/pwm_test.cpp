// SPDX-License-Identifier: Apache-2.0
// The PWM output measured clock by clock: number of periods, share of the time, and changes.
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <vector>

#include "Vpwm.h"
#include "harness/clocked.hpp"

namespace rung::tb {
namespace {

constexpr int kClockHz = 100000;  // as CMakeLists.txt gives it
constexpr int kSettle = 18;       // clocks until a frequency of 0 is left

class Pwm {
 public:
  Pwm() {
    set(0, 0);
    pwm_.reset();
  }
  void set(int duty, std::uint32_t hz) {
    pwm_->duty_i = static_cast<std::uint16_t>(duty);
    pwm_->hz_i = hz;
  }
  bool clock() {
    pwm_.tick();
    return pwm_->pwm_o != 0;
  }
  std::vector<bool> clocks(int count) {
    std::vector<bool> levels;
    for (int i = 0; i < count; ++i) levels.push_back(clock());
    return levels;
  }

 private:
  Clocked<Vpwm> pwm_;
};

struct Measured {
  int on = 0;       // clocks
  int periods = 0;  // rising edges
};

Measured measure(const std::vector<bool>& levels) {
  Measured measured;
  bool before = levels.back();  // what is measured comes again and again
  for (const bool level : levels) {
    measured.on += level ? 1 : 0;
    measured.periods += level && !before ? 1 : 0;
    before = level;
  }
  return measured;
}

// In one second the phase takes each multiple of gcd(hz, clock) equally often.
int expected_on(int duty, int hz) {
  const int grid = std::gcd(hz, kClockHz);
  const int share = duty * (kClockHz / 100);
  return (share + grid - 1) / grid * grid;
}

TEST(PwmOutput, PeriodsAndShareOfASecondAreExact) {
  for (const int hz : {1, 2, 7, 50, 333, 997, 1000, 4096, 9999}) {
    for (const int duty : {0, 1, 10, 33, 50, 75, 89, 99, 100}) {
      Pwm pwm;
      pwm.set(duty, static_cast<std::uint32_t>(hz));
      pwm.clocks(3 * kSettle);
      const Measured measured = measure(pwm.clocks(kClockHz));
      EXPECT_EQ(measured.on, expected_on(duty, hz)) << hz << " Hz, " << duty << " %";
      // Below the share of one clock in a period some periods have no pulse or no pause.
      const bool shows = duty * (kClockHz / 100) >= hz && (100 - duty) * (kClockHz / 100) >= hz;
      if (duty == 0 || duty == 100) {
        EXPECT_EQ(measured.periods, 0) << hz << " Hz, " << duty << " %";
      } else if (shows) {
        EXPECT_EQ(measured.periods, hz) << hz << " Hz, " << duty << " %";
      }
    }
  }
}

TEST(PwmOutput, EveryPeriodIsAtMostAClockOff) {
  for (const int hz : {7, 333, 997, 4096}) {
    Pwm pwm;
    pwm.set(40, static_cast<std::uint32_t>(hz));
    pwm.clocks(kSettle);
    int last = -1;
    bool before = true;
    const double period = static_cast<double>(kClockHz) / hz;
    for (int i = 0; i < 5 * kClockHz / 7; ++i) {
      const bool level = pwm.clock();
      if (level && !before) {
        if (last >= 0) {
          EXPECT_NEAR(i - last, period, 1) << hz;
        }
        last = i;
      }
      before = level;
    }
    EXPECT_GE(last, 0) << hz;
  }
}

TEST(PwmOutput, DutyIsClampedAndWhatTheClockCannotMakeIsOff) {
  const auto on = [](int duty, std::uint32_t hz) {
    Pwm pwm;
    pwm.set(duty, hz);
    pwm.clocks(kSettle);
    return measure(pwm.clocks(kClockHz)).on;
  };
  EXPECT_EQ(on(101, 100), kClockHz);
  EXPECT_EQ(on(128, 100), kClockHz);
  EXPECT_EQ(on(32767, 100), kClockHz);
  EXPECT_EQ(on(-1, 100), 0);
  EXPECT_EQ(on(-32768, 100), 0);
  EXPECT_EQ(on(-32768 + 50, 100), 0);
  EXPECT_EQ(on(50, 0), 0);
  EXPECT_EQ(on(100, 0), 0);
  EXPECT_EQ(on(50, kClockHz / 2), kClockHz / 2);
  EXPECT_EQ(on(50, kClockHz / 2 + 1), 0);
  EXPECT_EQ(on(50, kClockHz), 0);
  EXPECT_EQ(on(50, 0x80000000U), 0);
  EXPECT_EQ(on(50, 0x00020000U), 0);
}

// The pair changes at every clock of a period in turn: each period of the output is one pair's or
// the other's, whole.
TEST(PwmOutput, AChangeWaitsForThePeriodsEnd) {
  constexpr int kFirst = 1000, kSecond = 2000;  // 100 and 50 clocks a period
  constexpr int kFirstOn = 20, kSecondOn = 35;  // 20 % and 70 %
  for (int when = 0; when < 100; ++when) {
    Pwm pwm;
    pwm.set(20, kFirst);
    pwm.clocks(500 + when);
    pwm.set(70, kSecond);
    int on = 0, off = 0, firsts = 0, seconds = 0;
    bool before = true, whole = false;
    for (int i = 0; i < 1000; ++i) {
      const bool level = pwm.clock();
      if (level && !before) {
        if (whole) {
          const bool first = on == kFirstOn && on + off == kClockHz / kFirst;
          const bool second = on == kSecondOn && on + off == kClockHz / kSecond;
          EXPECT_TRUE(first || second) << on << " of " << on + off << ", changed at " << when;
          EXPECT_FALSE(first && seconds > 0) << when;
          firsts += first ? 1 : 0;
          seconds += second ? 1 : 0;
        }
        whole = true;
        on = off = 0;
      }
      (level ? on : off)++;
      before = level;
    }
    EXPECT_LE(firsts, 2) << when;
    EXPECT_GE(seconds, 14) << when;
  }
}

TEST(PwmOutput, BeginsAndEndsWithTheFrequency) {
  for (int when = 0; when < 8; ++when) {
    Pwm pwm;
    pwm.clocks(100 + when);
    pwm.set(50, 1000);
    int clocks = 0;
    while (!pwm.clock()) ASSERT_LT(++clocks, kSettle) << when;
    for (int i = 1; i < 50; ++i) ASSERT_TRUE(pwm.clock()) << i;
    for (int i = 0; i < 50; ++i) ASSERT_FALSE(pwm.clock()) << i;
    pwm.clocks(10);
    pwm.set(50, 0);
    // The period that runs is the last one.
    for (int i = 10; i < 50; ++i) ASSERT_TRUE(pwm.clock()) << i;
    for (int i = 0; i < 400; ++i) ASSERT_FALSE(pwm.clock()) << i;
  }
}

}  // namespace
}  // namespace rung::tb
