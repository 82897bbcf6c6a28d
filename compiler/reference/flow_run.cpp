// SPDX-License-Identifier: Apache-2.0
#include "reference/flow_run.hpp"

#include <set>
#include <utility>

#include "rung_flow.hpp"
#include "rungs/footprint.hpp"

namespace rung {

std::vector<Device> visible_devices(const flowchart::Flowchart& chart) {
  std::set<Device> devices;
  const auto add = [&](const Program& program) {
    for (const Device device : visible_devices(program)) {
      if (!is_hidden(device.kind)) devices.insert(device);
    }
  };
  add(chart.ladder);
  for (const flowchart::Step& step : chart.steps) {
    add(step.rungs);
    for (const auto* transfer : {&step.read, &step.write}) {
      if (!*transfer) continue;
      const Device head = (*transfer)->head;
      for (int i = 0; i < (*transfer)->count; ++i) {
        devices.insert({head.kind, head.number + static_cast<std::uint32_t>(i)});
      }
    }
  }
  return {devices.begin(), devices.end()};
}

FlowRun::FlowRun(const flowchart::Flowchart& chart, bool with_state, std::int64_t tick_us,
                 std::string config)
    : chart_(chart),
      names_(chart.dialect),
      tick_us_(tick_us),
      rounds_(chart, tick_us, std::move(config)),
      recorder_(with_state) {
  for (const Device device : visible_devices(chart)) {
    devices_.push_back({device, names_.name(device)});
  }
}

TraceHeader FlowRun::header() const {
  TraceHeader header{chart_.file, std::string(dialect_name(chart_.dialect)), tick_us_, 0};
  for (const NamedDevice& each : devices_) {
    const auto comment = chart_.ladder.comments.find(each.device);
    if (comment != chart_.ladder.comments.end()) header.comments[each.name] = comment->second;
  }
  return header;
}

TraceScan FlowRun::scan(std::span<const StimulusEvent> events) {
  while (!rounds_.requests().empty()) {
    rounds_.complete(rounds_.requests().front().id, flow::flow_status_no_reply);
    ++without_answer_;
  }
  for (const StimulusEvent& event : events) {
    rounds_.set(event.device, event.value);
    recorder_.event(event, names_);
  }
  rounds_.run_round();
  for (const FlowWrite& write : rounds_.writes()) {
    recorder_.write(names_.name(write.device), write.value);
  }
  for (const NamedDevice& each : devices_) {
    const std::int16_t value = rounds_.get(each.device);
    if (each.device.kind == DeviceKind::Y) recorder_.output(each.name, value);
    recorder_.state(each.name, value);
  }
  return recorder_.finish(std::nullopt);
}

}  // namespace rung
