// SPDX-License-Identifier: Apache-2.0
#include "flow/clocks.hpp"

#include <set>

namespace rung::tb::flow::clocks {
namespace {

// Steps that a task can come to.
std::set<int> steps_of(const Program& program, const Task& task) {
  std::set<int> seen;
  std::vector<int> due{task.first};
  while (!due.empty()) {
    const int n = due.back();
    due.pop_back();
    if (!seen.insert(n).second) continue;
    for (const Move& move : program.steps.at(static_cast<std::size_t>(n)).routine) {
      if (move.to == kNextWord && move.value != kEnds) due.push_back(move.value);
    }
  }
  return seen;
}

image::Image image_of(const Program& program) {
  image::Image image;
  image.clocks = static_cast<std::int64_t>(program.ladder.size()) + kRoutine;
  image::FlowImage flow;
  flow.unit = kUnit;
  flow.task_word = kTaskWord;
  for (std::size_t n = 1; n < program.transfers.size(); ++n) {
    const Transfer& transfer = program.transfers[n];
    const auto board = static_cast<std::size_t>(transfer.board);
    const int bits = board < program.boards.size() ? program.boards[board] : 0;
    flow.transfers.push_back(
        {static_cast<int>(flow.boards.size()), transfer.first, transfer.count, transfer.head});
    flow.boards.push_back({"", transfer.unit, transfer.board, (bits & kOverLink) != 0,
                           (bits & kExclusive) != 0, (bits & kPanel) != 0});
  }
  // Each routine once; each task's steps.
  std::vector<int> entries;
  for (const Step& step : program.steps) {
    entries.push_back(static_cast<int>(image.steps.size()));
    for (const Move& move : step.routine) {
      isa::SlotInstruction slot;
      slot.opcode = isa::Opcode::Mv;
      slot.rd = static_cast<std::uint16_t>(move.to);
      image.steps.push_back({slot});
    }
  }
  for (const Task& task : program.tasks) {
    for (const int n : steps_of(program, task)) {
      const Step& step = program.steps[static_cast<std::size_t>(n)];
      image::FlowStep& one = flow.steps.emplace_back();
      one.task = static_cast<int>(flow.tasks.size());
      one.entry = entries[static_cast<std::size_t>(n)];
      one.end = one.entry + static_cast<int>(step.routine.size());
      one.read = step.before;
      one.write = step.after;
      one.clocks = one.end - one.entry + kRoutine;
    }
    flow.tasks.push_back({"", task.first, task.starts});
  }
  image.flow = flow;
  return image;
}

}  // namespace

load::FlowBound bound(const Program& program) {
  load::Phases phases;
  phases.scan = kPorts;
  return load::flow_bound(image_of(program), phases);
}

}  // namespace rung::tb::flow::clocks
