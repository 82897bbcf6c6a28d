// SPDX-License-Identifier: Apache-2.0
// Simulated time held to real time.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace rung::device {

// A simulation that falls behind catches up if it is less than `kSlack`; what is more is given up,
// so that a slow moment is not followed by a long one in which time runs too fast.
class Pace {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kSlack{100};
  static constexpr std::chrono::seconds kReport{2};  // between two reports

  struct Lag {
    double lost_ms = 0;   // given up since the last report
    double over_ms = 0;   // real time since then
    double total_ms = 0;  // given up since the start
  };

  Pace(std::uint64_t clocks_per_second, Clock::time_point start);

  // Clocks to run at `now`, with `done` run since the start.
  std::uint64_t due(Clock::time_point now, std::uint64_t done);
  // When the clock after `done` is due.
  Clock::time_point when(std::uint64_t done) const;
  // Time given up, if there is any to tell and the last report is long enough ago.
  std::optional<Lag> report(Clock::time_point now);
  double lost_ms() const { return total_ms_; }

 private:
  std::uint64_t clocks_per_second_;
  Clock::time_point origin_;
  Clock::time_point reported_;
  double lost_ms_ = 0;
  double total_ms_ = 0;
};

}  // namespace rung::device
