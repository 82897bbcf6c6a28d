// SPDX-License-Identifier: Apache-2.0
#include "load/flow_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace rung::load {
namespace {

using image::FlowImage;
using image::FlowStep;

// Turns whose response is printed.
constexpr int kShownTurns = 3;

std::int64_t copy_of(const FlowImage& flow, int number, const FlowClocks& clocks) {
  if (number == 0) return 0;
  const image::FlowTransfer& transfer = flow.transfer(number);
  return flow.waits(transfer) ? clocks.copy + clocks.copy_word * transfer.count
                              : clocks.own + clocks.own_word * transfer.count;
}

bool waits(const FlowImage& flow, int number) {
  return number != 0 && flow.waits(flow.transfer(number));
}

// Starts and stops that its routine may write; the hardware takes no more than so many.
std::int64_t commands_of(const image::Image& image, const FlowStep& step) {
  int count = 0;
  for (int at = step.entry; at < step.end; ++at) {
    for (const isa::SlotInstruction& slot : image.steps.at(static_cast<std::size_t>(at))) {
      count +=
          isa::info(slot.opcode).format == isa::Format::Word && slot.rd == image.flow->task_word;
    }
  }
  return std::min(count, flow::flow_task_commands);
}

std::int64_t turn_of(const image::Image& image, const FlowStep& step, bool resumes,
                     const FlowClocks& clocks) {
  const FlowImage& flow = *image.flow;
  const std::int64_t commands = commands_of(image, step);
  std::int64_t run =
      copy_of(flow, step.read, clocks) + step.clocks + copy_of(flow, step.write, clocks);
  if (commands > 0) run += clocks.starts + clocks.start * commands;
  if (waits(flow, step.write)) run += clocks.suspend;
  if (waits(flow, step.read)) run = std::max(run, clocks.suspend);
  return clocks.turn + (resumes ? clocks.resume : 0) + run;
}

std::string microseconds(std::int64_t clocks, std::int64_t clock_hz) {
  if (clock_hz == 0) return {};
  return fmt::format(" ({:.2f} us)",
                     1e6 * static_cast<double>(clocks) / static_cast<double>(clock_hz));
}

}  // namespace

Phases phases_of(const Timing& timing, const image::Image& image) {
  Phases phases;
  phases.latch = timing.latch;
  phases.scan = timing.scan - timing.flow - image.clocks;
  phases.refresh = timing.refresh;
  phases.exchange = timing.exchange;
  phases.period = timing.period;
  phases.pins = timing.pins;
  phases.filter = timing.filter;
  return phases;
}

std::int64_t FlowBound::response(int turns_needed) const {
  return (turns_needed + 1) * std::max(round(), phases.period) + phases.pins + phases.filter;
}

FlowBound flow_bound(const image::Image& image, const Phases& phases, const FlowClocks& clocks) {
  const FlowImage& flow = *image.flow;
  FlowBound out;
  out.phases = phases;
  out.overhead = clocks.round;
  out.command_count = flow::flow_event_blocks + 1;
  out.commands =
      out.command_count * (clocks.command + clocks.command_word * flow::flow_block_words);
  out.ladder = image.clocks;
  for (const image::FlowTask& task : flow.tasks) {
    // Without steps it cannot be: it has a first one.
    out.tasks.push_back({task.name, task.first, 0});
  }
  std::vector<bool> resumes(flow.tasks.size(), false);
  for (const FlowStep& step : flow.steps) {
    if (waits(flow, step.read) || waits(flow, step.write)) resumes.at(step.task) = true;
  }
  for (std::size_t i = 0; i < flow.steps.size(); ++i) {
    const FlowStep& step = flow.steps[i];
    const std::int64_t turn = turn_of(image, step, resumes.at(step.task), clocks);
    out.steps.push_back({step.clocks, turn});
    FlowBound::Task& task = out.tasks.at(step.task);
    if (turn <= task.turn) continue;
    task.turn = turn;
    task.worst_step = static_cast<int>(i);
  }
  for (const FlowBound::Task& task : out.tasks) out.turns += task.turn;
  return out;
}

int turns_of(const FlowImage& flow, const std::vector<int>& path) {
  int turns = 0;
  for (const int step : path) turns += waits(flow, flow.steps.at(step).read) ? 2 : 1;
  return turns;
}

std::string to_string(const FlowBound& bound, const FlowImage& flow, std::int64_t clock_hz) {
  std::string text = fmt::format("{:<24} {:<28} {:>8} {:>8}\n", "task", "its longest turn: step",
                                 "routine", "turn");
  const auto line = [&](const std::string& what, std::int64_t clocks) {
    text += fmt::format("{:<62} {:>8}\n", what, clocks);
  };
  for (const FlowBound::Task& task : bound.tasks) {
    const auto step = static_cast<std::size_t>(task.worst_step);
    text += fmt::format("{:<24} {:<28} {:>8} {:>8}\n", task.name,
                        fmt::format("{} ({})", flow.steps.at(step).name, step),
                        bound.steps.at(step).routine, task.turn);
  }
  line(fmt::format("all {} tasks", bound.tasks.size()), bound.turns);
  line(fmt::format("{} commands of {} words: a full ring, and the PC's", bound.command_count,
                   flow::flow_block_words),
       bound.commands);
  line("beginning and end of the round", bound.overhead);
  line("ladder", bound.ladder + bound.phases.scan);
  const std::int64_t others = bound.phases.latch + bound.phases.refresh + bound.phases.exchange;
  if (others > 0) line("latch, refresh and exchange", others);
  line("a round, in clocks, at the most", bound.round());
  text += fmt::format("round: {} clocks{} at the most\n", bound.round(),
                      microseconds(bound.round(), clock_hz));
  for (int turns = 1; turns <= kShownTurns; ++turns) {
    text += fmt::format("input to output in {} turn{}: {} clocks{} at the most\n", turns,
                        turns == 1 ? "" : "s", bound.response(turns),
                        microseconds(bound.response(turns), clock_hz));
  }
  return text;
}

nlohmann::ordered_json to_json(const FlowBound& bound, const FlowImage& flow,
                               std::int64_t clock_hz) {
  nlohmann::ordered_json out;
  if (clock_hz != 0) out["clock_hz"] = clock_hz;
  nlohmann::ordered_json tasks = nlohmann::ordered_json::array();
  for (const FlowBound::Task& task : bound.tasks) {
    tasks.push_back({{"task", task.name},
                     {"worst_step", task.worst_step},
                     {"worst_step_name", flow.steps.at(task.worst_step).name},
                     {"turn_clocks", task.turn}});
  }
  nlohmann::ordered_json steps = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < bound.steps.size(); ++i) {
    steps.push_back({{"step", flow.steps[i].name},
                     {"task", flow.steps[i].task},
                     {"routine_clocks", bound.steps[i].routine},
                     {"turn_clocks", bound.steps[i].turn}});
  }
  out["round_clocks"] = bound.round();
  out["response_clocks"] = bound.response(1);
  out["further_turn_clocks"] = bound.response(2) - bound.response(1);
  out["turns_clocks"] = bound.turns;
  out["commands_clocks"] = bound.commands;
  out["overhead_clocks"] = bound.overhead;
  out["ladder_clocks"] = bound.ladder + bound.phases.scan;
  out["latch_clocks"] = bound.phases.latch;
  out["refresh_clocks"] = bound.phases.refresh;
  out["exchange_clocks"] = bound.phases.exchange;
  out["tasks"] = std::move(tasks);
  out["steps"] = std::move(steps);
  return out;
}

}  // namespace rung::load
