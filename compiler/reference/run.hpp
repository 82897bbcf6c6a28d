// SPDX-License-Identifier: Apache-2.0
// The reference as an engine that gives a trace.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "reference/reference.hpp"
#include "trace/recorder.hpp"
#include "trace/stimulus.hpp"

namespace rung {

class ReferenceRun {
 public:
  // `with_state`: each scan of the trace has the values of all devices that the program names.
  // `tick_us` is the time between two scans; an LDmicro program has its own. `program` must outlive
  // this.
  ReferenceRun(const Program& program, bool with_state, std::int64_t tick_us = 10000);

  // The first line of a trace of this run.
  TraceHeader header() const;
  // Applies the events, runs one scan and gives what happened in it.
  TraceScan scan(std::span<const StimulusEvent> events);

  const Reference& reference() const { return reference_; }

 private:
  struct NamedDevice {
    Device device;
    std::string name;
  };

  const Program& program_;
  DeviceNames names_;
  std::int64_t tick_us_;
  Reference reference_;
  TraceRecorder recorder_;
  std::vector<NamedDevice> devices_;
};

}  // namespace rung
