// SPDX-License-Identifier: Apache-2.0
// How much a program may have: just as much is taken, and one more is refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace rung::flowchart {
namespace {

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

// Tasks T0, T1, ... of so many steps each.
std::string tasks(int count, int steps, std::string_view line = "D0 = 1\n") {
  std::string text;
  for (int t = 0; t < count; ++t) {
    text += fmt::format("task T{} start\n", t);
    for (int s = 0; s < steps; ++s) text += fmt::format("step S{}\n{}", s, line);
  }
  return text;
}

void expect_message(const std::string& text, std::string_view message) {
  const ReadResult result = read_text_of(text);
  EXPECT_FALSE(result.chart);
  EXPECT_EQ(result.messages, message);
}

TEST(FlowLimits, Tasks) {
  EXPECT_EQ(good(tasks(100, 1)).tasks.size(), 100U);
  expect_message(tasks(101, 1),
                 "t.flow:301:1: error: more than 100 tasks\n"
                 "    let one task do the work of several\n");
}

TEST(FlowLimits, Steps) {
  EXPECT_EQ(good(tasks(100, 20)).steps.size(), 2000U);
  EXPECT_EQ(good(tasks(1, 2000)).steps.size(), 2000U);
  expect_message(tasks(1, 2001),
                 "t.flow:4002:1: error: more than 2000 steps\n"
                 "    put more actions into one step, or share tasks out to another unit\n");
}

TEST(FlowLimits, StepsWithThoseThatAreAdded) {
  // Each is two: what records the time, and the wait.
  EXPECT_EQ(good(tasks(64, 16, "wait 1 s\n")).steps.size(), 2048U);
  expect_message(tasks(64, 16, "wait 1 s\n") + "step U\n",
                 "t.flow:2113:1: error: with what waits, and conditions behind a write, add, the "
                 "program has more than 2048 steps here\n"
                 "    use fewer waits of a time, or wait in steps of their own\n");
}

TEST(FlowLimits, StartsAndStops) {
  const std::string head = "task A start\nstep S\n";
  EXPECT_EQ(good(head + repeated("start A\nstop A if X0\n", 8)).steps.size(), 1U);
  expect_message(head + repeated("start A\nstop A if X0\n", 8) + "stop A\n",
                 "t.flow:19:1: error: more than 16 starts and stops in one step\n"
                 "    begin another step for the others\n");
  // A wait ends a step.
  EXPECT_EQ(
      good(head + repeated("start A\n", 16) + "wait X0\n" + repeated("stop A\n", 16)).steps.size(),
      3U);
}

TEST(FlowLimits, Transfers) {
  std::string text = "board FAR = unit 2 board 0\ntask A start\n";
  for (int i = 0; i < 255; ++i) {
    text += fmt::format("step S{0}\nread D{0} from FAR at 0\n", i);
  }
  // The same one again, and as a write, is none of its own.
  text += "step AGAIN\nread D0 from FAR at 0\nwrite D1 to FAR at 0\n";
  EXPECT_EQ(good(text).steps.size(), 256U);
  expect_message(text + "step MORE\nread D0 from FAR at 1\n",
                 "t.flow:517:1: error: more than 255 different transfers\n"
                 "    use the same words and variables in several steps, or move more words at "
                 "once\n");
}

TEST(FlowLimits, Boards) {
  std::string text;
  for (int unit = 1; unit <= 15; ++unit) {
    for (int board = 0; board < 16; ++board) {
      text += fmt::format("board B{0}_{1} = unit {0} board {1}\n", unit, board);
    }
  }
  EXPECT_EQ(good(text + "task A start\nstep S\n").boards.size(), 240U);
}

TEST(FlowLimits, Nesting) {
  const std::string head = "task A start\nstep S\n";
  const auto nested = [&](int n) {
    return head + "Y0 = " + repeated("(", n) + "X0" + repeated(")", n) + "\n";
  };
  EXPECT_EQ(code(good(nested(49)).steps.at(0)), "LD X0; OUT Y0; LD M8000; MOV K-1 next");
  expect_message(nested(50),
                 "t.flow:3:56: error: more than 50 parentheses and signs inside of each other\n"
                 "    compute a part of it before, into a relay or register\n");
  for (const char* each : {"(", "not ", "-", "not (", "-("}) {
    const ReadResult result = read_text_of(head + "D0 = " + repeated(each, 100'000));
    EXPECT_FALSE(result.chart);
    EXPECT_NE(result.messages.find("more than 50"), std::string::npos) << each;
  }
}

TEST(FlowLimits, Operands) {
  const std::string head = "task A start\nstep S\n";
  EXPECT_EQ(good(head + "D0 = D1" + repeated(" + D1", 99) + "\n").steps.size(), 1U);
  expect_message(head + "D0 = D1" + repeated(" + D1", 100) + "\n",
                 "t.flow:3:506: error: more than 100 devices and numbers in one expression\n"
                 "    compute a part of it before, into a relay or register\n");
}

TEST(FlowLimits, Warnings) {
  ReadResult result = read_text_of(R"(task A start
step S
  end
step T
  goto U
step U
  wait 1 s
)");
  EXPECT_TRUE(result.chart);
  EXPECT_EQ(result.messages,
            "t.flow:4:1: warning: T: no step of task A leads here\n"
            "    remove it, or add the goto that is missing\n"
            "t.flow:6:1: warning: U: no step of task A leads here\n"
            "    remove it, or add the goto that is missing\n");
  result = read_text_of("task A\nstep S\n  start B\ntask B\nstep S\n");
  EXPECT_TRUE(result.chart);
  EXPECT_EQ(result.messages,
            "t.flow:1:6: warning: A: nothing starts this task\n"
            "    write `task A start`, or start it in a step\n");
}

// An error of the ladder is one of the program.
TEST(FlowLimits, FilesThatCannotBeRead) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read("/nowhere/at/all.flow", diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 1);
}

}  // namespace
}  // namespace rung::flowchart
