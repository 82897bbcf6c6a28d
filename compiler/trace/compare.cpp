// SPDX-License-Identifier: Apache-2.0
#include "trace/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace rung {
namespace {

constexpr std::string_view kNothing = "nothing";

using Values = std::map<std::string, std::int32_t>;
using Sequences = std::map<std::string, std::vector<std::int32_t>>;

std::int32_t value_of(const Values& values, const std::string& device) {
  const auto found = values.find(device);
  return found == values.end() ? 0 : found->second;
}

// Takes over what changed on both sides, then compares those devices.
std::optional<TraceDifference> compare_values(std::int64_t scan, TraceAspect aspect,
                                              const std::vector<TraceValue>& expected,
                                              const std::vector<TraceValue>& got,
                                              Values& expected_values, Values& got_values) {
  for (const TraceValue& each : expected) expected_values[each.device] = each.value;
  for (const TraceValue& each : got) got_values[each.device] = each.value;
  for (const auto* side : {&expected, &got}) {
    for (const TraceValue& each : *side) {
      const std::int32_t want = value_of(expected_values, each.device);
      const std::int32_t have = value_of(got_values, each.device);
      if (want != have) {
        return TraceDifference{scan, aspect, each.device, fmt::to_string(want),
                               fmt::to_string(have)};
      }
    }
  }
  return std::nullopt;
}

// The writes that change a value, by device.
Sequences changes(const TraceScan& scan, Values& values) {
  for (const TraceValue& preset : scan.in) values[preset.device] = preset.value;
  Sequences sequences;
  for (const TraceValue& write : scan.writes) {
    std::int32_t& value = values[write.device];
    if (value == write.value) continue;
    value = write.value;
    sequences[write.device].push_back(write.value);
  }
  return sequences;
}

std::string at(const Sequences& sequences, const std::string& device, std::size_t index) {
  const auto found = sequences.find(device);
  if (found == sequences.end() || index >= found->second.size()) return std::string(kNothing);
  return fmt::to_string(found->second[index]);
}

std::optional<TraceDifference> compare_writes(const TraceScan& expected, const TraceScan& got,
                                              Values& expected_values, Values& got_values) {
  const Sequences want = changes(expected, expected_values);
  const Sequences have = changes(got, got_values);
  // In the order of the expected writes, so that the difference shown is the earliest cause.
  std::map<std::string, bool> seen;
  for (const auto* writes : {&expected.writes, &got.writes}) {
    for (const TraceValue& write : *writes) {
      if (std::exchange(seen[write.device], true)) continue;
      for (std::size_t i = 0;; ++i) {
        const std::string wanted = at(want, write.device, i);
        const std::string had = at(have, write.device, i);
        if (wanted != had) {
          return TraceDifference{expected.scan, TraceAspect::Write, write.device, wanted, had};
        }
        if (wanted == kNothing) break;
      }
    }
  }
  return std::nullopt;
}

// What the writes leave behind, whether or not all of them are there.
std::optional<TraceDifference> compare_ends(const TraceScan& expected, const TraceScan& got,
                                            Values& expected_values, Values& got_values) {
  for (const TraceValue& preset : expected.in) expected_values[preset.device] = preset.value;
  for (const TraceValue& preset : got.in) got_values[preset.device] = preset.value;
  return compare_values(expected.scan, TraceAspect::Write, expected.writes, got.writes,
                        expected_values, got_values);
}

std::optional<TraceDifference> compare_states(const TraceScan& expected, const TraceScan& got) {
  if (!expected.state || !got.state || *expected.state == *got.state) return std::nullopt;
  const auto find = [](const std::vector<TraceValue>& state, const std::string& device) {
    const auto found = std::find_if(state.begin(), state.end(),
                                    [&](const TraceValue& v) { return v.device == device; });
    return found == state.end() ? std::string(kNothing) : fmt::to_string(found->value);
  };
  // Only a difference of order or of a value comes this far.
  for (const TraceValue& each : *expected.state) {
    const std::string have = find(*got.state, each.device);
    if (have != fmt::to_string(each.value)) {
      return TraceDifference{expected.scan, TraceAspect::State, each.device,
                             fmt::to_string(each.value), have};
    }
  }
  for (const TraceValue& each : *got.state) {
    if (find(*expected.state, each.device) == kNothing) {
      return TraceDifference{expected.scan, TraceAspect::State, each.device, std::string(kNothing),
                             fmt::to_string(each.value)};
    }
  }
  return std::nullopt;
}

std::optional<TraceDifference> compare_bytes(std::int64_t scan, TraceAspect aspect,
                                             const std::vector<int>& expected,
                                             const std::vector<int>& got) {
  if (expected == got) return std::nullopt;
  return TraceDifference{scan,
                         aspect,
                         {},
                         fmt::format("[{}]", fmt::join(expected, " ")),
                         fmt::format("[{}]", fmt::join(got, " "))};
}

std::string_view aspect_name(TraceAspect aspect) {
  switch (aspect) {
    case TraceAspect::Input:
      return "input";
    case TraceAspect::Write:
      return "write of";
    case TraceAspect::Output:
      return "output";
    case TraceAspect::State:
      return "state of";
    case TraceAspect::Received:
      return "bytes received";
    case TraceAspect::Sent:
      return "bytes sent";
    case TraceAspect::Clocks:
      return "clocks";
    case TraceAspect::Scans:
      break;
  }
  return "end of the trace";
}

}  // namespace

std::string describe(const TraceDifference& difference) {
  return fmt::format("scan {}: {}{}{}: expected {}, got {}", difference.scan,
                     aspect_name(difference.aspect), difference.device.empty() ? "" : " ",
                     difference.device, difference.expected, difference.got);
}

std::optional<TraceDifference> TraceComparison::next(const TraceScan& expected,
                                                     const TraceScan& got) {
  const std::int64_t scan = expected.scan;
  if (auto found = compare_values(scan, TraceAspect::Input, expected.in, got.in, inputs_.first,
                                  inputs_.second)) {
    return found;
  }
  if (auto found = compare_bytes(scan, TraceAspect::Received, expected.rx, got.rx)) return found;
  if (auto found = merged_ ? compare_ends(expected, got, devices_.first, devices_.second)
                           : compare_writes(expected, got, devices_.first, devices_.second)) {
    return found;
  }
  if (auto found = compare_values(scan, TraceAspect::Output, expected.out, got.out, outputs_.first,
                                  outputs_.second)) {
    return found;
  }
  if (auto found = compare_states(expected, got)) return found;
  if (auto found = compare_bytes(scan, TraceAspect::Sent, expected.tx, got.tx)) return found;
  if (clocks_ && expected.clocks && got.clocks && *expected.clocks != *got.clocks) {
    return TraceDifference{scan,
                           TraceAspect::Clocks,
                           {},
                           fmt::to_string(*expected.clocks),
                           fmt::to_string(*got.clocks)};
  }
  return std::nullopt;
}

std::optional<TraceDifference> compare_traces(const Trace& expected, const Trace& got) {
  TraceComparison comparison(expected.header.same_processor(got.header),
                             expected.header.merged || got.header.merged);
  const std::size_t both = std::min(expected.scans.size(), got.scans.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (auto found = comparison.next(expected.scans[i], got.scans[i])) return found;
  }
  if (expected.scans.size() == got.scans.size()) return std::nullopt;
  return TraceDifference{static_cast<std::int64_t>(both),
                         TraceAspect::Scans,
                         {},
                         fmt::format("{} scans", expected.scans.size()),
                         fmt::format("{} scans", got.scans.size())};
}

}  // namespace rung
