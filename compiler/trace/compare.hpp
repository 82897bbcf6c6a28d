// SPDX-License-Identifier: Apache-2.0
// Whether two traces say the same.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "trace/trace.hpp"

namespace rung {

enum class TraceAspect { Input, Write, Output, State, Received, Sent, Clocks, Scans };

// The first place where two traces differ. `expected` and `got` are values as text, or "nothing".
struct TraceDifference {
  std::int64_t scan = 0;
  TraceAspect aspect = TraceAspect::Write;
  std::string device;  // empty for Received, Sent, Clocks and Scans
  std::string expected;
  std::string got;
  bool operator==(const TraceDifference&) const = default;
};

// "scan 3: write of M0: expected 1, got 0"
std::string describe(const TraceDifference& difference);

// Compares two traces scan by scan. Equal are: the values of all inputs; of each device the
// sequence of writes, without those that do not change its value; the values of all outputs after
// the refresh; the states where both have one; bytes received and sent; the clocks, if asked for
// and both have them.
class TraceComparison {
 public:
  // `clocks`: compare them too, which makes sense between equal processors only. `merged`: one of
  // the traces does not have all writes, so of each device only the value that it ends with in a
  // scan is compared.
  explicit TraceComparison(bool clocks, bool merged = false) : clocks_(clocks), merged_(merged) {}

  // The next scan of each trace; gives their first difference.
  std::optional<TraceDifference> next(const TraceScan& expected, const TraceScan& got);

 private:
  using Values = std::map<std::string, std::int32_t>;
  using Pair = std::pair<Values, Values>;  // of the expected trace, of the other

  bool clocks_;
  bool merged_;
  Pair inputs_;
  Pair outputs_;
  Pair devices_;  // last value of everything that is written or preset
};

// Compares whole traces; clocks if both are of the same processor, by what each scan ends with if
// one is merged.
std::optional<TraceDifference> compare_traces(const Trace& expected, const Trace& got);

}  // namespace rung
