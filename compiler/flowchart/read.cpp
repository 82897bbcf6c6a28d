// SPDX-License-Identifier: Apache-2.0
#include "flowchart/read.hpp"

#include <fmt/format.h>

#include <deque>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "flowchart/header.hpp"
#include "flowchart/layout.hpp"
#include "flowchart/statements.hpp"
#include "melsec/melsec.hpp"
#include "rung_flow.hpp"

namespace rung::flowchart {
namespace {

constexpr std::size_t kMostNamedSteps = 2000;  // flow.toml: promised

std::string text_of(const Line& line) {
  std::string text;
  for (const Token& token : line) {
    if (!text.empty() && token.kind != Token::Kind::End) text += ' ';
    text += token.text;
  }
  return text;
}

// Two passes: what is declared, then the lines of the steps.
class Reader {
 public:
  Reader(const SourceText& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics), header_(chart_) {
    chart_.file = source.file;
  }

  std::optional<Flowchart> read() {
    const int errors_before = diagnostics_.error_count();
    const std::vector<Line> lines = split_lines(source_);
    for (const Line& line : lines) guarded([&] { declare(line); });
    check_tasks();
    std::vector<bool> asked(tasks_.size());
    std::vector<bool> started(tasks_.size());
    std::vector<NamedTask> tasks;
    for (const TaskText& task : tasks_) tasks.push_back(named(task, asked, started));
    ladder();
    if (diagnostics_.error_count() == errors_before) {
      lay_out(tasks, asked, started, chart_, diagnostics_);
    }
    if (diagnostics_.error_count() > errors_before) return std::nullopt;
    return std::move(chart_);
  }

 private:
  struct StepText {
    Token name;
    std::string text;
    SourcePosition position;
    std::vector<const Line*> lines;
  };
  struct TaskText {
    Token name;
    bool named = false;
    bool starts = false;
    Names names{"step"};
    std::vector<StepText> steps;
  };

  template <typename Work>
  void guarded(Work work) {
    try {
      work();
    } catch (Refusal& refusal) {
      diagnostics_.error(source_.file, refusal.position, std::move(refusal.what),
                         std::move(refusal.mend));
    }
  }

  void declare(const Line& line) {
    const Token& first = line.front();
    if (first.is("task")) return task(line);
    if (first.is("step")) return step(line);
    for (const Token& token : line) {
      if (token.kind != Token::Kind::Bad) continue;
      const bool open = token.text.front() == '"';
      throw Refusal{token.position,
                    open ? "the name that begins here has no closing quote"
                         : fmt::format("{}: no character of the language", shown(token)),
                    open ? "write \" behind it" : "compiler/FLOW.md shows what there is"};
    }
    if (tasks_.empty()) {
      if (header_.line(line) || lost_) return;
      const std::string_view near =
          first.kind == Token::Kind::Word ? near_keyword(first.text) : std::string_view();
      const bool better = !near.empty() && near != first.text;
      throw Refusal{first.position,
                    fmt::format("{}: no line before the first task begins with this", shown(first)),
                    better ? fmt::format("did you mean {}?", near)
                           : "dialect, unit, ladder and board stand there, then tasks"};
    }
    for (const std::string_view word : {"dialect", "unit", "ladder", "board"}) {
      if (!first.is(word)) continue;
      throw Refusal{first.position, fmt::format("{}: stands before the first task only", word),
                    "put this line at the beginning"};
    }
    TaskText& now = tasks_.back();
    if (!now.steps.empty()) {
      now.steps.back().lines.push_back(&line);
    } else if (!lost_) {
      lost_ = true;
      throw Refusal{first.position,
                    fmt::format("{}: a line of no step: the task has none yet", shown(first)),
                    "begin with a line `step NAME`"};
    }
  }

  void task(const Line& line) {
    Cursor cursor(line);
    cursor.take();
    tasks_.emplace_back();
    lost_ = false;
    TaskText& task = tasks_.back();
    task.name = line.front();
    if (tasks_.size() == flow::flow_tasks + 1) {
      throw Refusal{line.front().position, fmt::format("more than {} tasks", flow::flow_tasks),
                    "let one task do the work of several"};
    }
    const Token& name = cursor.name("a task", "task NAME");
    task.name = name;
    task.named = true;
    task.starts = cursor.accept("start");
    // After the number of tasks: a name stands for its place among all of them.
    while (task_names_.size() + 1 < tasks_.size()) task_names_.skip();
    task_names_.declare(name);
    cursor.expect_end("task NAME, or task NAME start");
  }

  void step(const Line& line) {
    Cursor cursor(line);
    cursor.take();
    if (tasks_.empty()) {
      if (std::exchange(lost_, true)) return;
      throw Refusal{line.front().position, "a step of no task", "begin with a line `task NAME`"};
    }
    TaskText& task = tasks_.back();
    task.steps.emplace_back();
    StepText& step = task.steps.back();
    step.position = line.front().position;
    step.name = line.front();
    step.text = text_of(line);
    if (++steps_ == kMostNamedSteps + 1) {
      throw Refusal{line.front().position, fmt::format("more than {} steps", kMostNamedSteps),
                    "put more actions into one step, or share tasks out to another unit"};
    }
    const Token& name = cursor.name("a step", "step NAME");
    step.name = name;
    while (task.names.size() + 1 < task.steps.size()) task.names.skip();
    owners_.try_emplace(name.text, task.name.text);
    task.names.declare(name);
    cursor.expect_end("step NAME");
  }

  void check_tasks() {
    if (tasks_.empty() && !diagnostics_.has_errors()) {
      diagnostics_.error(source_.file, {}, "there is no task in this file",
                         "write `task NAME start`, then `step NAME` and its lines");
    }
    for (const TaskText& task : tasks_) {
      if (!task.steps.empty() || !task.named) continue;
      diagnostics_.error(source_.file, task.name.position,
                         fmt::format("{}: a task without a step", shown(task.name)),
                         "begin with a line `step NAME`, or remove the task");
    }
  }

  NamedTask named(const TaskText& task, std::vector<bool>& asked, std::vector<bool>& started) {
    NamedTask result;
    result.name = task.name;
    result.starts = task.starts;
    for (const StepText& step : task.steps) {
      StepReader reader({chart_.dialect, chart_.boards, header_.board_names(), task_names_,
                         task.names, owners_, asked, started},
                        step.position, step.text);
      for (const Line* line : step.lines) guarded([&] { reader.line(*line); });
      result.steps.push_back({step.name.text, step.position, step.text, reader.finish()});
    }
    return result;
  }

  void ladder() {
    chart_.ladder.file = source_.file;
    chart_.ladder.dialect = chart_.dialect;
    const Token& named = header_.ladder();
    if (named.kind != Token::Kind::Text) return;
    if (named.text.ends_with(".ld") || named.text.ends_with(".LD")) {
      diagnostics_.error(source_.file, named.position, "an LDmicro program cannot run beside tasks",
                         "write the ladder as an instruction list");
      return;
    }
    std::filesystem::path path = std::filesystem::path(source_.file).parent_path() / named.text;
    if (path == "-") path = "./-";  // a file of this name, not standard input
    const int errors_before = diagnostics_.error_count();
    std::optional<Program> program;
    if (const auto text = read_text(path.string(), diagnostics_)) {
      program = parse_melsec(*text, chart_.dialect, diagnostics_);
    }
    if (program) {
      chart_.ladder = std::move(*program);
    } else if (diagnostics_.error_count() > errors_before) {
      diagnostics_.note(source_.file, named.position, "this ladder is refused");
    }
  }

  const SourceText& source_;
  Diagnostics& diagnostics_;
  Flowchart chart_;
  Header header_;
  Names task_names_{"task"};
  std::deque<TaskText> tasks_;
  std::map<std::string, std::string> owners_;  // the first task that has a step of this name
  std::size_t steps_ = 0;
  bool lost_ = false;  // a line that belongs nowhere has been reported
};

}  // namespace

std::optional<Flowchart> parse(const SourceText& source, Diagnostics& diagnostics) {
  return Reader(source, diagnostics).read();
}

std::optional<Flowchart> read(const std::string& path, Diagnostics& diagnostics) {
  const auto source = read_text(path, diagnostics);
  if (!source) return std::nullopt;
  return parse(*source, diagnostics);
}

}  // namespace rung::flowchart
