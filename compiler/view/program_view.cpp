// SPDX-License-Identifier: Apache-2.0
#include "view/program_view.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "reference/flow_run.hpp"
#include "rungs/footprint.hpp"
#include "rungs/ports.hpp"

namespace rung::view {
namespace {

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

bool same(std::string_view a, std::string_view b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
           return std::toupper(static_cast<unsigned char>(x)) ==
                  std::toupper(static_cast<unsigned char>(y));
         });
}

// Lines of comment alone between two instructions of a list.
std::string note_between(const std::vector<std::string>& lines, int after, int before) {
  std::string note;
  for (int i = after; i < before - 1 && i < static_cast<int>(lines.size()); ++i) {
    std::string line = trimmed(lines[static_cast<std::size_t>(i)]);
    const bool comment = line.starts_with(";") || line.starts_with("//");
    if (!comment) continue;
    // Without what only draws a line: "; --- belt ---"
    const std::size_t text = line.find_first_not_of(";/-=*# \t");
    if (text == std::string::npos) continue;
    line = line.substr(text, line.find_last_not_of("-=*# \t") - text + 1);
    if (!note.empty()) note += '\n';
    note += line;
  }
  return note;
}

}  // namespace

ProgramView::ProgramView(const Program& program, const std::vector<std::string>& lines, int columns)
    : program_(program), columns_(columns) {
  std::vector<Device> devices = visible_devices(program);
  for (const auto& [device, name] : program.names) {
    if (is_port(device.kind)) devices.push_back(device);
  }
  const auto receives = [](const Instruction& each) { return each.op == Op::UartRecv; };
  if (std::any_of(program.instructions.begin(), program.instructions.end(), receives)) {
    devices.push_back(port::uart_rx_data);
  }
  add_devices(devices);
  draw(lines);
}

ProgramView::ProgramView(const flowchart::Flowchart& chart, const std::vector<std::string>& lines,
                         int columns)
    : program_(chart.ladder), columns_(columns), chart_(&chart) {
  add_devices(visible_devices(chart));
  draw({});
  add_tasks(lines);
}

void ProgramView::add_devices(const std::vector<Device>& devices) {
  for (const Device device : devices) {
    if (is_hidden(device.kind) && !is_port(device.kind)) continue;
    if (by_device_.contains(device)) continue;
    DeviceView view;
    view.device = device;
    view.name = chart_ ? device_name(device, chart_->dialect) : device_name(device, program_);
    const auto comment = program_.comments.find(device);
    if (comment != program_.comments.end()) view.comment = comment->second;
    view.input = device.kind == DeviceKind::X || is_port(device.kind);
    // A channel has the name of the variable that it is read into.
    if (is_port(device.kind)) view.comment = "analogue input";
    if (device == port::uart_rx_data) {
      // A byte arrives once.
      view.input = false;
      view.name = "RX";
      view.comment = "a byte that arrives";
    }
    by_device_[device] = static_cast<int>(devices_.size());
    devices_.push_back(std::move(view));
  }
}

void ProgramView::draw(const std::vector<std::string>& lines) {
  int last_line = 0;
  std::string note;
  for (const Network& network : program_.networks) {
    RungView rung;
    rung.network = network;
    bool drawn = false;
    int first_line = 0, end_line = last_line;
    for (std::size_t i = network.first; i < network.first + network.count; ++i) {
      const Instruction& instruction = program_.instructions[i];
      if (first_line == 0) first_line = instruction.position.line;
      end_line = std::max(end_line, instruction.position.line);
      if (instruction.op == Op::Comment) {
        note += (note.empty() ? "" : "\n") + instruction.note;
      } else if (instruction.op != Op::Nop && instruction.op != Op::Rung) {
        drawn = true;
      }
    }
    const std::string above = note_between(lines, last_line, first_line);
    if (!above.empty()) note += (note.empty() ? "" : "\n") + above;
    last_line = end_line;
    if (!drawn) continue;  // an LDmicro comment stands above the rung that follows
    rung.line = first_line;
    rung.note = std::exchange(note, {});
    rung.grid = grid_of(program_, circuit_of(program_, network), nets_, columns_);
    nets_ = rung.grid.end;
    for (const Placed& each : rung.grid.elements) {
      rung.symbols.push_back(symbol_of(program_.instructions[each.instruction], program_));
    }
    const int number = static_cast<int>(rungs_.size());
    for (std::size_t i = network.first; i < network.first + network.count; ++i) {
      const Instruction& instruction = program_.instructions[i];
      const std::vector<Device> written = written_devices(instruction, program_.dialect);
      for (const Device device : footprint(instruction, program_.dialect)) {
        const int index = find(device);
        if (index < 0) continue;
        DeviceView& view = devices_[static_cast<std::size_t>(index)];
        const bool writes = std::binary_search(written.begin(), written.end(), device);
        std::vector<int>& places = writes ? view.written : view.read;
        if (places.empty() || places.back() != number) places.push_back(number);
      }
    }
    rungs_.push_back(std::move(rung));
  }
}

void ProgramView::add_tasks(const std::vector<std::string>& lines) {
  const auto& steps = chart_->steps;
  for (const flowchart::Task& task : chart_->tasks) tasks_.push_back({task.name, {}});
  std::set<int> heads;  // lines at which a step or a task begins
  for (const flowchart::Step& step : steps) heads.insert(step.position.line);
  for (const flowchart::Task& task : chart_->tasks) heads.insert(task.position.line);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    StepView view;
    view.name = steps[i].name;
    view.next = steps[i].next;
    view.number = i;
    view.added = steps[i].added;
    const auto next = heads.upper_bound(steps[i].position.line);
    const int end = next == heads.end() ? static_cast<int>(lines.size()) + 1 : *next;
    for (int line = steps[i].position.line + (steps[i].added ? 0 : 1); line < end; ++line) {
      const std::string text = trimmed(lines[static_cast<std::size_t>(line - 1)]);
      const std::string code = trimmed(text.substr(0, text.find('#')));
      if (!code.empty()) view.lines.push_back(code);
    }
    tasks_.at(steps[i].task).steps.push_back(std::move(view));
  }
}

int ProgramView::find(Device device) const {
  const auto found = by_device_.find(device);
  return found == by_device_.end() ? -1 : found->second;
}

int ProgramView::find(std::string_view name) const {
  for (const bool exact : {true, false}) {
    for (std::size_t i = 0; i < devices_.size(); ++i) {
      if (exact ? devices_[i].name == name
                : same(devices_[i].name, name) || same(devices_[i].comment, name)) {
        return static_cast<int>(i);
      }
    }
  }
  return -1;
}

std::vector<bool> ProgramView::power(const std::vector<Conduction>& seen) const {
  std::vector<bool> nets(static_cast<std::size_t>(nets_));
  const auto at = [&](Net net) { return nets[static_cast<std::size_t>(net)]; };
  for (const RungView& rung : rungs_) {
    const Conduction& first = seen.at(rung.network.first);
    bool rail = first.executed && first.rail;
    if (program_.dialect == Dialect::Ldmicro) rail = first.conducts;
    // A step ladder's step stands at the rail and gives the power itself.
    if (program_.instructions[rung.network.first].op == Op::Stl) rail = first.executed;
    nets[static_cast<std::size_t>(rung.grid.rail)] = rail;
    for (const PowerStep& step : rung.grid.steps) {
      const bool conducts = seen[step.instruction].conducts;
      bool on = false;
      switch (step.kind) {
        case PowerStep::Kind::Contact:
          on = at(step.from) && conducts;
          break;
        case PowerStep::Kind::Given:
          on = conducts;
          break;
        case PowerStep::Kind::Result:
          on = at(step.base) && conducts;
          break;
        case PowerStep::Kind::Same:
          on = at(step.from);
          break;
        case PowerStep::Kind::Also:
          on = at(step.to) || at(step.from);
          break;
      }
      nets[static_cast<std::size_t>(step.to)] = on;
    }
  }
  return nets;
}

}  // namespace rung::view
