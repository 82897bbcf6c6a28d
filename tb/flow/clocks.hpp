// SPDX-License-Identifier: Apache-2.0
// The table "Clocks" of hdl/flow/README.md, and the compiler's bounds for the tests' programs.
#pragma once

#include "flow/program.hpp"
#include "load/flow_bound.hpp"

namespace rung::tb::flow::clocks {

inline constexpr int kPorts = 3;  // the ladder's ports around its routine
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

// The bound that the compiler prints for such a program: of the constants of hdl/isa/flow.toml
// alone.
load::FlowBound bound(const Program& program);

}  // namespace rung::tb::flow::clocks
