// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "trace/trace.hpp"

namespace rung {
namespace {

using Json = nlohmann::ordered_json;

// What is wrong with one line; becomes a diagnostic at that line.
struct BadLine : std::runtime_error {
  using std::runtime_error::runtime_error;
};

const Json& member(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw BadLine(fmt::format("it has no \"{}\"", key));
  return *found;
}

std::string text(const Json& json, const char* key) {
  const Json& value = member(json, key);
  if (!value.is_string()) throw BadLine(fmt::format("\"{}\" is not a text", key));
  return value.get<std::string>();
}

std::int64_t integer(const Json& json, std::string_view what, std::int64_t least,
                     std::int64_t most) {
  if (!json.is_number_integer()) throw BadLine(fmt::format("{} is not an integer", what));
  const bool beyond = json.is_number_unsigned() &&
                      json.get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX);
  const std::int64_t value = beyond ? INT64_MAX : json.get<std::int64_t>();
  if (beyond || value < least || value > most) {
    throw BadLine(fmt::format("{} is not between {} and {}", what, least, most));
  }
  return value;
}

TraceValue trace_value(const std::string& device, const Json& value) {
  if (device.empty()) throw BadLine("a device has an empty name");
  return {device, static_cast<std::int32_t>(integer(value, fmt::format("the value of {}", device),
                                                    std::numeric_limits<std::int32_t>::min(),
                                                    std::numeric_limits<std::int32_t>::max()))};
}

std::vector<TraceValue> values(const Json& object, std::string_view what) {
  if (!object.is_object()) throw BadLine(fmt::format("\"{}\" is not an object", what));
  std::vector<TraceValue> all;
  for (const auto& [device, value] : object.items()) all.push_back(trace_value(device, value));
  return all;
}

std::vector<int> byte_list(const Json& json, std::string_view what) {
  if (!json.is_array()) throw BadLine(fmt::format("\"{}\" is not a list of bytes", what));
  std::vector<int> all;
  for (const Json& each : json) {
    all.push_back(static_cast<int>(integer(each, fmt::format("a byte of \"{}\"", what), 0, 255)));
  }
  return all;
}

Json parse_line(std::string_view line) {
  Json json;
  try {
    json = Json::parse(line);
  } catch (const Json::parse_error& failure) {
    throw BadLine(fmt::format("not JSON at its character {}", failure.byte));
  } catch (const Json::out_of_range&) {
    // 1e999: the parser's other fault.
    throw BadLine("a number that nothing can hold");
  }
  if (!json.is_object()) throw BadLine("not a JSON object");
  return json;
}

TraceHeader parse_header(std::string_view line) {
  const Json json = parse_line(line);
  if (json.find("rung_trace") == json.end()) {
    throw BadLine("this is no trace: its first line has no \"rung_trace\"");
  }
  if (json["rung_trace"] != 1) throw BadLine("this trace has another version than 1");
  TraceHeader header;
  header.program = text(json, "program");
  header.dialect = text(json, "dialect");
  const Json& tick = member(json, "tick_ms");
  if (!tick.is_number()) throw BadLine("\"tick_ms\" is not a number");
  const double microseconds = tick.get<double>() * 1000.0;
  if (!(microseconds >= 0 && microseconds <= 9e15)) throw BadLine("\"tick_ms\" is out of range");
  header.tick_us = std::llround(microseconds);
  header.mpu = static_cast<int>(integer(member(json, "mpu"), "\"mpu\"", 0, 4));
  if (const auto slots = json.find("slots"); slots != json.end()) {
    header.slots = static_cast<int>(integer(*slots, "\"slots\"", 0, 1 << 16));
  }
  if (const auto merged = json.find("merged"); merged != json.end()) {
    if (!merged->is_boolean()) throw BadLine("\"merged\" is neither true nor false");
    header.merged = merged->get<bool>();
  }
  return header;
}

TraceScan parse_scan(std::string_view line, std::int64_t expected) {
  Json json = parse_line(line);
  TraceScan scan;
  scan.scan =
      integer(member(json, "scan"), "\"scan\"", 0, std::numeric_limits<std::int64_t>::max());
  if (scan.scan != expected) {
    throw BadLine(fmt::format("it holds scan {} where scan {} should be", scan.scan, expected));
  }
  const auto clocks = json.find("clocks");
  if (clocks != json.end() && !clocks->is_null()) {
    scan.clocks = integer(*clocks, "\"clocks\"", 0, std::numeric_limits<std::int64_t>::max());
  }
  Json in = member(json, "in");
  if (in.is_object() && in.contains("RX")) {
    scan.rx = byte_list(in["RX"], "RX");
    in.erase("RX");
  }
  scan.in = values(in, "in");
  const Json& writes = member(json, "writes");
  if (!writes.is_array()) throw BadLine("\"writes\" is not a list");
  for (const Json& write : writes) {
    if (!write.is_array() || write.size() != 2 || !write[0].is_string()) {
      throw BadLine("a write is not a pair of device and value");
    }
    scan.writes.push_back(trace_value(write[0].get<std::string>(), write[1]));
  }
  scan.out = values(member(json, "out"), "out");
  if (json.contains("state")) scan.state = values(json["state"], "state");
  if (json.contains("tx")) scan.tx = byte_list(json["tx"], "tx");
  return scan;
}

}  // namespace

std::optional<Trace> read_trace(std::string_view bytes, const std::string& file,
                                Diagnostics& diagnostics) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  Trace trace;
  bool has_header = false;
  int number = 0;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    try {
      if (has_header) {
        trace.scans.push_back(parse_scan(line, static_cast<std::int64_t>(trace.scans.size())));
        trace.scans.back().line = number;
      } else {
        trace.header = parse_header(line);
        has_header = true;
      }
    } catch (const BadLine& failure) {
      // The lines after a bad one would only report that their numbers do not follow.
      diagnostics.error(file, {number, 1}, failure.what());
      return std::nullopt;
    }
  }
  if (!has_header) {
    diagnostics.error(file, {}, "this is no trace: it is empty");
    return std::nullopt;
  }
  return trace;
}

}  // namespace rung
