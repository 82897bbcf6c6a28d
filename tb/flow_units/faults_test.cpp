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

constexpr int kInputs = 40;
constexpr int kTurns = 2;
constexpr int kPanelUnit = 5;

// The task whose response is measured.
const std::string kProbe =
    "task PROBE start\nstep OFF\n  Y0 = off\n  when X0 goto ON\nstep ON\n  Y0 = on\n  when not X0 "
    "goto OFF\n";

std::string head(int unit) {
  return fmt::format(
      "unit {}\nboard MEMORY = unit 1 board 0\nboard PANEL = unit 1 board 1 panel\n"
      "board OTHER = unit 2 board 0\n",
      unit);
}

// `count` tasks that read from a board for ever, and count what they got: task n into D(100 + 2n)
// what was right, the next word what failed.
std::string askers(int count, const std::string& board) {
  std::string text;
  for (int n = 0; n < count; ++n) {
    text += fmt::format(
        "task ASK{0} start\nstep AGAIN\n  read D{3} count 4 from {4} at 200\n"
        "  D{1} = D{1} + 1 if not failed\n  D{2} = D{2} + 1 if failed\n  goto AGAIN\n",
        n, 100 + 2 * n, 101 + 2 * n, 300 + 4 * n, board);
  }
  return text;
}

class Faults : public testing::Test {
 protected:
  // One program for each unit, unit 1 with the probe.
  void start(const std::vector<std::string>& programs) {
    system_ = std::make_unique<FlowSystem>(static_cast<int>(programs.size()), 1);
    const std::string map = fmt::format(
        "board = 'simulated'\n[controller]\nexchange_points = 64\n[modbus]\nbaud = 115200\n"
        "[flow]\nlink_timeout_ms = 5\npanel_timeout_ms = 5\npanel_unit = {}\n",
        kPanelUnit);
    for (std::size_t i = 0; i < programs.size(); ++i) {
      const std::string file = folder_.put(fmt::format("unit{}.flow", i + 1), programs[i]);
      const std::string pins = i == 0 ? "[inputs]\nX0 = 'in0'\n[outputs]\nY0 = 'out0'\n" : "";
      const FlowBuilt built = build_flow(file, map + pins);
      system_->load(static_cast<int>(i) + 1, built.words);
      if (i == 0) bound_ = built.bound;
    }
    probe_ = std::make_unique<FlowProbe>(*system_, false, 1);
  }

  void expect_in_time(int inputs = kInputs) {
    std::uint64_t most = 0;
    for (int i = 0; i < inputs; ++i) most = std::max(most, probe_->input().clocks);
    EXPECT_LE(most, static_cast<std::uint64_t>(bound_.response(kTurns)));
    EXPECT_LE(system_->most_round_clocks(1), static_cast<std::uint64_t>(bound_.round()));
    EXPECT_FALSE(system_->faulted(1));
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

TEST_F(Faults, AUnitThatStopsAnswering) {
  // More askers than there are blocks, so that the pool is full as well.
  start({head(1) + kProbe + askers(flow::flow_task_blocks + 4, "OTHER"),
         head(2) + "task SET start\nstep ONCE\n  D200 = 7\n  end\n"});
  system_->start();
  expect_in_time();
  EXPECT_GT(word(100), 0);
  EXPECT_EQ(word(101), 0);
  EXPECT_EQ(word(300), 7);
  EXPECT_GT(counter(flow::reg_flow_pool_full), 0);

  system_->hold(2, true);
  expect_in_time();
  EXPECT_GT(word(101), 0);
  EXPECT_GT(counter(flow::reg_flow_failed), 0);
  EXPECT_GT(counter(flow::reg_link_lower_lost), 0);

  system_->hold(2, false);
  system_->start();
  const int before = word(100);
  expect_in_time();
  EXPECT_GT(word(100), before);
  expect_constant_ladder();
}

TEST_F(Faults, BrokenFrames) {
  start({head(1) + kProbe + askers(4, "OTHER"),
         head(2) + "task SET start\nstep ONCE\n  D200 = 7\n  end\n"});
  system_->start();
  system_->set_fault(1, LineFault::Noise);
  expect_in_time();
  system_->set_fault(1, LineFault::None);
  EXPECT_GT(counter(flow::reg_link_lower_bad), 0);
  EXPECT_GT(counter(flow::reg_link_lower_again), 0);
  const int before = word(100);
  expect_in_time(4);
  EXPECT_GT(word(100), before);
  EXPECT_EQ(word(300), 7);
}

TEST_F(Faults, APanelThatNeverReplies) {
  start({head(1) + kProbe + askers(3, "PANEL")});
  system_->attach_panel(1, kPanelUnit, 1, 2);
  system_->start();
  expect_in_time();
  EXPECT_GT(word(100), 0);
  EXPECT_EQ(word(300), 1200);  // panel.py: register n holds 1000 + n
  system_->silence_panel(1, true);
  const int before = word(101);
  expect_in_time();
  EXPECT_GT(word(101), before);
  EXPECT_GT(counter(flow::reg_panel_timeouts), 0);
}

TEST_F(Faults, AFullRing) {
  std::vector<std::string> programs{head(1) + kProbe +
                                    "task SET start\nstep ONCE\n  D200 = 7\n  end\n"};
  for (int unit = 2; unit <= 4; ++unit)
    programs.push_back(head(unit) + askers(flow::flow_task_blocks, "MEMORY"));
  start(programs);
  system_->start();
  expect_in_time();
  EXPECT_GT(counter(flow::reg_link_lower_full), 0);
  EXPECT_GT(counter(flow::reg_flow_events), 0);
  for (int unit = 2; unit <= 4; ++unit) {
    EXPECT_GT(word(100, unit), 0) << "unit " << unit;
    EXPECT_EQ(word(300, unit), 7) << "unit " << unit;
  }
}

TEST_F(Faults, ATaskThatNeverEnds) {
  start({head(1) + kProbe +
         "task LOOP start\nstep AGAIN\n  D1 = D1 * 3 + D2 / 7\n  D2 = D2 + 1\n  goto AGAIN\n"});
  system_->start();
  expect_in_time();
  EXPECT_NE(word(2), 0);
  expect_constant_ladder();
}

}  // namespace
}  // namespace rung::tb
