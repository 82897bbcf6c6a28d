// SPDX-License-Identifier: Apache-2.0
// What a controller is given in each scan: input values and presets.
//
// A stimulus file has one line a scan. Its tokens, separated by blanks: `X0=1` sets an input from
// this scan on; `D5=7` or `M3=1` presets any other device, once, before the program runs; `*N`
// stands for N scans of this line, the presets acting in the first of them only; tokens that start
// with `_` mean nothing. An empty line is a scan in which nothing changes.
//
// An LDmicro program has names of its own. There `name=7` also sets the analogue channel that is
// read into this variable, whose value holds, and `RX=65` is a byte that the UART receives.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rungs/names.hpp"
#include "source/text_file.hpp"
#include "trace/trace.hpp"

namespace rung {

// A device that gets a value just before a scan; a byte that arrives is one for port::uart_rx_data.
struct StimulusEvent {
  Device device;
  std::int16_t value = 0;
  bool operator==(const StimulusEvent&) const = default;
};
// An input's value holds and is shown when it changes; anything else is a preset.
inline bool is_input(Device device) { return device.kind == DeviceKind::X; }

class Stimulus {
 public:
  // How many scans it has.
  std::uint64_t scans() const { return scans_; }
  // The events of `scan`, in order; none beyond the last scan.
  std::span<const StimulusEvent> events(std::uint64_t scan) const;
  // Adds `count` scans, at least one; the events act in the first of them.
  void append(std::vector<StimulusEvent> events, std::uint64_t count = 1);

 private:
  struct Line {
    std::uint64_t first;
    std::vector<StimulusEvent> events;
  };
  std::vector<Line> lines_;  // those with events
  std::uint64_t scans_ = 0;
};

// Reads a stimulus for a program with these names. Every fault is an error at its token; then
// nothing is given.
std::optional<Stimulus> parse_stimulus(const SourceText& source, const DeviceNames& names,
                                       Diagnostics& diagnostics);

// What a golden trace was given: its `in`. Errors are at the scan's line of the trace.
std::optional<Stimulus> stimulus_of(const Trace& trace, const DeviceNames& names,
                                    const std::string& file, Diagnostics& diagnostics);

}  // namespace rung
