// SPDX-License-Identifier: Apache-2.0
// A trace of LDmicro's own simulator: after each scan a line `7: Xa=1 count=3 TX=65` with the
// values of all that has been touched so far and the bytes that were sent. What a line does not
// name is 0. It ends where that simulator ended: after the last scan, or at an error that it shows.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/diagnostics.hpp"
#include "trace/compare.hpp"
#include "trace/trace.hpp"

namespace rung {

struct LdmicroTrace {
  std::vector<TraceScan> scans;  // of each only `line`, `scan`, `state` and `tx`
  // Where the simulator stopped by itself, and what it said. A scan that it did not end is none.
  struct Stop {
    int line = 1;
    std::string what;
  };
  std::optional<Stop> stop;
};

// Whether a file is meant as such a trace, by its first line.
bool is_ldmicro_trace(std::string_view bytes);

// Reads a whole trace; `file` is its name for messages. What is none is refused with an error at
// the line.
std::optional<LdmicroTrace> read_ldmicro_trace(std::string_view bytes, const std::string& file,
                                               Diagnostics& diagnostics);

// Compares a scan of such a trace with one of ours, which has a state: every device that the state
// or the trace names, and the bytes sent. A name that is both a bit and a variable is left out, for
// LDmicro's trace does not say which of them it shows.
std::optional<TraceDifference> compare_shown(const TraceScan& expected, const TraceScan& got);

}  // namespace rung
