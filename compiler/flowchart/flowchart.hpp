// SPDX-License-Identifier: Apache-2.0
// A program of flow tasks, as its source says it: tasks, their steps, and the ladder that runs
// beside them. What a step does is rungs of the same kind as the ladder's (rungs/program.hpp), so
// that the reference, the lowering and the passes behind it need to know nothing of flows. The
// language: compiler/FLOW.md; what runs it: hdl/flow/README.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rungs/program.hpp"

namespace rung::flowchart {

// Words through which steps and the task hardware speak. No program names them. Numbers are above
// any that the lowering gives to its own. All are 0 at the start.
inline constexpr std::uint32_t kFirstFlowWord = 0x10000;
inline constexpr Device kNextStep{DeviceKind::HW,
                                  kFirstFlowWord};  // number of the next step, kTaskEnds
inline constexpr Device kTaskCommand{DeviceKind::HW,
                                     kFirstFlowWord + 1};  // kStart + task: start, task: stop
inline constexpr Device kStatus{DeviceKind::HW,
                                kFirstFlowWord + 2};  // of the last transfer, 0: done
// Clocks modulo 2^16. Steps only read them; whoever runs the rounds adds the ticks since the round
// before, once a round: reference/flow_rounds, and in a controller a rung of the ladder's routine.
inline constexpr Device kMilliseconds{DeviceKind::HW, kFirstFlowWord + 3};
inline constexpr Device kTenths{DeviceKind::HW, kFirstFlowWord + 4};  // of 100 ms
// When the wait of task n began, by one of the two clocks.
constexpr Device wait_since(std::size_t task) {
  return {DeviceKind::HW, kFirstFlowWord + 0x100 + static_cast<std::uint32_t>(task)};
}
// Intermediate results of an expression; no step relies on what another left there, and a pair
// (n, n + 1) takes quotient and remainder of a DIV.
constexpr Device scratch(std::uint32_t n) { return {DeviceKind::HW, kFirstFlowWord + 0x200 + n}; }
// 1 while task n is not as it was at the start: one that starts with the program is stopped or has
// ended, another one runs. Steps keep it, those that start, stop and end the task, and only where
// some condition asks `running`.
constexpr Device task_turned(std::size_t task) {
  return {DeviceKind::HB, kFirstFlowWord + static_cast<std::uint32_t>(task)};
}
// The read of a step of task n failed, for the conditions behind its write.
constexpr Device read_failed(std::size_t task) {
  return {DeviceKind::HB, kFirstFlowWord + 0x100 + static_cast<std::uint32_t>(task)};
}
// Nothing writes it: LDI of it begins rungs that always run where the dialect has no relay that is
// always on.
inline constexpr Device kNever{DeviceKind::HB, kFirstFlowWord + 0x200};
inline constexpr std::int16_t kTaskEnds = -1;
inline constexpr std::int16_t kStart = 256;

// Something with variables that lie behind a (unit, board) pair.
struct Board {
  std::string name;
  int unit = 1;
  int number = 0;
  bool over_link = false;  // a step that wants its data gives the processor up
  bool exclusive = false;  // one task holds it until its step ends
  bool panel = false;      // on this unit's Modbus line; else memory
  SourcePosition position;
};

// `count` variables of a board from `first` on, and as many word devices from `head` on.
struct Transfer {
  std::size_t board = 0;  // index into Flowchart::boards
  int first = 0;
  int count = 1;
  Device head;
  SourcePosition position;
};

struct Step {
  std::string name;  // the source's; one that a wait adds has that of its step
  std::size_t task = 0;
  // Its rungs; of those that branch: LD ... MOV K<step> kNextStep, the last one that is executed
  // counts. They name no flags and no error relays, so that their arithmetic writes none, whatever
  // the ladder names.
  Program rungs;
  std::optional<Transfer> read;   // before the rungs
  std::optional<Transfer> write;  // after them
  std::vector<std::size_t> next;  // steps it may lead to
  bool added = false;             // by a wait
  SourcePosition position;
  std::string text;  // of its head, for listings
};

struct Task {
  std::string name;
  bool starts = false;    // with the program
  std::size_t first = 0;  // index into Flowchart::steps
  SourcePosition position;
};

struct Flowchart {
  std::string file;
  int unit = 1;
  Dialect dialect = Dialect::Fx;
  Program ladder;  // no instructions if there is none
  std::vector<Board> boards;
  std::vector<Task> tasks;
  std::vector<Step>
      steps;  // of the first task, then of the second ...; at most what flow.toml says
};

}  // namespace rung::flowchart
