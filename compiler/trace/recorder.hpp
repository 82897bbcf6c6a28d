// SPDX-License-Identifier: Apache-2.0
// Makes the scans of a trace from what an engine, the reference or a processor, did in each.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "rungs/ports.hpp"
#include "trace/stimulus.hpp"
#include "trace/trace.hpp"

namespace rung {

// The engine reports each scan in this order: inputs, presets and received bytes, writes, outputs,
// state, sent bytes; then finish() gives the scan, with only the inputs and outputs that changed.
// Before scan 0 all are 0.
class TraceRecorder {
 public:
  // `with_state`: each scan has a state, even an empty one.
  explicit TraceRecorder(bool with_state) : with_state_(with_state) { begin(); }

  // What the scan was given: an input, a preset, an analogue value or a received byte.
  void event(const StimulusEvent& event, const DeviceNames& names) {
    if (event.device == port::uart_rx_data) {
      received(event.value);
    } else if (is_input(event.device)) {
      input(names.name(event.device), event.value);
    } else {
      preset(names.name(event.device), event.value);
    }
  }
  // The value that an input has in this scan; listed if it differs from the scan before.
  void input(const std::string& device, std::int32_t value) {
    if (changed(inputs_, device, value)) scan_.in.push_back({device, value});
  }
  // A value that is listed in any case: a preset, an analogue value.
  void preset(const std::string& device, std::int32_t value) {
    scan_.in.push_back({device, value});
  }
  void received(int byte) { scan_.rx.push_back(byte); }
  // An executed write, in order.
  void write(const std::string& device, std::int32_t value) {
    scan_.writes.push_back({device, value});
  }
  // The value that an output has after the refresh; listed if it differs from the scan before.
  void output(const std::string& device, std::int32_t value) {
    if (changed(outputs_, device, value)) scan_.out.push_back({device, value});
  }
  // A device's value after the scan; ignored without state.
  void state(const std::string& device, std::int32_t value) {
    if (scan_.state) scan_.state->push_back({device, value});
  }
  void sent(int byte) { scan_.tx.push_back(byte); }

  // The scan that was reported, with its clocks if the engine counts them; the next one begins.
  TraceScan finish(std::optional<std::int64_t> clocks) {
    scan_.clocks = clocks;
    TraceScan done = std::move(scan_);
    ++next_;
    begin();
    return done;
  }

 private:
  static bool changed(std::map<std::string, std::int32_t>& values, const std::string& device,
                      std::int32_t value) {
    return std::exchange(values[device], value) != value;
  }

  void begin() {
    scan_ = {};
    scan_.scan = next_;
    if (with_state_) scan_.state.emplace();
  }

  bool with_state_;
  std::int64_t next_ = 0;
  TraceScan scan_;
  std::map<std::string, std::int32_t> inputs_;
  std::map<std::string, std::int32_t> outputs_;
};

}  // namespace rung
