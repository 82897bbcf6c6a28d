// SPDX-License-Identifier: Apache-2.0
// What goes wrong around a unit costs those who asked for it, and nobody else: the other task's
// response stays inside the bound that the compiler prints, and a client can read what has
// happened.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>

#include "flow_units/probe.hpp"
#include "flow_units/programs.hpp"
#include "rung_flow.hpp"

namespace rung::tb {
namespace {

constexpr int kInputs = 15;
constexpr int kLinkTimeoutMs = 250;  // more than the link and the panel take for all that want them
constexpr int kPanelTimeoutMs = 200;
// Tasks that ask: in unit 1 more than there are blocks, below it more than ring and event blocks
// hold.
constexpr int kAskers[] = {rung::flow::flow_task_blocks + 1, 10, 6, 6};
constexpr int kUnits = 4;
constexpr int kFirstTally = 100;  // D100
constexpr int kTurns = 2;
constexpr int kPanelUnit = 5;
constexpr int kPanelWord = 1200;  // of its register 200: panel.py

// The task whose response is measured.
const std::string kProbe =
    "task PROBE start\nstep OFF\n  Y0 = off\n  when X0 goto ON\nstep ON\n  Y0 = on\n  when not X0 "
    "goto OFF\n";

std::string head(int unit) {
  return fmt::format("unit {}\nboard PANEL = unit 1 board 1{}\nboard OTHER = unit 2 board 0\n",
                     unit, unit == 1 ? " panel" : "");
}

// `count` tasks that read from a board for ever, and count what they got: task n into D(100 + 2n)
// what was right, the next word what failed.
std::string askers(int count, const std::string& board) {
  std::string text;
  for (int n = 0; n < count; ++n) {
    text += fmt::format(
        "task ASK{0} start\nstep AGAIN\n  read D{3} from {4} at 200\n"
        "  D{1} = D{1} + 1 if not failed\n  D{2} = D{2} + 1 if failed\n  goto AGAIN\n",
        n, kFirstTally + 2 * n, kFirstTally + 1 + 2 * n, 300 + 4 * n, board);
  }
  return text;
}

class Faults : public testing::Test {
 protected:
  // One program for each unit, unit 1 with the probe.
  void start(const std::vector<std::string>& programs) {
    system_ = std::make_unique<FlowSystem>(static_cast<int>(programs.size()), 1);
    const std::string map = fmt::format(
        "board = 'simulated'\n[controller]\nexchange_points = 64\n[modbus]\nbaud = 57600\n"
        "[flow]\nlink_timeout_ms = {}\npanel_timeout_ms = {}\npanel_unit = {}\n"
        "panel_baud = 57600\n",
        kLinkTimeoutMs, kPanelTimeoutMs, kPanelUnit);
    for (std::size_t i = 0; i < programs.size(); ++i) {
      const std::string file = folder_.put(fmt::format("unit{}.flow", i + 1), programs[i]);
      const std::string pins = i == 0 ? "[inputs]\nX0 = 'in0'\n[outputs]\nY0 = 'out0'\n" : "";
      const FlowBuilt built = build_flow(file, map + pins);
      system_->load(static_cast<int>(i) + 1, built.words);
      if (i == 0) bound_ = built.bound;
    }
    probe_ = std::make_unique<FlowProbe>(*system_, false, false, 1);
  }

  void expect_in_time() {
    std::uint64_t most = 0;
    for (int i = 0; i < kInputs; ++i) most = std::max(most, probe_->input().clocks);
    EXPECT_LE(most, static_cast<std::uint64_t>(bound_.response(kTurns)));
    EXPECT_LE(system_->most_round_clocks(1), static_cast<std::uint64_t>(bound_.round()));
    EXPECT_FALSE(system_->faulted(1));
  }

  // As long as a request may take.
  void pass() { system_->run((kLinkTimeoutMs + 5) * FlowSystem::clocks_per_ms()); }

  // What a unit's askers have had, all together.
  struct Tally {
    int answered = 0, failed = 0;
  };
  Tally tally(int unit) {
    Tally sum;
    const int askers = kAskers[unit - 1];
    const auto answer =
        system_->ask(unit, {3, 0, kFirstTally, 0, static_cast<std::uint8_t>(2 * askers)});
    EXPECT_EQ(answer.at(1), 3);
    for (int n = 0; n < 2 * askers; ++n) {
      const auto at = static_cast<std::size_t>(3 + 2 * n);
      (n % 2 == 0 ? sum.answered : sum.failed) += answer.at(at) << 8 | answer.at(at + 1);
    }
    return sum;
  }

  int counter(int number, int unit = 1) { return system_->registers(unit, number, 1).at(0); }
  int word(int device, int unit = 1) {
    const auto answer = system_->ask(unit, {3, static_cast<std::uint8_t>(device >> 8),
                                            static_cast<std::uint8_t>(device & 0xFF), 0, 1});
    EXPECT_EQ(answer.at(1), 3);
    return answer.at(3) << 8 | answer.at(4);
  }
  void expect_constant_ladder() {
    EXPECT_EQ(counter(flow::reg_flow_ladder_min), counter(flow::reg_flow_ladder_max));
  }

  const Folder folder_;
  std::unique_ptr<FlowSystem> system_;
  std::unique_ptr<FlowProbe> probe_;
  load::FlowBound bound_;
};

// The same four units, one fault behind the other: starting them takes longer than all else.
TEST_F(Faults, OfTheLinkAndItsUnits) {
  // The pool is full, and all units below want unit 1's panel at once, which has one answer after
  // the other.
  std::vector<std::string> programs{head(1) + kProbe + askers(kAskers[0], "OTHER")};
  for (int unit = 2; unit <= kUnits; ++unit) {
    programs.push_back(head(unit) + "task SET start\nstep ONCE\n  D200 = 7\n  end\n" +
                       askers(kAskers[unit - 1], "PANEL"));
  }
  start(programs);
  system_->attach_panel(1, kPanelUnit, 1, 2);
  system_->start();
  pass();  // the first requests found units that did not run yet
  {
    SCOPED_TRACE("a full ring");
    Tally before[kUnits];
    for (int unit = 1; unit <= kUnits; ++unit) before[unit - 1] = tally(unit);
    expect_in_time();
    pass();
    EXPECT_GT(counter(flow::reg_link_lower_full), 0);
    EXPECT_GT(counter(flow::reg_flow_event_waits), 0);
    EXPECT_GT(counter(flow::reg_flow_events), 0);
    EXPECT_GT(counter(flow::reg_flow_pool_full), 0);
    for (int unit = 1; unit <= kUnits; ++unit) {
      const Tally after = tally(unit);
      EXPECT_GE(after.answered, before[unit - 1].answered + kAskers[unit - 1]) << "unit " << unit;
      EXPECT_EQ(after.failed, before[unit - 1].failed) << "unit " << unit;
      EXPECT_EQ(word(300, unit), unit == 1 ? 7 : kPanelWord) << "unit " << unit;
    }
  }
  {
    SCOPED_TRACE("broken frames");
    system_->set_fault(1, LineFault::Noise);
    expect_in_time();
    system_->set_fault(1, LineFault::None);
    EXPECT_GT(counter(flow::reg_link_lower_bad), 0);
    EXPECT_GT(counter(flow::reg_link_lower_again), 0);
    EXPECT_EQ(word(300), 7);
  }
  {
    SCOPED_TRACE("a unit that stops answering");
    const int failed = tally(1).failed;
    system_->set_fault(1, LineFault::Cut);
    expect_in_time();
    pass();
    expect_in_time();
    EXPECT_GT(tally(1).failed, failed);
    EXPECT_GT(counter(flow::reg_flow_failed), 0);
    EXPECT_GT(counter(flow::reg_link_lower_lost), 0);
  }
  {
    SCOPED_TRACE("and comes back");
    system_->set_fault(1, LineFault::None);
    const int answered = tally(1).answered;
    expect_in_time();
    pass();
    EXPECT_GT(tally(1).answered, answered);
    expect_constant_ladder();
  }
}

TEST_F(Faults, APanelThatNeverRepliesAndATaskThatNeverEnds) {
  start({head(1) + kProbe + askers(3, "PANEL") +
         "task LOOP start\nstep AGAIN\n  D1 = D1 * 3 + D2 / 7\n  D2 = D2 + 1\n  goto AGAIN\n"});
  system_->attach_panel(1, kPanelUnit, 1, 2);
  system_->start();
  expect_in_time();
  EXPECT_GT(word(100), 0);
  EXPECT_EQ(word(101), 0);
  EXPECT_EQ(word(300), kPanelWord);
  EXPECT_NE(word(2), 0);
  system_->silence_panel(1, true);
  pass();
  expect_in_time();
  EXPECT_GT(word(101), 0);
  EXPECT_GT(counter(flow::reg_panel_timeouts), 0);
  expect_constant_ladder();
}

}  // namespace
}  // namespace rung::tb
