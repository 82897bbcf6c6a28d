// SPDX-License-Identifier: Apache-2.0
#include "flow_units/probe.hpp"

#include <stdexcept>

namespace rung::tb {
namespace {

constexpr double kMhz = 100;  // of the processor, for what is told in milliseconds
constexpr double kPatienceMs = 4000;

double per_ms() { return static_cast<double>(FlowSystem::clocks_per_ms()); }

}  // namespace

double milliseconds(const FlowResponse& response) {
  return response.polled_ms + response.waited_ms +
         static_cast<double>(response.clocks) / (1000 * kMhz);
}

FlowResponse FlowProbe::input() {
  wait_random();
  level_ = !level_;
  return edge(level_);
}

void FlowProbe::wait_random() {
  std::uniform_real_distribution<double> pause(0.3, 1.3);
  system_.run(static_cast<std::uint64_t>(pause(random_) * per_ms()));
}

FlowResponse FlowProbe::edge(bool level) {
  const std::uint64_t start = system_.now();
  system_.set_input(1, 0, level);
  // Polled: until the second equal read has let it in. Sampled in every round: no such part.
  std::uint64_t seen = start;
  if (polled_) {
    while (system_.filtered(1, 0) != level) step(start);
    seen = system_.now();
  }
  std::uint64_t waited = 0;
  while (system_.output(1, 0) != level) {
    step(start);
    if (waits_ && system_.panel_under_way(1)) ++waited;
  }
  return {static_cast<double>(seen - start) / per_ms(), static_cast<double>(waited) / per_ms(),
          system_.now() - seen - waited};
}

void FlowProbe::step(std::uint64_t start) {
  system_.clock();
  if (static_cast<double>(system_.now() - start) > kPatienceMs * per_ms()) {
    throw std::runtime_error("the output does not follow its input");
  }
}

}  // namespace rung::tb
