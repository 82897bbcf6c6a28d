// SPDX-License-Identifier: Apache-2.0
// How long after an edge at unit 1's first input pin its first output pin follows.
#pragma once

#include <cstdint>
#include <random>

#include "flow_units/system.hpp"

namespace rung::tb {

// From an input's edge to the output's. `polled_ms` is what the polling takes, `clocks` the rest.
struct FlowResponse {
  double polled_ms = 0;
  std::uint64_t clocks = 0;
};
// In milliseconds, of a processor at 100 MHz.
double milliseconds(const FlowResponse& response);

class FlowProbe {
 public:
  // `polled`: the input is behind a filter, whose part of the time is told apart.
  FlowProbe(FlowSystem& system, bool polled, std::uint64_t seed)
      : system_(system), polled_(polled), random_(seed) {}

  // One input at a random phase: up, until the output has followed, and down again. That of the way
  // up. Throws std::runtime_error if the output does not follow within seconds.
  FlowResponse input();

 private:
  void wait_random();
  FlowResponse edge(bool level);
  void step(std::uint64_t start);

  FlowSystem& system_;
  bool polled_;
  std::mt19937_64 random_;
};

}  // namespace rung::tb
