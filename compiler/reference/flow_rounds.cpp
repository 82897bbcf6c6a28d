// SPDX-License-Identifier: Apache-2.0
#include "reference/flow_rounds.hpp"

#include <algorithm>
#include <utility>

#include "rung_controller.hpp"
#include "rung_flow.hpp"
#include "rungs/devices.hpp"

namespace rung {

using flowchart::Step;
using flowchart::Transfer;

FlowRounds::FlowRounds(const flowchart::Flowchart& chart, std::int64_t tick_us, std::string config)
    : chart_(chart),
      config_(std::move(config)),
      ladder_(chart.ladder, tick_us),
      steps_(chart.steps.size()),
      breaks_(chart.steps.size()),
      tasks_(chart.tasks.size()),
      free_blocks_(flow::flow_task_blocks),
      began_(chart.tasks.empty() ? 0 : chart.tasks.size() - 1),
      time_{-1, tick_us} {
  for (std::size_t i = 0; i < tasks_.size(); ++i) {
    if (chart.tasks[i].starts) start(i);
  }
}

void FlowRounds::run_round() {
  begin_round();
  while (turn()) {
  }
  end_round();
}

void FlowRounds::begin_round() {
  ++time_.scan;
  ladder_.begin_scan();
  writes_.clear();
  first_ = tasks_.empty() ? 0 : (began_ + 1) % tasks_.size();
  passed_ = 0;
  any_turn_ = false;
  short_before_ = std::exchange(short_, false);
}

std::optional<std::size_t> FlowRounds::turn() {
  while (passed_ < tasks_.size()) {
    const std::size_t task = (first_ + passed_++) % tasks_.size();
    if (!is_ready(task)) continue;
    if (!any_turn_) began_ = task;
    any_turn_ = true;
    take_turn(task);
    return task;
  }
  return std::nullopt;
}

void FlowRounds::end_round() {
  count_time();
  while (ladder_.step()) {
  }
  for (const ReferenceWrite& each : ladder_.writes()) {
    writes_.push_back({each.device, each.value, std::nullopt});
  }
}

void FlowRounds::count_time() {
  for (const auto& [clock, base_us] : {std::pair{flowchart::kMilliseconds, std::int64_t{1000}},
                                       std::pair{flowchart::kTenths, std::int64_t{100'000}}}) {
    set(clock, static_cast<std::int16_t>(get(clock) + ticks_since_last(base_us, time_)));
  }
}

// ---- tasks --------------------------------------------------------------------------------------

FlowTaskState FlowRounds::task(std::size_t number) const {
  const TaskRow& row = tasks_.at(number);
  return {row.paused ? FlowState::Pause : row.state, row.started, row.waits, row.step};
}

void FlowRounds::pause(std::size_t task) {
  TaskRow& row = tasks_.at(task);
  row.asked = row.started && !row.paused;
}

void FlowRounds::go_on(std::size_t task) {
  TaskRow& row = tasks_.at(task);
  row.passes = row.paused;
  row.paused = row.asked = false;
}

bool FlowRounds::is_ready(std::size_t task) const {
  const TaskRow& row = tasks_[task];
  return row.started && !row.waits && !row.paused;
}

void FlowRounds::start(std::size_t task) {
  if (tasks_[task].started) return;
  tasks_[task] = {};
  tasks_[task].started = true;
  tasks_[task].step = chart_.tasks[task].first;
}

void FlowRounds::stop(std::size_t task) {
  TaskRow& row = tasks_[task];
  if (row.waits) {
    // The block and its boards are held until the answer comes, and vanishes.
    std::vector<std::size_t>& boards = orphans_[row.request];
    for (auto each = holders_.begin(); each != holders_.end();) {
      if (each->second == task) {
        boards.push_back(each->first);
        each = holders_.erase(each);
      } else {
        ++each;
      }
    }
  } else {
    free_block(task);
  }
  row = {};
}

void FlowRounds::free_block(std::size_t task) {
  if (!std::exchange(tasks_[task].has_block, false)) return;
  ++free_blocks_;
  std::erase_if(holders_, [&](const auto& each) { return each.second == task; });
}

// ---- a turn -------------------------------------------------------------------------------------

void FlowRounds::take_turn(std::size_t task) {
  TaskRow& row = tasks_[task];
  if (row.state == FlowState::Load) {
    const Transfer& read = *chart_.steps[row.step].read;
    row.state = FlowState::Fetch;
    for (std::size_t i = 0; i < row.words.size(); ++i) {
      write(task, {read.head.kind, read.head.number + static_cast<std::uint32_t>(i)}, row.words[i]);
    }
    row.words.clear();
    return run_step(task);
  }
  const bool answered = row.state == FlowState::Store;
  if (answered) {
    free_block(task);
    row.state = FlowState::Fetch;
    row.step = row.next;
    if (row.ends) {
      row = {};
      return;
    }
  }
  fetch(task, answered);
}

void FlowRounds::fetch(std::size_t task, bool answered) {
  TaskRow& row = tasks_[task];
  if ((breaks_[row.step] || row.asked) && !row.passes) {
    row.paused = true;
    row.asked = false;
    return;
  }
  const Step& step = chart_.steps[row.step];
  if (!can_begin(step, answered)) return;
  row.passes = false;
  if (way(step.read) == Way::Line || way(step.write) == Way::Line) {
    --free_blocks_;
    row.has_block = true;
    for (const auto& transfer : {step.read, step.write}) {
      if (transfer && chart_.boards[transfer->board].exclusive) holders_[transfer->board] = task;
    }
  }
  switch (way(step.read)) {
    case Way::None:
      break;
    case Way::Line:
      row.state = FlowState::Load;
      return send(task, false, *step.read);
    case Way::Own:
      read_own(task, *step.read);
      row.status = flow::flow_status_done;
      row.status_due = true;
      break;
    case Way::Refused:
      ++counters_.failed;
      row.status = flow::flow_status_refused;
      row.status_due = true;
      break;
  }
  run_step(task);
}

bool FlowRounds::can_begin(const Step& step, bool answered) {
  for (const auto& transfer : {step.read, step.write}) {
    if (!transfer || !chart_.boards[transfer->board].exclusive) continue;
    const std::size_t board = transfer->board;
    const bool held = holders_.contains(board) ||
                      std::any_of(orphans_.begin(), orphans_.end(), [&](const auto& orphan) {
                        return std::find(orphan.second.begin(), orphan.second.end(), board) !=
                               orphan.second.end();
                      });
    if (!held) continue;
    ++counters_.held;
    short_ = true;
    return false;
  }
  const bool needs_block = way(step.read) == Way::Line || way(step.write) == Way::Line;
  const bool gives_way = answered && (short_ || short_before_);
  if (!needs_block || (free_blocks_ > 0 && !gives_way)) return true;
  if (free_blocks_ == 0) short_ = true;
  ++counters_.pool_full;
  return false;
}

void FlowRounds::run_step(std::size_t task) {
  TaskRow& row = tasks_[task];
  if (std::exchange(row.status_due, false)) {
    set(flowchart::kStatus, static_cast<std::int16_t>(row.status));
  }
  std::unique_ptr<Reference>& routine = steps_[row.step];
  const Step& step = chart_.steps[row.step];
  if (!routine) routine = std::make_unique<Reference>(step.rungs, ladder_);
  routine->run_scan();
  if (!obey(task)) return;
  if (step.write) return store(task);
  finish_step(task);
}

bool FlowRounds::obey(std::size_t task) {
  TaskRow& row = tasks_[task];
  row.next = row.step;
  row.ends = false;
  const std::vector<ReferenceWrite>& all = steps_[row.step]->writes();
  bool stays = true;
  for (const ReferenceWrite& each : all) {
    if (!is_hidden(each.device.kind)) writes_.push_back({each.device, each.value, task});
    if (each.device != flowchart::kNextStep) continue;
    row.ends = each.value == flowchart::kTaskEnds;
    row.next = row.ends ? row.step : static_cast<std::size_t>(each.value);
  }
  for (const ReferenceWrite& each : all) {
    if (each.device != flowchart::kTaskCommand) continue;
    const bool starts = each.value >= flowchart::kStart;
    const auto other =
        static_cast<std::size_t>(starts ? each.value - flowchart::kStart : each.value);
    if (starts) {
      start(other);
    } else {
      stop(other);
      stays = stays && other != task;
    }
  }
  return stays;
}

void FlowRounds::store(std::size_t task) {
  TaskRow& row = tasks_[task];
  const Transfer& transfer = *chart_.steps[row.step].write;
  switch (way(transfer)) {
    case Way::Line:
      row.state = FlowState::Store;
      return send(task, true, transfer);
    case Way::Own:
      write_own(task, transfer);
      row.status = flow::flow_status_done;
      break;
    default:
      ++counters_.failed;
      row.status = flow::flow_status_refused;
  }
  row.status_due = true;
  finish_step(task);
}

void FlowRounds::finish_step(std::size_t task) {
  TaskRow& row = tasks_[task];
  free_block(task);
  row.step = row.next;
  if (row.ends) row = {};
}

// ---- transfers ----------------------------------------------------------------------------------

FlowRounds::Way FlowRounds::way(const std::optional<Transfer>& transfer) const {
  if (!transfer) return Way::None;
  if (chart_.boards[transfer->board].over_link) return Way::Line;
  for (int i = 0; i < transfer->count; ++i) {
    if (!variable(transfer->first + i)) return Way::Refused;
  }
  return Way::Own;
}

std::optional<Device> FlowRounds::variable(int number) const {
  for (const controller::Area& area : controller::areas) {
    const int offset = number - area.index;
    if (area.config != config_ || !is_word(area.kind) || offset < 0 || offset >= area.count) {
      continue;
    }
    const int n = area.number + (area.pairs ? offset / 2 : offset);
    const bool high = area.pairs && offset % 2 != 0;
    return Device{high ? DeviceKind::CNH : area.kind, static_cast<std::uint32_t>(n)};
  }
  return std::nullopt;
}

void FlowRounds::read_own(std::size_t task, const Transfer& transfer) {
  std::vector<std::int16_t> words;
  for (int i = 0; i < transfer.count; ++i) words.push_back(get(*variable(transfer.first + i)));
  for (std::size_t i = 0; i < words.size(); ++i) {
    write(task, {transfer.head.kind, transfer.head.number + static_cast<std::uint32_t>(i)},
          words[i]);
  }
}

void FlowRounds::write_own(std::size_t task, const Transfer& transfer) {
  std::vector<std::int16_t> words;
  for (int i = 0; i < transfer.count; ++i) {
    words.push_back(
        get({transfer.head.kind, transfer.head.number + static_cast<std::uint32_t>(i)}));
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    write(task, *variable(transfer.first + static_cast<int>(i)), words[i]);
  }
}

void FlowRounds::write(std::size_t task, Device device, std::int16_t value) {
  set(device, value);
  writes_.push_back({device, value, task});
}

void FlowRounds::send(std::size_t task, bool write, const Transfer& transfer) {
  FlowRequest request{++last_request_, task, write, transfer, {}};
  for (int i = 0; write && i < transfer.count; ++i) {
    request.words.push_back(
        get({transfer.head.kind, transfer.head.number + static_cast<std::uint32_t>(i)}));
  }
  requests_.push_back(std::move(request));
  tasks_[task].waits = true;
  tasks_[task].request = last_request_;
}

void FlowRounds::complete(int id, int status, const std::vector<std::int16_t>& words) {
  const auto found = std::find_if(requests_.begin(), requests_.end(),
                                  [&](const FlowRequest& each) { return each.id == id; });
  if (found == requests_.end()) return;
  const FlowRequest request = std::move(*found);
  requests_.erase(found);
  if (orphans_.erase(id) != 0) {
    ++free_blocks_;
    ++counters_.late;
    return;
  }
  TaskRow& row = tasks_[request.task];
  row.waits = false;
  row.status = status;
  row.status_due = true;
  if (status != flow::flow_status_done) ++counters_.failed;
  if (!request.write && status == flow::flow_status_done) {
    row.words = words;
    row.words.resize(static_cast<std::size_t>(request.transfer.count));
  }
}

}  // namespace rung
