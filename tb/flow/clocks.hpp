// SPDX-License-Identifier: Apache-2.0
// The table "clocks" of hdl/flow/README.md, and the bounds that follow from it.
#pragma once

#include <algorithm>

#include "flow/program.hpp"

namespace rung::tb::flow::clocks {

inline constexpr int kRoutine = isa::constant::fill_clocks;  // beside the routine's steps
inline constexpr int kRound = 12;    // a round beside commands, turns and the ladder
inline constexpr int kWalk = 103;    // more in the first round of a program, at most
inline constexpr int kTurn = 6;      // a turn, beside the routine
inline constexpr int kNoRun = 4;     // a turn without routine: pause, try again, suspend
inline constexpr int kFinish = 1;    // its task ends, or a block is given back
inline constexpr int kCommands = 4;  // there are starts and stops, beside one clock for each
inline constexpr int kCheck = 4;     // each transfer of a step, before it begins
inline constexpr int kBefore = 1;    // more if there is one before the routine
inline constexpr int kIn = 12;       // words of devices into a block, beside one for each
inline constexpr int kOut = 3;       // out of it
inline constexpr int kStatus = 2;    // status_word is written
inline constexpr int kSend = 2;      // a request goes out
inline constexpr int kLoad = 4;      // a turn that resumes a LOAD
inline constexpr int kStore = 4;     // a transfer behind the routine
inline constexpr int kStored = 3;    // a turn behind a STORE over a link
inline constexpr int kPc = 4;        // the PC's command, beside its words
inline constexpr int kPcResumed = 2;
inline constexpr int kEvent = 7;  // an event command, beside its words
inline constexpr int kEventWaits = 3;
inline constexpr int kEventResumed = 5;

// The most that a turn in this step may take.
inline int bound(const Program& program, const Step& step) {
  int clocks = kTurn + kRoutine + static_cast<int>(step.routine.size()) + kFinish + kStored;
  int commands = 0;
  for (const Move& move : step.routine) commands += move.to == kTaskWord;
  if (commands != 0) clocks += kCommands + std::min(commands, rung::flow::flow_task_commands);
  const auto carried = [&](int transfer) {
    return kIn + kOut + 2 * program.transfers[static_cast<std::size_t>(transfer)].count;
  };
  if (step.before != 0) clocks += kCheck + kBefore + std::max(carried(step.before), kLoad + kSend);
  if (step.after != 0) clocks += kCheck + kStore + carried(step.after) + kSend;
  return clocks + kStatus;
}

// The most that a round may take if no transfer is waited for in its place: every task a turn of
// the longest step, a full ring, a command of the PC.
inline int bound(const Program& program, int ladder) {
  int turn = 0;
  for (const Step& step : program.steps) turn = std::max(turn, bound(program, step));
  constexpr int kWordsIn = kIn + rung::flow::flow_block_words;
  return kRound + ladder + kPc + kWordsIn + rung::flow::flow_event_blocks * (kEvent + kWordsIn) +
         static_cast<int>(program.tasks.size()) * turn;
}

}  // namespace rung::tb::flow::clocks
