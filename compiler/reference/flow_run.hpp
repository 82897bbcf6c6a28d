// SPDX-License-Identifier: Apache-2.0
// Rounds of a flow program as an engine that gives a trace, a scan a round. There is nothing behind
// its links: a transfer over one has no answer, and fails with the round after it was sent.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "reference/flow_rounds.hpp"
#include "trace/recorder.hpp"
#include "trace/stimulus.hpp"

namespace rung {

// Devices that a flow program names, its ladder's, its steps' and those of its transfers.
std::vector<Device> visible_devices(const flowchart::Flowchart& chart);

class FlowRun {
 public:
  // `with_state`: each scan of the trace has the values of all devices that the program names.
  // `tick_us` is the time between two rounds, `config` says what the unit's own board has. `chart`
  // must outlive this.
  FlowRun(const flowchart::Flowchart& chart, bool with_state, std::int64_t tick_us,
          std::string config);

  // The first line of a trace of this run.
  TraceHeader header() const;
  // Applies the events, runs one round and gives what happened in it.
  TraceScan scan(std::span<const StimulusEvent> events);

  const FlowRounds& rounds() const { return rounds_; }
  int without_answer() const { return without_answer_; }

 private:
  struct NamedDevice {
    Device device;
    std::string name;
  };

  const flowchart::Flowchart& chart_;
  DeviceNames names_;
  std::int64_t tick_us_;
  FlowRounds rounds_;
  TraceRecorder recorder_;
  std::vector<NamedDevice> devices_;
  int without_answer_ = 0;
};

}  // namespace rung
