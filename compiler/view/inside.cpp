// SPDX-License-Identifier: Apache-2.0
// A recording as JSON. Most of it is numbers, so each clock is an array: the steps in its stages,
// then one array a slot (page/inside.js reads them).
#include "view/frame.hpp"

namespace rung::view {
namespace {

using nlohmann::json;

json slot_json(const RecordedSlot& slot) {
  if (!slot.completes) return nullptr;
  std::string forwarded;
  for (const Forwarded& each : slot.forwarded) {
    forwarded += each.operand;
    forwarded += static_cast<char>('0' + each.distance);
  }
  json result = {slot.exc_before ? 1 : 0,
                 slot.exc_after ? 1 : 0,
                 slot.function,
                 slot.operands,
                 slot.s1,
                 slot.s2,
                 forwarded};
  if (!slot.written.empty()) {
    result.push_back(slot.written);
    result.push_back(slot.value);
  }
  return result;
}

}  // namespace

nlohmann::json code_json(const Run& run) {
  json processors = json::array();
  for (const RecordedProcessor& each : run.engine().recordings()) {
    json code = json::array();
    for (const auto& step : each.code) {
      json slots = json::array();
      for (const RecordedCode& slot : step) slots.push_back({slot.text, slot.origin, slot.row});
      code.push_back(slots);
    }
    processors.push_back({{"mpu", each.mpu}, {"code", code}});
  }
  return {{"run", run.runs()}, {"processors", processors}};
}

nlohmann::json recording_json(const Run& run) {
  json processors = json::array();
  for (const RecordedProcessor& each : run.engine().recordings()) {
    json clocks = json::array();
    for (const RecordedClock& clock : each.clocks) {
      json slots = json::array();
      for (const RecordedSlot& slot : clock.slots) slots.push_back(slot_json(slot));
      clocks.push_back({clock.steps, slots});
    }
    processors.push_back(clocks);
  }
  return {{"run", run.runs()}, {"scan", run.scans()}, {"clocks", processors}};
}

}  // namespace rung::view
