// SPDX-License-Identifier: Apache-2.0
#include "view/frame.hpp"

namespace rung::view {
namespace {

using nlohmann::json;

// Bits, the first one lowest in the first byte, in base 64.
std::string packed(std::size_t count, const std::function<bool(std::size_t)>& bit) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < count; at += 24) {
    std::uint32_t bytes = 0;  // three, the first one highest
    for (std::size_t i = 0; i < 24 && at + i < count; ++i) {
      if (bit(at + i)) bytes |= 1U << (16 - 8 * (i / 8) + i % 8);
    }
    for (int shift = 18; shift >= 0; shift -= 6) text += kDigits[bytes >> shift & 63];
  }
  return text;
}

json element_json(const RungView& rung, std::size_t i, const ProgramView& view) {
  const Placed& placed = rung.grid.elements[i];
  const Symbol& symbol = rung.symbols[i];
  json devices = json::array();
  for (const Device device : symbol.devices) {
    const int index = view.find(device);
    if (index >= 0) devices.push_back(index);
  }
  return {{"r", placed.row},         {"c", placed.column},
          {"w", placed.width},       {"s", sign_name(symbol.sign)},
          {"t", symbol.text},        {"d", devices},
          {"i", placed.instruction}, {"in", placed.in},
          {"out", placed.out}};
}

json rung_json(const RungView& rung, const ProgramView& view) {
  json elements = json::array();
  for (std::size_t i = 0; i < rung.symbols.size(); ++i) {
    elements.push_back(element_json(rung, i, view));
  }
  json wires = json::array();
  for (const Wire& each : rung.grid.wires) {
    wires.push_back({each.row, each.from, each.to, each.net});
  }
  json uprights = json::array();
  for (const Upright& each : rung.grid.uprights) {
    uprights.push_back({each.column, each.from, each.to, each.net});
  }
  json turns = json::array();
  for (const Turn& each : rung.grid.turns) {
    turns.push_back({each.number, each.from_row, each.from_column, each.to_row, each.net});
  }
  json list = json::array();
  for (std::size_t i = rung.network.first; i < rung.network.first + rung.network.count; ++i) {
    list.push_back(view.program().instructions[i].text);
  }
  return {{"rows", rung.grid.rows},
          {"columns", rung.grid.columns},
          {"rail", rung.grid.rail},
          {"e", elements},
          {"w", wires},
          {"u", uprights},
          {"turns", turns},
          {"note", rung.note},
          {"line", rung.line},
          {"first", rung.network.first},
          {"list", list}};
}

json tasks_json(const ProgramView& view) {
  json tasks = json::array();
  for (const TaskView& task : view.tasks()) {
    json steps = json::array();
    for (const StepView& step : task.steps) {
      steps.push_back({{"name", step.name},
                       {"lines", step.lines},
                       {"next", step.next},
                       {"number", step.number},
                       {"added", step.added}});
    }
    tasks.push_back({{"name", task.name}, {"steps", steps}});
  }
  return tasks;
}

std::string_view mode_name(Mode mode) {
  switch (mode) {
    case Mode::Paused:
      return "paused";
    case Mode::RealTime:
      return "real";
    case Mode::Fast:
      return "fast";
  }
  return "";
}

std::string_view state_name(FlowState state) {
  switch (state) {
    case FlowState::Fetch:
      return "fetch";
    case FlowState::Load:
      return "load";
    case FlowState::Store:
      return "store";
    case FlowState::Pause:
      return "pause";
  }
  return "";
}

}  // namespace

json model_json(Run& run) {
  const ProgramView& view = run.view();
  json rungs = json::array();
  for (const RungView& rung : view.rungs()) rungs.push_back(rung_json(rung, view));
  json devices = json::array();
  for (const DeviceView& each : view.devices()) {
    devices.push_back({{"name", each.name},
                       {"comment", each.comment},
                       {"word", is_word(each.device)},
                       {"input", each.input},
                       {"output", each.device.kind == DeviceKind::Y},
                       {"read", each.read},
                       {"written", each.written}});
  }
  return {{"file", view.chart() ? view.chart()->file : view.program().file},
          {"dialect", dialect_name(view.chart() ? view.chart()->dialect : view.program().dialect)},
          {"engines", run.engines()},
          {"live", run.engine().is_live()},
          {"tick_us", run.engine().tick_us()},
          {"nets", view.nets()},
          {"rungs", rungs},
          {"devices", devices},
          {"tasks", tasks_json(view)}};
}

std::optional<json> frame_json(Run& run, FrameState& state) {
  if (state.runs == run.runs() && state.version == run.version()) return std::nullopt;
  const std::uint64_t since = state.runs == run.runs() ? state.version : 0;
  state = {run.runs(), run.version()};
  json values = json::array();  // device, value, device, value ...
  for (std::size_t i = 0; i < run.values().size(); ++i) {
    if (run.versions()[i] <= since) continue;
    values.push_back(i);
    values.push_back(run.values()[i]);
  }
  const auto& seen = run.engine().seen();
  json forced = json::array();
  for (const auto& [device, value] : run.forced()) forced.push_back({device, value});
  json breakpoints = json::array();
  for (const auto& [device, each] : run.breakpoints()) {
    breakpoints.push_back({device, each.value ? json(*each.value) : json()});
  }
  json frame = {
      {"run", run.runs()},
      {"scan", run.scans()},
      {"mode", mode_name(run.mode())},
      {"engine", run.engine().name()},
      {"values", values},
      {"power", packed(run.power().size(), [&](std::size_t i) { return run.power()[i]; })},
      {"closed", packed(seen.size(), [&](std::size_t i) { return seen[i].conducts; })},
      {"forced", forced},
      {"breaks", breakpoints},
      {"sent", run.sent()},
      {"message", run.message()},
      {"failed", run.failed()}};
  if (run.engine().clocks()) frame["clocks"] = *run.engine().clocks();
  if (run.engine().is_live()) frame["state"] = run.engine().state();
  json tasks = json::array();
  for (std::size_t i = 0; i < run.view().tasks().size(); ++i) {
    const auto task = run.engine().task(i);
    if (!task) break;
    tasks.push_back({{"on", task->started},
                     {"waits", task->waits},
                     {"state", state_name(task->state)},
                     {"step", task->step}});
  }
  if (!tasks.empty()) frame["tasks"] = tasks;
  return frame;
}

}  // namespace rung::view
