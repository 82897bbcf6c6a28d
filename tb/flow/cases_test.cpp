// SPDX-License-Identifier: Apache-2.0
// What hdl/flow/README.md promises, a case each.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "flow/rig.hpp"

namespace rung::tb::flow {
namespace {

using namespace rung::flow;

class Cases : public testing::TestWithParam<isa::Mpu> {
 protected:
  Cases() : rig_(make_rig(GetParam())) { program_.boards = usual_boards(); }

  void begin() {
    rig_->reset();
    rig_->load(program_);
    rig_->first();
    rig_->idle(110);
  }
  // What routines wrote to kLog.
  std::vector<int> logged() {
    round_ = rig_->round();
    std::vector<int> values;
    for (const Write& write : round_.writes) {
      if (write.word == kLog) values.push_back(write.value);
    }
    return values;
  }
  using Log = std::vector<int>;
  // Lets the first held request go.
  void release(int status = 0, std::vector<std::uint16_t> words = {}) {
    rig_->release(0, {0, status, std::move(words)});
    rig_->drain();
  }
  int counter(int address) { return rig_->bus_read(address); }
  // `count` tasks of one step each, which logs 100 + task, with these transfers.
  void alike(int count, int before, int after) {
    program_.steps.clear();
    program_.tasks.clear();
    for (int n = 0; n < count; ++n) {
      program_.steps.push_back({{log(100 + n)}, before, after});
      program_.tasks.push_back({n, true});
    }
  }

  std::shared_ptr<Rig> rig_;
  Program program_;
  Round round_;
};

TEST_P(Cases, RoundsBeginBehindTheTaskThatBeganTheLastOne) {
  alike(3, 0, 0);
  begin();
  EXPECT_EQ(logged(), (Log{100, 101, 102}));
  EXPECT_EQ(logged(), (Log{101, 102, 100}));
  EXPECT_EQ(logged(), (Log{102, 100, 101}));
  EXPECT_EQ(logged(), (Log{100, 101, 102}));
}

TEST_P(Cases, WhatAStepStartsHasItsTurnInThisRoundIfThatHasNotPassed) {
  alike(4, 0, 0);
  program_.tasks[0].starts = program_.tasks[3].starts = false;
  program_.steps[2].routine = {log(102), start(0), start(3)};
  begin();
  // This round began with task 0, which was not ready then.
  EXPECT_EQ(logged(), (Log{101, 102, 103}));
  EXPECT_EQ(logged(), (Log{102, 103, 100, 101}));
  // Now it comes around to task 0 behind the one that starts it.
  program_.steps[2].routine = {log(102)};
  program_.steps[3].routine = {log(103), ends()};
  program_.steps[1].routine = {log(101), start(0), stop(2), start(3)};
  begin();
  EXPECT_EQ(logged(), (Log{101, 103}));
  EXPECT_EQ(logged(), (Log{100, 101}));
  EXPECT_EQ(logged(), (Log{101, 103, 100}));
  program_.tasks[2].starts = false;
  program_.steps[1].routine = {log(101), ends()};
  program_.steps[0].routine = {log(100), ends()};
  program_.tasks[3] = {2, true};
  program_.steps[2].routine = {log(102), start(0), start(1)};
  begin();
  EXPECT_EQ(logged(), (Log{101, 102}));
  EXPECT_EQ(logged(), (Log{102, 100, 101}));
}

TEST_P(Cases, PoolFullLosesNothing) {
  const int board = program_.add({kUnit, kSlow, 3, 1, kFirstData});
  alike(20, board, 0);
  for (int n = 0; n < 20; ++n) {
    const auto at = static_cast<std::size_t>(n);
    program_.steps[at].routine = {log(100 + n), copy(kLog, kFirstData), ends()};
  }
  begin();
  EXPECT_EQ(logged(), Log{});
  EXPECT_EQ(rig_->held().size(), 16U);
  EXPECT_EQ(counter(reg_flow_pool_full), 4);
  EXPECT_EQ(logged(), Log{});
  EXPECT_EQ(counter(reg_flow_pool_full), 8);
  std::set<int> ran;
  for (int n = 0; n < 20; ++n) {
    release(0, {static_cast<std::uint16_t>(1000 + n)});
    const Log seen = logged();
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[1], 1000 + n);
    ran.insert(seen[0]);
    rig_->round();
  }
  EXPECT_EQ(ran.size(), 20U);
  EXPECT_TRUE(rig_->held().empty());
}

TEST_P(Cases, ABoardThatCannotBeSharedIsHeldUntilTheStepEnds) {
  const int board = program_.add({kUnit, kAlone, 3, 1, kFirstData});
  alike(2, board, board);
  begin();
  EXPECT_EQ(logged(), Log{});
  EXPECT_EQ(rig_->held().size(), 1U);
  EXPECT_EQ(counter(reg_flow_held), 1);
  release(0, {5});
  // The routine of task 0 has run, but its STORE is still to come.
  EXPECT_EQ(logged(), Log{100});
  EXPECT_EQ(rig_->held().size(), 1U);
  EXPECT_TRUE(rig_->held()[0].write);
  EXPECT_EQ(rig_->held()[0].words, std::vector<std::uint16_t>{5});
  // Commands may not have it either.
  rig_->send({false, kAlone, 0, 1, 7, 1, {}});
  rig_->drain();
  EXPECT_EQ(logged(), Log{});
  EXPECT_EQ(rig_->held().size(), 1U);
  release();
  // It is free when the task has seen the answer: the next one to ask gets it.
  logged();
  EXPECT_EQ(rig_->held().size(), 1U);
}

// Tasks that do nothing but write, answered in each round: none keeps the others from board or
// blocks.
TEST_P(Cases, WhoGivesABlockBackGivesWay) {
  const int far = program_.add({9, 1, 3, 1, kFirstData});
  const int alone = program_.add({kUnit, kAlone, 3, 1, kFirstData});
  for (const auto& [count, board] : {std::pair{3, alone}, std::pair{40, far}}) {
    alike(count, 0, board);
    begin();
    std::map<int, int> turns;
    for (int n = 0; n < 36; ++n) {
      for (const int value : logged()) ++turns[value];
      while (!rig_->held().empty()) release();
    }
    for (int n = 0; n < count; ++n) EXPECT_GE(turns[100 + n], 5) << n << " of " << count;
  }
  // An event command that wants the board of the only one that has it.
  alike(1, 0, alone);
  begin();
  logged();
  rig_->send({false, kAlone, 0, 1, 7, 1, {}});
  rig_->drain();
  std::size_t replies = 0;
  for (int n = 0; n < 6; ++n) {
    while (!rig_->held().empty()) release();
    logged();
    replies += round_.replies.size();
  }
  EXPECT_EQ(replies, 1U);
}

TEST_P(Cases, AStoppedTasksDataVanish) {
  const int board = program_.add({kUnit, kSlow, 3, 2, kFirstData});
  program_.steps = {{{log(1), stop(1)}, 0, 0}, {{log(2)}, board, 0}, {{log(3)}, 0, 0}};
  program_.tasks = {{2, true}, {1, true}, {2, false}};
  begin();
  EXPECT_EQ(logged(), Log{3});
  EXPECT_EQ(rig_->state(1), 4 | 8 | 1);
  EXPECT_EQ(logged(), Log{3});
  program_.steps[2].routine = {log(3), stop(1), start(2)};
  begin();
  EXPECT_EQ(logged(), (Log{3, 3}));
  EXPECT_EQ(rig_->state(1), 0);
  begin();
  logged();
  ASSERT_EQ(rig_->held().size(), 0U);  // stopped before its turn
}

TEST_P(Cases, AStoppedTaskMayStartAgainBeforeItsDataCome) {
  const int board = program_.add({kUnit, kSlow, 3, 1, kFirstData});
  // Task 1 waits first; task 0 then restarts it.
  program_.steps = {{{log(1), next(1)}, 0, 0},
                    {{log(2), stop(1), start(1), next(2)}, 0, 0},
                    {{log(3)}, 0, 0},
                    {{log(4), copy(kLog, kFirstData)}, board, 0}};
  program_.tasks = {{0, true}, {3, true}};
  begin();
  EXPECT_EQ(logged(), Log{1});
  EXPECT_EQ(logged(), Log{2});
  // Its turn had passed.
  EXPECT_EQ(rig_->held().size(), 1U);
  EXPECT_EQ(logged(), Log{3});
  ASSERT_EQ(rig_->held().size(), 2U);
  EXPECT_NE(rig_->held()[0].block, rig_->held()[1].block);
  const int late = counter(reg_flow_late);
  release(0, {77});
  EXPECT_EQ(counter(reg_flow_late), late + 1);
  EXPECT_EQ(logged(), Log{3});
  EXPECT_EQ(rig_->read_word(kFirstData), 0);
  release(0, {78});
  const Log seen = logged();
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 78), 1);
}

TEST_P(Cases, EventsRunInTheRoundBehindTheirComing) {
  alike(30, 0, 0);
  begin();
  rig_->send({true, kMemory, 8, 2, 3, 55, {11, 12}});
  // It comes while the round is under way.
  EXPECT_TRUE(rig_->round().replies.empty());
  const Round round = rig_->round();
  ASSERT_EQ(round.replies.size(), 1U);
  EXPECT_EQ(round.replies[0].tag, 55);
  EXPECT_EQ(round.replies[0].to, 3);
  EXPECT_EQ(round.replies[0].status, 0);
  EXPECT_EQ(rig_->read_word(kFirstPoint + 8), 11);
  EXPECT_EQ(rig_->read_word(kFirstPoint + 9), 12);
}

TEST_P(Cases, SuspendedEventsDoNotHoldUpThoseBehindThem) {
  begin();
  rig_->write_word(kFirstPoint + 8, 4711);
  for (int n = 0; n < 3; ++n) rig_->send({false, n == 2 ? kMemory : kSlow, 8, 1, 3, n, {}});
  rig_->drain();
  Round round = rig_->round();
  ASSERT_EQ(round.replies.size(), 1U);
  EXPECT_EQ(round.replies[0].tag, 2);
  EXPECT_EQ(round.replies[0].words, std::vector<std::uint16_t>{4711});
  EXPECT_EQ(counter(reg_flow_event_waits), 2);
  // The second one's data come first.
  rig_->release(1, {0, 0, {9}});
  rig_->drain();
  round = rig_->round();
  ASSERT_EQ(round.replies.size(), 1U);
  EXPECT_EQ(round.replies[0].tag, 1);
  EXPECT_EQ(rig_->round().replies.size(), 0U);
  release(1);
  round = rig_->round();
  ASSERT_EQ(round.replies.size(), 1U);
  EXPECT_EQ(round.replies[0].tag, 0);
  EXPECT_EQ(round.replies[0].status, 1);
  EXPECT_EQ(round.replies[0].count, 0);
  EXPECT_EQ(counter(reg_flow_events), 3);
  EXPECT_EQ(counter(reg_flow_failed), 1);
}

TEST_P(Cases, FullEventRing) {
  begin();
  // One more than there is room for: it waits at the link.
  for (int n = 0; n <= flow_event_blocks; ++n) rig_->send({false, kSlow, n, 1, 3, n, {}});
  rig_->idle(200);
  EXPECT_TRUE(rig_->round().replies.empty());
  EXPECT_EQ(rig_->held().size(), static_cast<std::size_t>(flow_event_blocks));
  for (int n = 0; n < flow_event_blocks; ++n) {
    rig_->release(0, {0, 0, {static_cast<std::uint16_t>(n)}});
    rig_->idle(20);
  }
  const Round round = rig_->round();
  ASSERT_EQ(round.replies.size(), static_cast<std::size_t>(flow_event_blocks));
  for (int n = 0; n < flow_event_blocks; ++n) {
    const auto at = static_cast<std::size_t>(n);
    EXPECT_EQ(round.replies[at].tag, n);
    EXPECT_EQ(round.replies[at].words, std::vector<std::uint16_t>{static_cast<std::uint16_t>(n)});
  }
  rig_->drain();
  rig_->round();
  release(0, {1});
  EXPECT_EQ(rig_->round().replies.size(), 1U);
}

TEST_P(Cases, RepliesThatTheLinkDoesNotTakeComeLater) {
  alike(1, 0, 0);
  begin();
  rig_->takes_replies = false;
  rig_->send({false, kMemory, 8, 1, 3, 1, {}});
  rig_->send({false, kNobody, 8, 1, 3, 2, {}});
  rig_->drain();
  for (int n = 0; n < 3; ++n) EXPECT_EQ(logged(), Log{100});
  EXPECT_EQ(counter(reg_flow_events), 2);
  rig_->takes_replies = true;
  const Round round = rig_->round();
  ASSERT_EQ(round.replies.size(), 2U);
  EXPECT_EQ(round.replies[0].status, 0);
  EXPECT_EQ(round.replies[1].status, flow_status_refused);
  EXPECT_EQ(counter(reg_flow_events), 2);
  rig_->drain();
}

TEST_P(Cases, PcCommandIsNotInitialisedASecondTime) {
  alike(1, 0, 0);
  begin();
  rig_->bus_write(reg_flow_pc_resource, 9 << 8 | 3);
  rig_->bus_write(reg_flow_pc_first, 77);
  rig_->bus_write(reg_flow_pc_count, 2);
  rig_->bus_write(reg_flow_pc_data, 5);
  rig_->bus_write(reg_flow_pc_data + 1, 6);
  EXPECT_EQ(counter(reg_flow_pc_control), 0);
  rig_->bus_write(reg_flow_pc_control, 3);
  EXPECT_EQ(counter(reg_flow_pc_control), 1);
  rig_->round();
  EXPECT_EQ(counter(reg_flow_pc_control), 2);
  // What the PC says meanwhile changes nothing.
  rig_->bus_write(reg_flow_pc_control, 1);
  rig_->bus_write(reg_flow_pc_first, 1);
  rig_->bus_write(reg_flow_pc_data, 99);
  for (int n = 0; n < 3; ++n) EXPECT_EQ(logged(), Log{100});
  ASSERT_EQ(rig_->held().size(), 1U);
  const Request request = rig_->held()[0];
  EXPECT_FALSE(request.panel);
  EXPECT_TRUE(request.write);
  EXPECT_EQ(request.unit, 9);
  EXPECT_EQ(request.board, 3);
  EXPECT_EQ(request.first, 77);
  EXPECT_EQ(request.block, flow_pc_block);
  EXPECT_EQ(request.words, (std::vector<std::uint16_t>{5, 6}));
  release(1);
  EXPECT_EQ(counter(reg_flow_pc_control), 2);
  rig_->round();
  EXPECT_EQ(counter(reg_flow_pc_control), 0);
  EXPECT_EQ(counter(reg_flow_pc_status), 1);
  EXPECT_EQ(counter(reg_flow_failed), 1);
}

TEST_P(Cases, WithoutSuspensionEverythingWaits) {
  const int board = program_.add({kUnit, kSlow, 3, 1, kFirstData});
  alike(2, 0, 0);
  program_.steps[0] = {{log(100), copy(kLog, kFirstData)}, board, board};
  rig_->answer = [](const Request& r) {
    return Answer{2000, 0, r.write ? std::vector<std::uint16_t>{} : std::vector<std::uint16_t>{8}};
  };
  begin();
  EXPECT_EQ(logged(), Log{101});
  EXPECT_LT(round_.clocks, 100);
  program_.in_place = true;
  begin();
  EXPECT_EQ(logged(), (Log{100, 8, 101}));
  EXPECT_GT(round_.clocks, 4000);
  // Commands too.
  rig_->send({false, kSlow, 0, 1, 7, 1, {}});
  rig_->drain();
  EXPECT_EQ(logged(), (Log{101, 100, 8}));
  EXPECT_EQ(round_.replies.size(), 1U);
  EXPECT_GT(round_.clocks, 6000);
  EXPECT_EQ(counter(reg_flow_event_waits), 0);
}

// The watchdog in every clock of a round: the next start finds all blocks and boards free.
TEST_P(Cases, GivenUpInAnyClock) {
  const int alone = program_.add({kUnit, kAlone, 3, 2, kFirstData});
  const int local = program_.add({kUnit, kAloneMemory, 3, 2, kFirstData});
  alike(17, alone, alone);
  program_.steps[1] = {{log(101)}, local, local};
  for (std::size_t n = 2; n < 17; ++n) {
    program_.steps[n].before = program_.add({9, 1, static_cast<int>(n), 1, kFirstData});
    program_.steps[n].after = 0;
  }
  begin();
  const int clocks = rig_->round().clocks;
  rig_->reset();
  rig_->load(program_);
  for (int at = 1; at < clocks; at += 3) {
    rig_->first();
    rig_->idle(110);
    rig_->send({true, kMemory, 8, 2, 3, 1, {1, 2}});
    rig_->drain();
    const Round given_up = rig_->round(at);
    while (!rig_->held().empty()) release(1);
    rig_->first();
    rig_->idle(110);
    const Round round = rig_->round();
    // All 16 blocks, the board, and the event if it has not been answered before.
    ASSERT_EQ(rig_->held().size(), 16U) << "given up in clock " << at;
    const auto held = rig_->held();
    ASSERT_EQ(
        std::count_if(held.begin(), held.end(), [](const auto& r) { return r.board == kAlone; }),
        1);
    ASSERT_EQ(given_up.replies.size() + round.replies.size(), 1U) << at;
    while (!rig_->held().empty()) release(1);
  }
}

// Nor has the next start anything of the turn that was given up: its task's next step, or its end.
TEST_P(Cases, GivenUpInAnyClockBeginsAnew) {
  const int far = program_.add({9, 1, 3, 1, kFirstData});
  program_.steps = {{{log(100), next(1)}, 0, far},
                    {{log(101), next(2)}, 0, far},
                    {{log(102)}, 0, 0},
                    {{log(103), ends()}, 0, far}};
  program_.tasks = {{0, true}, {3, true}};
  // The first round, and the answers that both tasks wait for.
  const auto first_steps = [this] {
    Log first = logged();
    std::sort(first.begin(), first.end());
    while (!rig_->held().empty()) release();
    return first;
  };
  begin();
  ASSERT_EQ(first_steps(), (Log{100, 103}));
  const int clocks = rig_->round().clocks;
  while (!rig_->held().empty()) release();
  for (int at = 1; at < clocks; ++at) {
    rig_->first();
    rig_->idle(110);
    ASSERT_EQ(first_steps(), (Log{100, 103})) << "before clock " << at;
    rig_->round(at);
    while (!rig_->held().empty()) release();
    rig_->first();
    rig_->idle(110);
    ASSERT_EQ(first_steps(), (Log{100, 103})) << "given up in clock " << at;
  }
}

TEST_P(Cases, CountersAndOthersRegisters) {
  program_.ladder = {set(20, 1)};
  alike(2, 0, 0);
  begin();
  int most = 0;
  for (int n = 0; n < 5; ++n) most = std::max(most, rig_->round().clocks);
  EXPECT_EQ(counter(reg_flow_rounds_low), 5);
  EXPECT_EQ(counter(reg_flow_rounds_high), 0);
  EXPECT_EQ(counter(reg_flow_round_max_low), most);
  EXPECT_EQ(counter(reg_flow_round_max_high), 0);
  const int ladder = rig_->round().ladder;
  EXPECT_EQ(counter(reg_flow_ladder_min), ladder);
  EXPECT_EQ(counter(reg_flow_ladder_max), ladder);
  for (int n = 0; n < 8; ++n) EXPECT_EQ(counter(reg_link_upper_bad + n), n + 1);
  EXPECT_EQ(counter(reg_panel_bad), 9);
  EXPECT_EQ(counter(reg_panel_timeouts), 10);
  EXPECT_EQ(counter(reg_flow_late), 1000);
  EXPECT_EQ(counter(reg_panel_timeouts + 1), 0);
  // A new start begins them anew, but for the count of rounds.
  rig_->first();
  EXPECT_EQ(counter(reg_flow_round_max_low), 0);
  EXPECT_EQ(counter(reg_flow_rounds_low), 6);
}

INSTANTIATE_TEST_SUITE_P(Flow, Cases, testing::Values(isa::Mpu::Mpu2, isa::Mpu::Mpu3),
                         [](const auto& info) {
                           return fmt::format("Mpu{}", static_cast<int>(info.param));
                         });

}  // namespace
}  // namespace rung::tb::flow
