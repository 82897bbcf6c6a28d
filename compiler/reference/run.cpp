// SPDX-License-Identifier: Apache-2.0
#include "reference/run.hpp"

namespace rung {

ReferenceRun::ReferenceRun(const Program& program, bool with_state, std::int64_t tick_us)
    : program_(program), tick_us_(tick_us), reference_(program, tick_us), recorder_(with_state) {
  for (const Device device : visible_devices(program)) {
    devices_.push_back({device, device_name(device, program.dialect)});
  }
}

TraceHeader ReferenceRun::header() const {
  TraceHeader header{program_.file, std::string(dialect_name(program_.dialect)), tick_us_, 0};
  for (const NamedDevice& each : devices_) {
    const auto comment = program_.comments.find(each.device);
    if (comment != program_.comments.end()) header.comments[each.name] = comment->second;
  }
  return header;
}

TraceScan ReferenceRun::scan(std::span<const StimulusEvent> events) {
  for (const StimulusEvent& event : events) {
    reference_.set(event.device, event.value);
    const std::string name = device_name(event.device, program_.dialect);
    if (is_input(event.device)) {
      recorder_.input(name, event.value);
    } else {
      recorder_.preset(name, event.value);
    }
  }
  reference_.run_scan();
  for (const ReferenceWrite& write : reference_.writes()) {
    recorder_.write(device_name(write.device, program_.dialect), write.value);
  }
  for (const NamedDevice& each : devices_) {
    const std::int16_t value = reference_.get(each.device);
    if (each.device.kind == DeviceKind::Y) recorder_.output(each.name, value);
    recorder_.state(each.name, value);
  }
  return recorder_.finish(std::nullopt);
}

}  // namespace rung
