// SPDX-License-Identifier: Apache-2.0
// Clocks of rounds: exact, and as hdl/flow/README.md has them.
#include "flow/clocks.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "flow/rig.hpp"

namespace rung::tb::flow {
namespace {

using namespace rung::flow;
using namespace clocks;

class Clocks : public testing::TestWithParam<isa::Mpu> {
 protected:
  Clocks() : rig_(make_rig(GetParam())) { program_.boards = usual_boards(); }

  // A step of `moves` moves that leads to `to`.
  static Step plain(int moves, int to) {
    Step step;
    for (int i = 1; i < moves; ++i) step.routine.push_back(log(i));
    step.routine.push_back(next(to));
    return step;
  }
  static int ladder(const Program& program) {
    return static_cast<int>(program.ladder.size()) + kRoutine + kPorts;
  }
  // Clocks of the turns of the round that is next.
  int turns() {
    const Round round = rig_->round();
    EXPECT_EQ(round.ladder, ladder(program_));
    return round.clocks - round.ladder - kRound;
  }
  void begin() {
    rig_->reset();
    rig_->load(program_);
    rig_->first();
    rig_->idle(kWalk);
  }

  // A task whose only step has such transfers, starts and stops: turns that follow each other.
  void one_step(int before, int after, int commands, bool last) {
    SCOPED_TRACE(
        fmt::format("before {} after {} commands {} ends {}", before, after, commands, last));
    program_.transfers.assign(1, Transfer{});
    const int own = program_.add({kUnit, kMemory, 0, 32, kFirstData});
    const int far = program_.add({kUnit, kAlone, 0, 32, kFirstData});
    const auto number = [=](int kind) { return kind == 0 ? 0 : kind == 1 ? own : far; };
    Step step{{log(1), last ? ends() : next(0)}, number(before), number(after)};
    for (int i = 0; i < commands; ++i) step.routine.push_back(stop(50 + i));
    program_.steps = {step};
    program_.tasks = {Task{0, true}};
    begin();
    const load::FlowBound all = bound(program_);
    const auto limit = static_cast<int>(all.turns);
    int most = 0;
    for (int n = 0; n < 8; ++n) {
      most = std::max(most, turns());
      if (rig_->held().empty()) continue;
      const bool write = rig_->held().front().write;
      rig_->release(0, {0, 0, std::vector<std::uint16_t>(write ? 0U : 32U, 7)});
      rig_->drain();
    }
    EXPECT_LE(most, limit);
    // What `switch`, `resume` and a copy's way to the other side have for other turns.
    constexpr int kSlack = 13;
    EXPECT_GE(most, limit - kSlack);
  }

  std::shared_ptr<Rig> rig_;
  Program program_;
};

TEST_P(Clocks, NextTaskIsFoundInTheSameClocksWhateverTheirNumber) {
  constexpr int kMoves = 3;
  program_.steps = {plain(kMoves, 0)};
  program_.ladder = {set(20, 1), set(21, 2)};
  for (const int tasks : {0, 1, 2, 7, 99, 100}) {
    program_.tasks.assign(static_cast<std::size_t>(tasks), Task{0, true});
    begin();
    for (int n = 0; n < 3; ++n) {
      const Round round = rig_->round();
      EXPECT_EQ(round.clocks, kRound + ladder(program_) + tasks * (kMoves + kRoutine + kTurn));
      EXPECT_EQ(round.ladder, ladder(program_));
      ASSERT_EQ(round.starts.size(), static_cast<std::size_t>(tasks));
      std::vector<int> apart;
      for (std::size_t i = 1; i < round.starts.size(); ++i) {
        apart.push_back(round.starts[i] - round.starts[i - 1]);
      }
      // Once in a round the way goes around, at another place in each.
      const int usual = kMoves + kRoutine + kTurn;
      const auto others =
          std::count_if(apart.begin(), apart.end(), [=](int clocks) { return clocks != usual; });
      EXPECT_LE(others, 1);
    }
  }
}

// Tasks far apart are found as fast as neighbours.
TEST_P(Clocks, NextTaskIsFoundInTheSameClocksWhereverItIs) {
  program_.steps = {plain(1, 0)};
  for (const int other : {1, 2, 50, 98, 99}) {
    program_.tasks.assign(100, Task{0, false});
    program_.tasks[0].starts = true;
    program_.tasks[static_cast<std::size_t>(other)].starts = true;
    begin();
    for (int n = 0; n < 3; ++n) EXPECT_EQ(turns(), 2 * (1 + kRoutine + kTurn));
  }
}

TEST_P(Clocks, FirstRoundOfAProgram) {
  program_.steps = {plain(1, 0)};
  program_.tasks = {Task{0, true}};
  begin();
  const int usual = turns();
  rig_->first();
  const int first = turns();
  EXPECT_GT(first, usual);
  EXPECT_LE(first, usual + kWalk);
  EXPECT_EQ(turns(), usual);
}

TEST_P(Clocks, EndsStartsAndStops) {
  Step step{{log(1), ends()}, 0, 0};
  program_.steps = {step};
  program_.tasks = {Task{0, true}};
  begin();
  EXPECT_EQ(turns(), 2 + kRoutine + kTurn + kFinish);
  EXPECT_EQ(turns(), 0);
  for (int commands = 1; commands <= flow_task_commands; ++commands) {
    step.routine = {next(0)};
    for (int i = 0; i < commands; ++i) step.routine.push_back(stop(50 + i));
    program_.steps = {step};
    begin();
    for (int n = 0; n < 2; ++n) {
      EXPECT_EQ(turns(), 1 + commands + kRoutine + kTurn + kCommands + commands);
    }
  }
}

TEST_P(Clocks, Breakpoint) {
  program_.steps = {plain(2, 0)};
  program_.tasks = {Task{0, true}};
  begin();
  rig_->bus_write(reg_flow_break_step, 0);
  rig_->bus_write(reg_flow_break, 1);
  EXPECT_EQ(turns(), kNoRun);
  EXPECT_EQ(turns(), 0);
  rig_->bus_write(reg_flow_task, 0);
  rig_->bus_write(reg_flow_task_continue, 1);
  EXPECT_EQ(turns(), 2 + kRoutine + kTurn);
  EXPECT_EQ(turns(), kNoRun);
}

// Words of this unit, within the turn.
TEST_P(Clocks, OwnMemory) {
  for (const int count : {1, 2, 31, 32}) {
    const Transfer t{kUnit, kMemory, 0, count, kFirstData};
    program_.transfers.assign(1, Transfer{});
    const int number = program_.add(t);
    const int routine = 1 + kRoutine + kTurn;
    const int carried = kIn + kOut + 2 * count;
    Step step = plain(1, 0);
    program_.tasks = {Task{0, true}};
    step.before = number;
    program_.steps = {step};
    begin();
    for (int n = 0; n < 2; ++n) EXPECT_EQ(turns(), routine + kCheck + kBefore + carried + kStatus);
    step.before = 0;
    step.after = number;
    program_.steps = {step};
    begin();
    EXPECT_EQ(turns(), routine + kCheck + kStore + carried);
    EXPECT_EQ(turns(), routine + kCheck + kStore + carried + kStatus);
    step.before = number;
    program_.steps = {step};
    begin();
    EXPECT_EQ(turns(), routine + 2 * kCheck + kBefore + kStore + 2 * carried + kStatus);
  }
}

TEST_P(Clocks, SuspendAndResume) {
  for (const int count : {1, 5, 32}) {
    program_.transfers.assign(1, Transfer{});
    const int number = program_.add({kUnit, kSlow, 0, count, kFirstData});
    Step step = plain(1, 0);
    program_.tasks = {Task{0, true}};
    step.before = number;
    program_.steps = {step};
    begin();
    const int suspend = kNoRun + kCheck + kBefore + kSend;
    const int resume = kTurn + kLoad + kOut + count + kStatus + 1 + kRoutine + kFinish;
    for (int n = 0; n < 2; ++n) {
      EXPECT_EQ(turns(), suspend);
      EXPECT_EQ(turns(), 0);
      rig_->release(0, {0, 0, std::vector<std::uint16_t>(static_cast<std::size_t>(count), 7)});
      rig_->drain();
      EXPECT_EQ(turns(), resume);
    }
    step.before = 0;
    step.after = number;
    program_.steps = {step};
    begin();
    const int store = kTurn + 1 + kRoutine + kCheck + kStore + kIn + count + kSend;
    EXPECT_EQ(turns(), store);
    rig_->release(0, {0, 0, {}});
    rig_->drain();
    EXPECT_EQ(turns(), kStored + kStatus + store);
  }
}

TEST_P(Clocks, Commands) {
  begin();
  EXPECT_EQ(turns(), 0);
  for (const int count : {1, 32}) {
    for (const bool write : {false, true}) {
      const int carried = (write ? kOut : kIn) + count;
      rig_->bus_write(reg_flow_pc_resource, kUnit << 8 | kMemory);
      rig_->bus_write(reg_flow_pc_first, 0);
      rig_->bus_write(reg_flow_pc_count, count);
      rig_->bus_write(reg_flow_pc_control, write ? 3 : 1);
      EXPECT_EQ(turns(), kPc + carried);
      Event event{write, kMemory, 0, count, 2, 3, {}};
      if (write) event.words.assign(static_cast<std::size_t>(count), 9);
      rig_->send(event);
      rig_->drain();
      EXPECT_EQ(turns(), kEvent + carried);
    }
  }
  // Suspended, awaited, gone on with.
  rig_->send({false, kSlow, 0, 4, 2, 3, {}});
  rig_->drain();
  EXPECT_EQ(turns(), kEvent);
  EXPECT_EQ(turns(), kEventWaits);
  rig_->release(0, {0, 0, {1, 2, 3, 4}});
  rig_->drain();
  EXPECT_EQ(turns(), kEventResumed);
  EXPECT_EQ(turns(), 0);
  rig_->bus_write(reg_flow_pc_resource, 9 << 8 | kMemory);
  rig_->bus_write(reg_flow_pc_control, 1);
  EXPECT_EQ(turns(), kPc);
  EXPECT_EQ(turns(), 0);
  rig_->release(0, {0, 0, {1}});
  rig_->drain();
  EXPECT_EQ(turns(), kPcResumed);
}

// What the compiler's bound is made of holds for every kind of step, and is not far from the most.
TEST_P(Clocks, NoTurnTakesLongerThanTheTableSays) {
  for (const int before : {0, 1, 2}) {  // none, own memory, over a link
    for (const int after : {0, 1, 2}) {
      for (const int commands : {0, 1, flow_task_commands}) {
        for (const bool last : {false, true}) one_step(before, after, commands, last);
      }
    }
  }
}

TEST_P(Clocks, NoCommandTakesLongerThanTheTableSays) {
  EXPECT_GE(clocks_command, kEvent + kIn);
  EXPECT_GE(clocks_command, kEvent + kOut);
  EXPECT_GE(clocks_command, kPc + kIn);
  EXPECT_GE(clocks_command, kPc + kOut);
  EXPECT_GE(clocks_command_word, 1);
  EXPECT_GE(clocks_command, std::max({kEventWaits, kEventResumed, kPcResumed}));
  EXPECT_GE(clocks_round, kRound + kWalk);
}

TEST_P(Clocks, WithoutFlowsARoundIsTheLadder) {
  program_.ladder = {set(20, 1), set(21, 2), set(22, 3)};
  program_.tasks = {Task{0, true}};
  program_.steps = {plain(3, 0)};
  begin();
  rig_->enable(0);
  for (int n = 0; n < 3; ++n) {
    const Round round = rig_->round();
    EXPECT_EQ(round.clocks, ladder(program_));
    EXPECT_TRUE(round.starts.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Flow, Clocks, testing::Values(isa::Mpu::Mpu2, isa::Mpu::Mpu3),
                         [](const auto& info) {
                           return fmt::format("Mpu{}", static_cast<int>(info.param));
                         });

}  // namespace
}  // namespace rung::tb::flow
