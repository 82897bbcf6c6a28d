// SPDX-License-Identifier: Apache-2.0
// What `make flow-report` writes: the measured responses beside the paper's and beside the printed
// bounds.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "flow_units/experiment.hpp"

namespace rung::tb {

inline constexpr int kTaskCounts[] = {1, 10, 30, 50, 100};

class FlowReport {
 public:
  explicit FlowReport(const std::vector<FlowResult>& results);

  // What does not meet its goal or bound, a line each; empty: all is well.
  std::vector<std::string> failures() const;
  // The page, and the same figures as JSON.
  std::string markdown(const std::string& date, std::uint64_t seed, double seconds) const;
  std::string json(const std::string& date, std::uint64_t seed) const;

 private:
  const FlowResult* find(FlowMode mode, int scenario, int tasks) const;
  std::string table(FlowMode mode) const;
  std::string sampled_table() const;

  std::map<std::tuple<FlowMode, int, int>, FlowResult> results_;
};

}  // namespace rung::tb
