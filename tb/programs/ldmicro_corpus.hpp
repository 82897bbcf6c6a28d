// SPDX-License-Identifier: Apache-2.0
// LDmicro programs that nobody here wrote, with what each was given and what LDmicro's own
// simulator showed, where they are present beside the repository. They are no part of the project.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rungs/program.hpp"
#include "trace/ldmicro_trace.hpp"
#include "trace/stimulus.hpp"

namespace rung {

struct LdmicroSample {
  std::string name;      // "probes/ton"
  std::string program;   // files
  std::string stimulus;  // empty if the simulator has refused the program: then it has no trace
  std::string trace;
};
// All of them, by name; none if the folder is not there. `shared` is the folder beside the
// repository that holds it.
std::vector<LdmicroSample> ldmicro_samples(const std::string& shared);

// Where we chose to differ from the simulator. In all else its traces are met.
struct LdmicroDeviation {
  const char* name;
  const char* why;
  std::size_t scans;  // so many are equal
};
std::span<const LdmicroDeviation> ldmicro_deviations();

struct LdmicroCase {
  std::optional<Program> program;  // nothing if it is refused, for the reason in `messages`
  Stimulus stimulus;
  LdmicroTrace trace;
  std::string messages;  // errors and warnings
};
LdmicroCase load_ldmicro(const LdmicroSample& sample);

// Runs all scans of the trace; gives the first one that differs.
std::optional<TraceDifference> compare_ldmicro(
    const LdmicroCase& ldmicro,
    const std::function<TraceScan(std::span<const StimulusEvent>)>& scan);

}  // namespace rung
