// SPDX-License-Identifier: Apache-2.0
// How long after an edge at unit 1's first input pin its first output pin follows.
#pragma once

#include <cstdint>
#include <random>

#include "flow_units/system.hpp"

namespace rung::tb {

// From an input's edge to the output's. `polled_ms` is what the polling takes, `waited_ms` what the
// processor has waited for the panel in its place (with suspension off), `clocks` the rest.
struct FlowResponse {
  double polled_ms = 0;
  double waited_ms = 0;
  std::uint64_t clocks = 0;
};
// In milliseconds, of a processor at 100 MHz.
double milliseconds(const FlowResponse& response);

class FlowProbe {
 public:
  // `polled`: the input is behind a filter, whose part of the time is told apart. `waits`: so is
  // the time in which the panel has a request, in which nothing else goes on.
  FlowProbe(FlowSystem& system, bool polled, bool waits, std::uint64_t seed)
      : system_(system), polled_(polled), waits_(waits), random_(seed) {}

  // One input at a random phase, up and down by turns: how the output followed. Throws
  // std::runtime_error if it does not within seconds.
  FlowResponse input();

 private:
  void wait_random();
  FlowResponse edge(bool level);
  void step(std::uint64_t start);

  FlowSystem& system_;
  bool polled_, waits_;
  bool level_ = false;
  std::mt19937_64 random_;
};

}  // namespace rung::tb
