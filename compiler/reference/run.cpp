// SPDX-License-Identifier: Apache-2.0
#include "reference/run.hpp"

namespace rung {

ReferenceRun::ReferenceRun(const Program& program, bool with_state, std::int64_t tick_us)
    : program_(program),
      names_(program),
      tick_us_(program.ldmicro ? program.ldmicro->cycle_us : tick_us),
      reference_(program, tick_us_),
      recorder_(with_state) {
  for (const Device device : visible_devices(program)) {
    devices_.push_back({device, names_.name(device)});
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
    recorder_.event(event, names_);
  }
  reference_.run_scan();
  for (const ReferenceWrite& write : reference_.writes()) {
    recorder_.write(names_.name(write.device), write.value);
  }
  for (const NamedDevice& each : devices_) {
    const std::int16_t value = reference_.get(each.device);
    if (each.device.kind == DeviceKind::Y) recorder_.output(each.name, value);
    recorder_.state(each.name, value);
  }
  for (const int byte : reference_.sent()) recorder_.sent(byte);
  return recorder_.finish(std::nullopt);
}

}  // namespace rung
