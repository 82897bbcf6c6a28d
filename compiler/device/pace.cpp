// SPDX-License-Identifier: Apache-2.0
#include "device/pace.hpp"

namespace rung::device {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

// Whole seconds apart: years of clocks times a billion nanoseconds do not fit 64 bits.
Pace::Clock::duration time_of(std::uint64_t clocks, std::uint64_t clocks_per_second) {
  const std::chrono::seconds seconds(clocks / clocks_per_second);
  const std::chrono::nanoseconds rest(clocks % clocks_per_second * 1'000'000'000 /
                                      clocks_per_second);
  return seconds + rest;
}

}  // namespace

Pace::Pace(std::uint64_t clocks_per_second, Clock::time_point start)
    : clocks_per_second_(clocks_per_second), origin_(start), reported_(start) {}

Pace::Clock::time_point Pace::when(std::uint64_t done) const {
  return origin_ + time_of(done, clocks_per_second_);
}

std::uint64_t Pace::due(Clock::time_point now, std::uint64_t done) {
  const Clock::duration behind = now - when(done);
  if (behind <= Clock::duration::zero()) return 0;
  if (behind > kSlack) {
    const Clock::duration given_up = behind - kSlack;
    origin_ += given_up;
    lost_ms_ += Milliseconds(given_up).count();
    total_ms_ += Milliseconds(given_up).count();
    return due(now, done);
  }
  const auto nanoseconds = static_cast<std::uint64_t>(std::chrono::nanoseconds(behind).count());
  return nanoseconds * clocks_per_second_ / 1'000'000'000;
}

std::optional<Pace::Lag> Pace::report(Clock::time_point now) {
  if (now - reported_ < kReport) return std::nullopt;
  const Lag lag{lost_ms_, Milliseconds(now - reported_).count(), total_ms_};
  reported_ = now;
  lost_ms_ = 0;
  if (lag.lost_ms < 1) return std::nullopt;
  return lag;
}

}  // namespace rung::device
