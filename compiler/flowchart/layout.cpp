// SPDX-License-Identifier: Apache-2.0
#include "flowchart/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "flowchart/rung_writer.hpp"
#include "rung_flow.hpp"
#include "source/text_file.hpp"

namespace rung::flowchart {
namespace {

// Conditions behind a write are looked at in a step of their own, when the write is done.
bool decides_apart(const Part& part) { return part.write && !part.whens.empty(); }
// A wait repeats nothing that stands before it.
bool waits_apart(const Part& part) {
  return part.wait_ticks > 0 || (part.wait_until && part.does_something());
}

std::size_t steps_of(const Part& part) {
  return 1 + (decides_apart(part) ? 1 : 0) + (waits_apart(part) ? 1 : 0);
}

// Where a step goes: to a step of the table, or nowhere: the task ends.
using Target = std::optional<std::size_t>;

struct Way {
  Logic condition;
  Target target;
  SourcePosition position;
};

std::int16_t number_of(Target target) {
  return target ? static_cast<std::int16_t>(*target) : kTaskEnds;
}

class Layout {
 public:
  Layout(const std::vector<NamedTask>& tasks, const std::vector<bool>& asked, Flowchart& chart)
      : tasks_(tasks), chart_(chart), frame_{chart.file, chart.dialect, {}, asked} {
    std::size_t next = 0;
    for (const NamedTask& task : tasks) {
      frame_.starts.push_back(task.starts);
      first_.emplace_back();
      for (const NamedStep& step : task.steps) {
        first_.back().push_back(next);
        for (const Part& part : step.parts) next += steps_of(part);
      }
    }
  }

  void run() {
    for (task_ = 0; task_ < tasks_.size(); ++task_) {
      const NamedTask& task = tasks_[task_];
      chart_.tasks.push_back(
          {task.name.text, task.starts, chart_.steps.size(), task.name.position});
      for (step_ = 0; step_ < task.steps.size(); ++step_) {
        const NamedStep& step = task.steps[step_];
        for (part_ = 0; part_ < step.parts.size(); ++part_) place(step.parts[part_]);
      }
    }
  }

 private:
  const NamedStep& named() const { return tasks_[task_].steps[step_]; }

  // What follows the current part in the text.
  Target behind() const {
    const Part& part = named().parts[part_];
    if (part_ + 1 < named().parts.size()) return start_ + steps_of(part);
    if (step_ + 1 < tasks_[task_].steps.size()) return first_[task_][step_ + 1];
    return std::nullopt;
  }

  Target target_of(const Exit& exit) const {
    switch (exit.kind) {
      case Exit::Kind::Step:
        return first_[task_][exit.step];
      case Exit::Kind::End:
        return std::nullopt;
      default:
        return behind();
    }
  }

  void place(const Part& part) {
    start_ = chart_.steps.size();
    if (part.wait_until && !waits_apart(part)) return wait_for(part, part_ > 0);
    RungWriter writer(frame_, task_);
    for (const Action& action : part.actions) act(action, writer);
    Step main = head(part, part_ > 0);
    main.read = part.read;
    main.write = part.write;
    if (!decides_apart(part)) {
      decide(part, writer, main);
      add(std::move(main), writer);
    } else {
      if (part.asks_failed && part.read) note_read(part, writer);
      go(writer, main, start_ + 1, fixed(true), part.position);
      add(std::move(main), writer);
      RungWriter second(frame_, task_);
      if (part.read) second.failed_of_read_too();
      Step behind_write = head(part, true);
      decide(part, second, behind_write);
      add(std::move(behind_write), second);
    }
    if (part.wait_ticks > 0) {
      wait_ticks(part);
    } else if (part.wait_until) {
      wait_for(part, true);
    }
  }

  Step head(const Part& part, bool added) const {
    Step step;
    step.name = named().name;
    step.task = task_;
    step.added = added;
    step.position = added ? part.position : named().position;
    step.text = named().text;
    return step;
  }

  void add(Step step, RungWriter& writer) {
    step.rungs = writer.take();
    std::sort(step.next.begin(), step.next.end());
    step.next.erase(std::unique(step.next.begin(), step.next.end()), step.next.end());
    chart_.steps.push_back(std::move(step));
  }

  static void act(const Action& action, RungWriter& writer) {
    writer.forget_words();
    const Logic guard = action.guard ? writer.condition(*action.guard) : fixed(true);
    switch (action.kind) {
      case Action::Kind::Bit:
        return writer.assign_bit(action.target, writer.condition(*action.source), action.position);
      case Action::Kind::Word:
        return writer.assign_word(action.target, *action.source, guard, action.position);
      case Action::Kind::Set:
      case Action::Kind::Reset: {
        const Op op = action.kind == Action::Kind::Set ? Op::Set : Op::Rst;
        return writer.outputs(guard,
                              {RungWriter::instruction(op, {action.target}, action.position)});
      }
      case Action::Kind::Start:
      case Action::Kind::Stop:
        break;
    }
    writer.start_or_stop(action.task, action.kind == Action::Kind::Start, guard, action.position);
  }

  void note_read(const Part& part, RungWriter& writer) const {
    const SourcePosition position = part.read->position;
    writer.assign_bit(
        device_operand(read_failed(task_)),
        compare(device_operand(kStatus), Relation::NotEqual, constant_operand(0), position),
        position);
  }

  static void go(RungWriter& writer, Step& step, Target target, const Logic& guard,
                 SourcePosition position) {
    writer.go(number_of(target), guard, position);
    if (target) step.next.push_back(*target);
  }

  // The transitions of `part`, as rungs of `step`: the least urgent first, since the last one that
  // is executed counts.
  void decide(const Part& part, RungWriter& writer, Step& step) const {
    writer.forget_words();
    std::vector<Way> ways;
    bool always = false;
    for (const Transition& when : part.whens) {
      Logic condition = writer.condition(*when.condition);
      if (always || condition.is_fixed(false)) continue;
      always = condition.is_fixed(true);
      ways.push_back({std::move(condition), target_of(when.exit), when.exit.position});
    }
    if (!always) {
      if (const auto way = otherwise(part, writer)) ways.push_back(*way);
    }
    for (std::size_t i = ways.size(); i-- > 0;) {
      go(writer, step, ways[i].target, ways[i].condition, ways[i].position);
    }
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (!ways[i].target) writer.note_end(only(ways, i), ways[i].position);
    }
  }

  // Where it goes if no condition holds; nothing: it stays.
  std::optional<Way> otherwise(const Part& part, RungWriter& writer) const {
    if (part.waits()) {
      const std::size_t wait = start_ + (decides_apart(part) ? 2 : 1);
      if (part.wait_ticks > 0) {
        writer.outputs(fixed(true), {RungWriter::instruction(Op::Mov,
                                                             {device_operand(clock(part)),
                                                              device_operand(wait_since(task_))},
                                                             part.wait_position)});
      }
      return Way{fixed(true), wait, part.wait_position};
    }
    if (part.otherwise.kind == Exit::Kind::Stay) {
      if (!decides_apart(part)) return std::nullopt;
      return Way{fixed(true), start_, part.position};
    }
    const bool written = part.otherwise.kind != Exit::Kind::Next;
    return Way{fixed(true), target_of(part.otherwise),
               written ? part.otherwise.position : part.position};
  }

  // When way i is the one that is taken.
  static Logic only(const std::vector<Way>& ways, std::size_t i) {
    Logic logic = ways[i].condition;
    for (std::size_t before = 0; before < i; ++before) {
      logic = all(std::move(logic), inverse(ways[before].condition));
    }
    return logic;
  }

  static Device clock(const Part& part) { return part.wait_tenths ? kTenths : kMilliseconds; }

  void wait_for(const Part& part, bool added) {
    RungWriter writer(frame_, task_);
    Step step = head(part, added);
    if (added) step.position = part.wait_position;
    leave_wait(writer.condition(*part.wait_until), part, writer, step);
    add(std::move(step), writer);
  }

  // More ticks than asked for: the first one may have been due at once.
  void wait_ticks(const Part& part) {
    RungWriter writer(frame_, task_);
    Step step = head(part, true);
    step.position = part.wait_position;
    const Operand passed = device_operand(scratch(0));
    writer.outputs(
        fixed(true),
        {RungWriter::instruction(
            Op::Sub, {device_operand(clock(part)), device_operand(wait_since(task_)), passed},
            part.wait_position)});
    leave_wait(
        compare(passed, Relation::Greater, constant_operand(part.wait_ticks), part.wait_position),
        part, writer, step);
    add(std::move(step), writer);
  }

  void leave_wait(const Logic& condition, const Part& part, RungWriter& writer, Step& step) const {
    const Target target = behind();
    go(writer, step, target, condition, part.wait_position);
    if (!target) writer.note_end(condition, part.wait_position);
  }

  const std::vector<NamedTask>& tasks_;
  Flowchart& chart_;
  Frame frame_;
  std::vector<std::vector<std::size_t>> first_;  // by task and named step
  std::size_t task_ = 0, step_ = 0, part_ = 0;   // what is being placed
  std::size_t start_ = 0;                        // its first step in the table
};

bool check_steps(const Flowchart& chart, const std::vector<NamedTask>& tasks,
                 Diagnostics& diagnostics) {
  std::size_t all = 0;
  for (const NamedTask& task : tasks) {
    for (const NamedStep& step : task.steps) {
      for (const Part& part : step.parts) all += steps_of(part);
      if (all <= flow::flow_steps) continue;
      diagnostics.error(chart.file, step.position,
                        fmt::format("with what waits, and conditions behind a write, add, the "
                                    "program has more than {} steps here",
                                    flow::flow_steps),
                        "use fewer waits of a time, or wait in steps of their own");
      return false;
    }
  }
  return true;
}

void check_transfers(const Flowchart& chart, Diagnostics& diagnostics) {
  std::set<std::tuple<std::size_t, int, int, Device>> different;
  for (const Step& step : chart.steps) {
    for (const auto& transfer : {step.read, step.write}) {
      if (!transfer) continue;
      different.emplace(transfer->board, transfer->first, transfer->count, transfer->head);
      if (different.size() < flow::flow_transfers) continue;
      return diagnostics.error(
          chart.file, transfer->position,
          fmt::format("more than {} different transfers", flow::flow_transfers - 1),
          "use the same words and variables in several steps, or move more "
          "words at once");
    }
  }
}

void warn_of_steps(const Flowchart& chart, Diagnostics& diagnostics) {
  std::vector<bool> reached(chart.steps.size());
  std::vector<std::size_t> open;
  const auto reach = [&](std::size_t step) {
    if (reached[step]) return;
    reached[step] = true;
    open.push_back(step);
  };
  for (const Task& task : chart.tasks) reach(task.first);
  while (!open.empty()) {
    const std::size_t step = open.back();
    open.pop_back();
    for (const std::size_t next : chart.steps[step].next) reach(next);
  }
  for (std::size_t i = 0; i < chart.steps.size(); ++i) {
    const Step& step = chart.steps[i];
    if (reached[i] || step.added) continue;
    diagnostics.warning(chart.file, step.position,
                        fmt::format("{}: no step of task {} leads here", rung::shown(step.name),
                                    rung::shown(chart.tasks[step.task].name)),
                        "remove it, or add the goto that is missing");
  }
}

}  // namespace

void lay_out(const std::vector<NamedTask>& tasks, const std::vector<bool>& asked,
             const std::vector<bool>& started, Flowchart& chart, Diagnostics& diagnostics) {
  if (!check_steps(chart, tasks, diagnostics)) return;
  Layout(tasks, asked, chart).run();
  check_transfers(chart, diagnostics);
  warn_of_steps(chart, diagnostics);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (tasks[i].starts || started[i]) continue;
    diagnostics.warning(
        chart.file, tasks[i].name.position,
        fmt::format("{}: nothing starts this task", shown(tasks[i].name)),
        fmt::format("write `task {} start`, or start it in a step", shown(tasks[i].name)));
  }
}

}  // namespace rung::flowchart
