// SPDX-License-Identifier: Apache-2.0
// Programs executed round by round, against values worked out by hand.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support.hpp"

namespace rung::flowchart {
namespace {

TEST(FlowRounds, OneStepOfATaskInEachRound) {
  Story story(R"(task A start
step S
  D0 = D0 + 1
step T
  D1 = D0 * 10
  goto S
)");
  EXPECT_EQ(story.at(), "S");
  story.run();
  EXPECT_EQ(story.get("D0"), 1);
  EXPECT_EQ(story.get("D1"), 0);
  EXPECT_EQ(story.at(), "T");
  story.run();
  EXPECT_EQ(story.get("D1"), 10);
  story.run(4);
  EXPECT_EQ(story.get("D0"), 3);
  EXPECT_EQ(story.get("D1"), 30);
}

TEST(FlowRounds, Arithmetic) {
  Story story(R"(task A start
step S
  D10 = D0 + D1
  D11 = D0 - D1
  D12 = D0 * D1
  D14 = D0 / D1
  D16 = D0 % D1
  D18 = D0 and 0xF0 or D1 xor 3
  D19 = D0 / D2 + 7
  D20 = 100 / D2
  D21 = (D0 + 1) * (D1 - 2) - -5
  D22 = 5 if D0 / D2 = 0 or D2 <> 0
  goto S
)");
  for (const char* each : {"D13", "D15", "D17", "D19", "D20", "D22"}) story.set(each, 1234);
  story.set("D0", 1000).set("D1", -77).run();
  EXPECT_EQ(story.get("D10"), 923);
  EXPECT_EQ(story.get("D11"), 1077);
  EXPECT_EQ(story.get("D12"), -77000 + 65536);
  EXPECT_EQ(story.get("D14"), -12);
  EXPECT_EQ(story.get("D16"), 76);
  // -77 is FFB3, xor 3 FFB0; 1000 and F0 is E0.
  EXPECT_EQ(story.get("D18"), static_cast<std::int16_t>(0xFFF0));
  EXPECT_EQ(story.get("D21"), static_cast<std::int16_t>(1001 * -79 + 5));
  // The words behind products and quotients are nobody's, and a division by 0 does nothing.
  for (const char* each : {"D13", "D15", "D17", "D19", "D20", "D22"}) {
    EXPECT_EQ(story.get(each), 1234) << each;
  }
  story.set("D2", 3).run();
  EXPECT_EQ(story.get("D19"), 340);
  EXPECT_EQ(story.get("D20"), 33);
  EXPECT_EQ(story.get("D22"), 5);
}

TEST(FlowRounds, BitsAndGroups) {
  Story story(R"(task A start
step S
  M0 = X0 and not (X1 or D0 > 5)
  D1.3 = not X0
  K2Y0 = D2
  D3 = K2X0
  set M5 if X1
  reset M5 if X2
  M6 = D2.F or D2.0
  goto S
)");
  story.set("X0", 1).set("D2", 0x1A5).run();
  EXPECT_EQ(story.get("M0"), 1);
  EXPECT_EQ(story.get("D1"), 0);
  EXPECT_EQ(story.get("D3"), 1);
  EXPECT_EQ(story.get("M6"), 1);
  const int y[] = {1, 0, 1, 0, 0, 1, 0, 1, 0};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(story.get("Y" + std::to_string(i)), y[i]) << i;
  EXPECT_EQ(story.get("Y10"), 0);
  story.set("D0", 6).set("X0", 0).set("X1", 1).set("D2", 2).run();
  EXPECT_EQ(story.get("M0"), 0);
  EXPECT_EQ(story.get("D1"), 8);
  EXPECT_EQ(story.get("D3"), 2);
  EXPECT_EQ(story.get("M5"), 1);
  EXPECT_EQ(story.get("M6"), 0);
  story.set("X2", 1).run();
  EXPECT_EQ(story.get("M5"), 0);
}

TEST(FlowRounds, TheFirstConditionThatHoldsCounts) {
  constexpr std::string_view kText = R"(task A start
step S
  D0 = D0 + 1
  when X0 goto T
  when X1 goto U
step T
  goto T
step U
  goto U
)";
  Story stays(kText);
  stays.run(3);
  EXPECT_EQ(stays.at(), "S");
  EXPECT_EQ(stays.get("D0"), 3);
  Story both(kText);
  both.set("X0", 1).set("X1", 1).run();
  EXPECT_EQ(both.at(), "T");
  Story second(kText);
  second.set("X1", 1).run();
  EXPECT_EQ(second.at(), "U");
}

TEST(FlowRounds, TasksTakeTurnsFromTheOneBehindTheFirst) {
  Story story(R"(task A start
step S
  D0 = D0 * 10 + 1
  goto S
task B start
step S
  D0 = D0 * 10 + 2
  goto S
task C start
step S
  D0 = D0 * 10 + 3
  goto S
)");
  const int orders[] = {123, 231, 312, 123};
  for (const int order : orders) {
    story.set("D0", 0).run();
    EXPECT_EQ(story.get("D0"), order);
  }
}

TEST(FlowRounds, WhatIsStartedHasItsTurnIfThatHasNotPassed) {
  Story story(R"(task A
step S
  D0 = D0 + 1
task B start
step S
  start A
  start C
task C
step S
  D1 = D1 + 1
)");
  story.run();
  EXPECT_EQ(story.get("D0"), 0);
  EXPECT_EQ(story.get("D1"), 1);
  EXPECT_TRUE(story.task(0).started);
  EXPECT_FALSE(story.task(1).started);
  EXPECT_FALSE(story.task(2).started);
  story.run();
  EXPECT_EQ(story.get("D0"), 1);
  EXPECT_FALSE(story.task(0).started);
  story.run(3);
  EXPECT_EQ(story.get("D0"), 1);
}

TEST(FlowRounds, RunningFollowsStartStopAndEnd) {
  Story story(R"(task MAIN start
step S
  start A if X0
  stop A if X1
  start B if X2
  stop B if X3
  M0 = running A
  M1 = running B
  goto S
task A start
step S
  D0 = D0 + 1
  when X4 end
task B
step S
  when X5 goto S
  when X6 end
  when X7 goto T
step T
)");
  const auto runs = [&] { return story.get("M0") * 10 + story.get("M1"); };
  story.run();
  EXPECT_EQ(runs(), 10);
  story.set("X4", 1).run();  // A ends behind MAIN's turn or before it
  story.set("X4", 0).run();
  EXPECT_EQ(runs(), 0);
  EXPECT_FALSE(story.task(1).started);
  story.set("X0", 1).set("X2", 1).run(2);
  EXPECT_EQ(runs(), 11);
  // One that runs goes on where it is.
  EXPECT_TRUE(story.task(1).started && story.task(2).started);
  story.set("X0", 0).set("X1", 1).set("X2", 0).run();
  EXPECT_EQ(runs(), 1);
  EXPECT_FALSE(story.task(1).started);
  // The end of a `when` that is not the one taken is none.
  story.set("X5", 1).set("X6", 1).run(2);
  EXPECT_EQ(runs(), 1);
  EXPECT_TRUE(story.task(2).started);
  story.set("X5", 0).run(2);
  EXPECT_EQ(runs(), 0);
  EXPECT_FALSE(story.task(2).started);
  // The last step of the text ends it too.
  story.set("X6", 0).set("X2", 1).run();
  story.set("X2", 0).run();
  EXPECT_EQ(runs(), 1);
  story.set("X7", 1).run(4);
  EXPECT_EQ(runs(), 0);
  EXPECT_FALSE(story.task(2).started);
}

TEST(FlowRounds, ATaskStartsAgainAtItsBeginning) {
  Story story(R"(task A start
step S
  start B if X0
  stop B if X1
  goto S
task B
step ONE
  D0 = D0 + 1
step TWO
  D1 = D1 + 1
  wait X7
)");
  story.set("X0", 1).run(5);
  EXPECT_EQ(story.get("D0"), 1);
  EXPECT_EQ(story.get("D1"), 1);
  // Stopped and started in the same step: begins again.
  story.set("X1", 1).set("X0", 0).run();
  EXPECT_FALSE(story.task(1).started);
  story.set("X1", 0).set("X0", 1).run();
  EXPECT_TRUE(story.task(1).started);
  EXPECT_EQ(story.get("D0"), 2);
}

TEST(FlowRounds, ATaskThatStopsItselfIsGone) {
  Story story(R"(board M = unit 1 board 0
task A start
step S
  D0 = 5
  stop A if X0
  write D0 to M at 9
  goto S
)");
  story.run();
  EXPECT_EQ(story.get("D9"), 5);
  story.set("D9", 0).set("X0", 1).run(3);
  // Its write was not begun any more.
  EXPECT_EQ(story.get("D9"), 0);
  EXPECT_FALSE(story.task(0).started);
}

TEST(FlowRounds, WaitsForAConditionWithoutRepeating) {
  Story story(R"(task A start
step S
  D0 = D0 + 1
  wait X0
  D1 = D1 + 1
  wait not X0
  goto S
)");
  story.run(5);
  EXPECT_EQ(story.get("D0"), 1);
  EXPECT_EQ(story.get("D1"), 0);
  story.set("X0", 1).run(5);
  EXPECT_EQ(story.get("D1"), 1);
  // One round to leave, one for the goto, which is a step of its own, one to begin again.
  story.set("X0", 0).run(3);
  EXPECT_EQ(story.get("D0"), 2);
}

// Rounds until D0 is set, of a wait that begins in the first one.
int rounds_of(const std::string& amount, std::int64_t tick_us) {
  Story story("task A start\nstep S\nM0 = on\nwait " + amount + "\nD0 = 1\nwait X7\n", tick_us);
  int rounds = 0;
  while (story.get("D0") == 0 && rounds < 400'000) {
    story.run();
    ++rounds;
  }
  return rounds;
}

TEST(FlowRounds, WaitsForATime) {
  // Begun in round 0, at 0 ms; D0 is set in the round behind the first one that saw more than the
  // time on the clock, which shows the time of the round before.
  EXPECT_EQ(rounds_of("5 ms", 1000), 0 + 6 + 1 + 2);
  EXPECT_EQ(rounds_of("500 ms", 1000), 501 + 3);
  EXPECT_EQ(rounds_of("500 ms", 10'000), 51 + 3);
  EXPECT_EQ(rounds_of("2 s", 100), 20'010 + 3);
  EXPECT_EQ(rounds_of("30 s", 10'000), 3001 + 3);
  EXPECT_EQ(rounds_of("31 s", 10'000), 3110 + 3);
  EXPECT_EQ(rounds_of("1 min", 10'000), 6010 + 3);
  EXPECT_EQ(rounds_of("50 min", 100'000), 30'001 + 3);
}

// The clock has gone around in between.
TEST(FlowRounds, WaitsAcrossTheEndOfTheClock) {
  Story story(R"(task A start
step S
  wait X0
step T
  wait 20 s
  D0 = 1
  wait X7
)",
              10'000);
  story.run(6000);  // 60,000 of 65,536 ms
  story.set("X0", 1).run(1 + 1 + 2000);
  EXPECT_EQ(story.get("D0"), 0);
  story.run(3);
  EXPECT_EQ(story.get("D0"), 1);
}

TEST(FlowRounds, Breakpoints) {
  Story story(R"(task A start
step S
  D0 = D0 + 1
step T
  D1 = D1 + 1
  goto S
)");
  FlowRounds& rounds = story.rounds();
  rounds.set_break(1, true);
  story.run(4);
  EXPECT_EQ(story.task().state, FlowState::Pause);
  EXPECT_EQ(story.get("D0"), 1);
  EXPECT_EQ(story.get("D1"), 0);
  rounds.go_on(0);
  story.run(3);
  EXPECT_EQ(story.get("D1"), 1);
  EXPECT_EQ(story.get("D0"), 2);
  EXPECT_EQ(story.task().state, FlowState::Pause);
  rounds.set_break(1, false);
  rounds.go_on(0);
  rounds.pause(0);  // before the step behind the one that it goes on with
  story.run(3);
  EXPECT_EQ(story.task().state, FlowState::Pause);
  EXPECT_EQ(story.get("D1"), 2);
  EXPECT_EQ(story.get("D0"), 2);
  rounds.go_on(0);
  story.run(2);
  EXPECT_EQ(story.get("D1"), 3);
  EXPECT_EQ(story.get("D0"), 3);
}

// The ladder comes last in a round and sees what the steps did in it; its timers go on.
TEST(FlowRounds, TheLadderRunsBesideThem) {
  const std::filesystem::path folder = std::filesystem::path(RUNG_SCRATCH) / "flow_ladder";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "line.il")
      << "LD M0\nOUT Y0\nLD M1\nOUT T0 K3\nLD M8002\nMOV K50 D9\nLD M8000\nADD D5 K1 D5\nEND\n";
  std::ofstream(folder / "p.flow") << R"(ladder "line.il"
task A start
step S
  D6 = D5
  M0 = on
  M1 = on
step T
  M0 = off
  wait T0
  D7 = TN0
  wait X7
)";
  Diagnostics diagnostics;
  const auto chart = read((folder / "p.flow").string(), diagnostics);
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->ladder.networks.size(), 4U);
  FlowRounds rounds(*chart, 100'000);
  rounds.run_round();
  EXPECT_EQ(rounds.get(device("D6")), 0);
  EXPECT_EQ(rounds.get(device("Y0")), 1);
  EXPECT_EQ(rounds.get(device("D9")), 50);
  const std::vector<FlowWrite> expected = {{device("D6"), 0, 0},
                                           {device("M0"), 1, 0},
                                           {device("M1"), 1, 0},
                                           {device("Y0"), 1, std::nullopt},
                                           {device("D9"), 50, std::nullopt},
                                           {device("D5"), 1, std::nullopt}};
  EXPECT_EQ(rounds.writes(), expected);
  rounds.run_round();
  EXPECT_EQ(rounds.get(device("Y0")), 0);
  for (int i = 0; i < 5; ++i) rounds.run_round();
  EXPECT_EQ(rounds.get(device("D7")), 3);
  EXPECT_EQ(rounds.get(device("D5")), 7);
  EXPECT_EQ(rounds.get(device("D9")), 50);
}

TEST(FlowRounds, DialectsOfLists) {
  Story q("dialect q\ntask A start\nstep S\nY1F = X1A\nW1F = W1F * 3 + 1\nL3 = SM400\ngoto S\n");
  q.set("X1A", 1).run(3);
  EXPECT_EQ(q.get("Y1F"), 1);
  EXPECT_EQ(q.get("W1F"), 13);
  EXPECT_EQ(q.get("L3"), 1);
  Story paper("dialect paper\ntask A start\nstep S\nD0 = D0 % 3 + 1\nM0 = on\ngoto S\n");
  paper.run(2);
  EXPECT_EQ(paper.get("D0"), 2);
  EXPECT_EQ(paper.get("M0"), 1);
  paper.run(2);
  EXPECT_EQ(paper.get("D0"), 1);
}

}  // namespace
}  // namespace rung::flowchart
