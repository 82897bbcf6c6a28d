// SPDX-License-Identifier: Apache-2.0
// A golden sequence trace: what a controller read, wrote and put out in each scan, as JSON Lines.
//
// The first line is the header, {"rung_trace":1,"program":...,"dialect":...,"tick_ms":...,
// "mpu":...}, of MPU4 with "slots":8,"merged":true, with "comments":{"X0":"start"} where devices
// have names; each other line is one scan,
// {"scan":...,"clocks":...,"in":{...},"writes":[...], "out":{...}}, with "state":{...} and
// "tx":[...] where they are known. Devices stand by their names, so that a trace can be read
// without the program.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/diagnostics.hpp"

namespace rung {

struct TraceHeader {
  std::string program;  // as the user named it
  std::string dialect;
  std::int64_t tick_us = 10000;  // written in milliseconds
  int mpu = 0;                   // 0: the reference
  int slots = 0;                 // of MPU4
  // Of MPU4: compiled with merging, so that writes which nobody can see are missing. A device's
  // last write in a scan that changes its value never is.
  bool merged = false;
  // What a comment file calls the devices that the program names; for people, and not compared.
  std::map<std::string, std::string> comments = {};
  bool operator==(const TraceHeader&) const = default;
  // Both tell of the same processor and the same way to compile: their clocks must be equal.
  bool same_processor(const TraceHeader& other) const {
    return mpu != 0 && mpu == other.mpu && slots == other.slots && merged == other.merged;
  }
};

// A device and a value that it gets or has; bits 0 or 1, words signed.
struct TraceValue {
  std::string device;
  std::int32_t value = 0;
  bool operator==(const TraceValue&) const = default;
};

struct TraceScan {
  int line = 1;  // of the file that it was read from
  std::int64_t scan = 0;
  std::optional<std::int64_t> clocks;  // the reference has none
  std::vector<TraceValue> in;          // inputs that changed, and presets
  std::vector<int> rx;                 // bytes received: "RX" within `in`
  std::vector<TraceValue> writes;      // executed writes, in order
  std::vector<TraceValue> out;         // outputs that changed at the refresh
  std::optional<std::vector<TraceValue>> state;
  std::vector<int> tx;  // bytes sent
};

struct Trace {
  TraceHeader header;
  std::vector<TraceScan> scans;
};

// One line each, without the line end.
std::string to_json(const TraceHeader& header);
std::string to_json(const TraceScan& scan);
// The whole file.
std::string to_json_lines(const Trace& trace);

// Reads a whole trace; `file` is its name for messages. Keys that are not known are skipped. What
// is no trace, or has a damaged line, is refused with an error at the line, column 1.
std::optional<Trace> read_trace(std::string_view bytes, const std::string& file,
                                Diagnostics& diagnostics);

}  // namespace rung
