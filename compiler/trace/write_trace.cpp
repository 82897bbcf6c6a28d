// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "trace/trace.hpp"

namespace rung {
namespace {

using Json = nlohmann::ordered_json;

Json to_object(const std::vector<TraceValue>& values) {
  Json object = Json::object();
  for (const TraceValue& value : values) object[value.device] = value.value;
  return object;
}

// Names come from files and need not be valid UTF-8 when they are a file's own name.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string to_json(const TraceHeader& header) {
  Json json;
  json["rung_trace"] = 1;
  json["program"] = header.program;
  json["dialect"] = header.dialect;
  if (header.tick_us % 1000 == 0) {
    json["tick_ms"] = header.tick_us / 1000;
  } else {
    json["tick_ms"] = static_cast<double>(header.tick_us) / 1000.0;
  }
  json["mpu"] = header.mpu;
  if (header.slots != 0) {
    json["slots"] = header.slots;
    json["merged"] = header.merged;
  }
  if (!header.comments.empty()) json["comments"] = header.comments;
  return dump(json);
}

std::string to_json(const TraceScan& scan) {
  Json json;
  json["scan"] = scan.scan;
  json["clocks"] = scan.clocks ? Json(*scan.clocks) : Json(nullptr);
  json["in"] = to_object(scan.in);
  if (!scan.rx.empty()) json["in"]["RX"] = scan.rx;
  Json writes = Json::array();
  for (const TraceValue& write : scan.writes) {
    writes.push_back(Json::array({write.device, write.value}));
  }
  json["writes"] = std::move(writes);
  json["out"] = to_object(scan.out);
  if (scan.state) json["state"] = to_object(*scan.state);
  if (!scan.tx.empty()) json["tx"] = scan.tx;
  return dump(json);
}

std::string to_json_lines(const Trace& trace) {
  std::string text = to_json(trace.header) + '\n';
  for (const TraceScan& scan : trace.scans) text += to_json(scan) + '\n';
  return text;
}

}  // namespace rung
