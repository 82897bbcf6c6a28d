// SPDX-License-Identifier: Apache-2.0
// Transfers of steps, round by round: own memory within the turn, others' while the rest goes on.
#include <gtest/gtest.h>

#include "support.hpp"

namespace rung::flowchart {
namespace {

TEST(FlowRounds, OwnMemoryWithinTheTurn) {
  Story story(R"(board M = unit 1 board 0
task A start
step S
  read D10 count 3 from M at 100
  D11 = D11 + 1
  M0 = failed
  write D10 count 3 to M at 101
  goto S
)");
  story.set("D100", 7).set("D101", 8).set("D102", 9).run();
  EXPECT_EQ(story.get("D10"), 7);
  EXPECT_EQ(story.get("D11"), 9);
  EXPECT_EQ(story.get("D101"), 7);
  EXPECT_EQ(story.get("D102"), 9);
  EXPECT_EQ(story.get("D103"), 9);
  EXPECT_EQ(story.get("M0"), 0);
  EXPECT_TRUE(story.rounds().requests().empty());
  const std::vector<FlowWrite> expected = {
      {device("D10"), 7, 0}, {device("D11"), 8, 0},  {device("D12"), 9, 0},  {device("D11"), 9, 0},
      {device("M0"), 0, 0},  {device("D101"), 7, 0}, {device("D102"), 9, 0}, {device("D103"), 9, 0},
  };
  EXPECT_EQ(story.rounds().writes(), expected);
}

TEST(FlowRounds, OwnMemoryThatIsNotThere) {
  Story story(R"(board M = unit 1 board 0
task A start
step S
  read D10 count 2 from M at 60000
  M0 = failed
  write D10 to M at 60000
  when failed goto T
step T
  goto T
)");
  story.set("D10", 5).run();
  EXPECT_EQ(story.get("M0"), 1);
  EXPECT_EQ(story.get("D10"), 5);
  EXPECT_EQ(story.rounds().counters().failed, 2);
  story.run();
  EXPECT_EQ(story.at(), "T");
}

constexpr std::string_view kRemote = R"(board PANEL = unit 1 board 1 panel exclusive
board FAR = unit 2 board 0
task A start
step S
  read D10 count 2 from PANEL at 20
  D0 = D0 + 1
  M0 = failed
  write D20 to FAR at 5
  when failed goto BAD
  when X0 goto GOOD
step GOOD
  goto GOOD
step BAD
  goto BAD
task B start
step S
  D1 = D1 + 1
  goto S
)";

TEST(FlowRounds, OthersGoOnWhileATaskWaits) {
  Story story(kRemote);
  FlowRounds& rounds = story.rounds();
  story.set("D20", 77).run(3);
  EXPECT_EQ(story.get("D0"), 0);
  EXPECT_EQ(story.get("D1"), 3);
  EXPECT_TRUE(story.task().waits);
  EXPECT_EQ(story.task().state, FlowState::Load);
  ASSERT_EQ(rounds.requests().size(), 1U);
  const FlowRequest read = rounds.requests()[0];
  EXPECT_FALSE(read.write);
  EXPECT_EQ(read.transfer.first, 20);
  EXPECT_EQ(read.transfer.count, 2);
  rounds.complete(read.id, 0, {300, -4});
  EXPECT_EQ(story.get("D10"), 0);  // in its turn only
  story.run();
  EXPECT_EQ(story.get("D10"), 300);
  EXPECT_EQ(story.get("D11"), -4);
  EXPECT_EQ(story.get("D0"), 1);
  EXPECT_EQ(story.get("M0"), 0);
  EXPECT_EQ(story.task().state, FlowState::Store);
  ASSERT_EQ(rounds.requests().size(), 1U);
  const FlowRequest write = rounds.requests()[0];
  EXPECT_TRUE(write.write);
  EXPECT_EQ(write.words, (std::vector<std::int16_t>{77}));
  EXPECT_EQ(story.at(), "S");
  rounds.complete(write.id, 0);
  story.set("X0", 1).run();  // the conditions
  EXPECT_EQ(story.at(), "GOOD");
  EXPECT_EQ(story.get("D1"), 5);
}

TEST(FlowRounds, FailedIsAskedBehindTheWrite) {
  for (const int of_read : {0, 1}) {
    for (const int of_write : {0, 2}) {
      Story story(kRemote);
      FlowRounds& rounds = story.rounds();
      story.set("D10", 5).run();
      rounds.complete(rounds.requests().at(0).id, of_read, {6, 7});
      story.run();
      EXPECT_EQ(story.get("M0"), of_read);
      EXPECT_EQ(story.get("D10"), of_read == 0 ? 6 : 5);
      rounds.complete(rounds.requests().at(0).id, of_write);
      story.set("X0", 1).run();
      EXPECT_EQ(story.at(), of_read + of_write == 0 ? "GOOD" : "BAD");
      EXPECT_EQ(rounds.counters().failed, (of_read != 0 ? 1 : 0) + (of_write != 0 ? 1 : 0));
    }
  }
}

// No condition holds behind the write: all of it again.
TEST(FlowRounds, TheWholeStepIsDoneAgain) {
  Story story(kRemote);
  FlowRounds& rounds = story.rounds();
  story.run();
  for (int i = 0; i < 3; ++i) {
    rounds.complete(rounds.requests().at(0).id, 0, {1, 2});
    story.run();
    rounds.complete(rounds.requests().at(0).id, 0);
    story.run(2);
    EXPECT_FALSE(rounds.requests().at(0).write);
  }
  EXPECT_EQ(story.get("D0"), 3);
}

TEST(FlowRounds, AnExclusiveBoardIsHeldUntilTheStepEnds) {
  Story story(R"(board PANEL = unit 1 board 1 panel exclusive
task A start
step S
  read D10 from PANEL at 1
  write D10 to PANEL at 2
step U
step V
  goto S
task B start
step S
  D1 = D1 + 1
step T
  read D20 from PANEL at 3
)");
  FlowRounds& rounds = story.rounds();
  story.run(3);  // B's read finds it held
  ASSERT_EQ(rounds.requests().size(), 1U);
  EXPECT_EQ(rounds.requests()[0].task, 0U);
  EXPECT_EQ(rounds.counters().held, 2);
  rounds.complete(rounds.requests()[0].id, 0, {9});
  story.run();
  EXPECT_TRUE(rounds.requests().at(0).write);
  EXPECT_EQ(rounds.counters().held, 3);
  rounds.complete(rounds.requests()[0].id, 0);
  story.run(2);
  ASSERT_EQ(rounds.requests().size(), 1U);
  EXPECT_EQ(rounds.requests()[0].task, 1U);
}

TEST(FlowRounds, WithoutABlockATaskTriesAgain) {
  std::string text = "board FAR = unit 2 board 0\n";
  for (int i = 0; i < 18; ++i) {
    text += "task T" + std::to_string(i) + " start\nstep S\nread D" + std::to_string(i) +
            " from FAR at 0\nwait X0\n";
  }
  Story story(text);
  FlowRounds& rounds = story.rounds();
  story.run();
  EXPECT_EQ(rounds.requests().size(), 16U);
  EXPECT_EQ(rounds.counters().pool_full, 2);
  rounds.complete(rounds.requests()[3].id, 0, {33});
  story.run();
  EXPECT_EQ(story.get("D3"), 33);
  // The round began with task 1, so that task 3 was done before task 16 had its turn.
  EXPECT_EQ(rounds.requests().size(), 16U);
  EXPECT_EQ(rounds.requests().back().task, 16U);
  EXPECT_EQ(rounds.counters().pool_full, 3);
}

TEST(FlowRounds, DataForATaskThatWasStoppedVanish) {
  Story story(R"(board PANEL = unit 1 board 1 panel exclusive
task MAIN start
step S
  stop A if X0
  start A if X1
  goto S
task A start
step S
  read D10 from PANEL at 1
  wait X7
)");
  FlowRounds& rounds = story.rounds();
  story.run();
  const int first = rounds.requests().at(0).id;
  story.set("X0", 1).run();
  EXPECT_FALSE(story.task(1).started);
  // It starts anew; the board is still held by the request that nobody waits for.
  story.set("X0", 0).set("X1", 1).run(2);  // in the second one, A's turn comes first
  EXPECT_EQ(rounds.requests().size(), 1U);
  EXPECT_EQ(rounds.counters().held, 1);
  rounds.complete(first, 0, {5});
  EXPECT_EQ(rounds.counters().late, 1);
  story.run();
  EXPECT_EQ(story.get("D10"), 0);
  rounds.complete(rounds.requests().at(0).id, 0, {6});
  story.run();
  EXPECT_EQ(story.get("D10"), 6);
}

}  // namespace
}  // namespace rung::flowchart
