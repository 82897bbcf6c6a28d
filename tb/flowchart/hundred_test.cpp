// SPDX-License-Identifier: Apache-2.0
// A program of 100 tasks, made from a table, written as text, read back, compared with the table,
// and run beside a plain walk over the table.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "programs/random_source.hpp"
#include "support.hpp"

namespace rung::flowchart {
namespace {

constexpr int kTasks = 100;
constexpr int kMostSteps = 20;

struct PlainStep {
  int add = 0;         // to D of the task's number
  int limit = 0;       // goes to `above` from there on
  int above = -1;      // a step; or no limit
  int otherwise = -1;  // a step; or stays where there is a limit, and else on to the next one
  int starts = -1;     // a task
  int stops = -1;      // another one
  int board = -1;      // of a read of one word
  int variable = 0;
};

struct PlainTask {
  bool starts = false;
  std::vector<PlainStep> steps;
};

using Table = std::array<PlainTask, kTasks>;

Table random_table(std::uint64_t seed) {
  RandomSource random(seed);
  Table table;
  for (PlainTask& task : table) {
    task.starts = random.percent(70);
    task.steps.resize(static_cast<std::size_t>(1 + random.below(kMostSteps)));
    const int steps = static_cast<int>(task.steps.size());
    for (PlainStep& step : task.steps) {
      step.add = random.below(50) - 10;
      step.limit = random.below(2000);
      if (random.percent(60)) step.above = random.below(steps);
      if (random.percent(50)) step.otherwise = random.below(steps);
      if (random.percent(10)) step.starts = random.below(kTasks);
      if (random.percent(5)) step.stops = random.below(kTasks);
      if (random.percent(10)) {
        step.board = random.below(2);
        step.variable = random.below(3);
      }
    }
  }
  return table;
}

std::string written(const Table& table) {
  std::string text = "board OWN = unit 1 board 0\nboard FAR = unit 2 board 7\n";
  for (int t = 0; t < kTasks; ++t) {
    const PlainTask& task = table.at(static_cast<std::size_t>(t));
    text += fmt::format("task TASK_{}{}\n", t, task.starts ? " start" : "");
    for (std::size_t s = 0; s < task.steps.size(); ++s) {
      const PlainStep& step = task.steps[s];
      text += fmt::format("step S{}\n", s);
      if (step.board >= 0) {
        text += fmt::format("  read D{} from {} at {}\n", 200 + t, step.board == 0 ? "OWN" : "FAR",
                            1000 + step.variable);
      }
      text += fmt::format("  D{0} = D{0} + {1}\n", t, step.add);
      if (step.starts >= 0) text += fmt::format("  start TASK_{}\n", step.starts);
      if (step.stops >= 0) text += fmt::format("  stop TASK_{}\n", step.stops);
      if (step.above >= 0) {
        text += fmt::format("  when D{} >= {} goto S{}\n", t, step.limit, step.above);
      }
      if (step.otherwise >= 0) text += fmt::format("  goto S{}\n", step.otherwise);
    }
  }
  return text;
}

// As it is read: the same tasks, steps and transfers in the same order.
void compare(const Table& table, const Flowchart& chart) {
  ASSERT_EQ(chart.tasks.size(), table.size());
  std::size_t n = 0;
  for (std::size_t t = 0; t < table.size(); ++t) {
    EXPECT_EQ(chart.tasks[t].name, fmt::format("TASK_{}", t));
    EXPECT_EQ(chart.tasks[t].starts, table[t].starts);
    EXPECT_EQ(chart.tasks[t].first, n);
    for (std::size_t s = 0; s < table[t].steps.size(); ++s, ++n) {
      const PlainStep& plain = table[t].steps[s];
      const Step& step = chart.steps.at(n);
      EXPECT_EQ(step.name, fmt::format("S{}", s));
      EXPECT_EQ(step.task, t);
      EXPECT_FALSE(step.added || step.write);
      ASSERT_EQ(step.read.has_value(), plain.board >= 0);
      if (step.read) {
        EXPECT_EQ(step.read->board, static_cast<std::size_t>(plain.board));
        EXPECT_EQ(step.read->first, 1000 + plain.variable);
        EXPECT_EQ(step.read->head.number, 200 + t);
      }
    }
  }
  EXPECT_EQ(chart.steps.size(), n);
}

// A walk over the table, a step with each turn; one with a read of FAR takes a turn to ask, and
// its answer comes behind the round.
class Walk {
 public:
  explicit Walk(const Table& table) : table_(table) {
    for (std::size_t t = 0; t < table.size(); ++t) rows_.at(t).started = table[t].starts;
  }

  // One step that a turn executes.
  void turn(std::size_t t) {
    Row& row = rows_.at(t);
    const PlainStep& step = table_.at(t).steps[row.step];
    if (step.board == 1 && !row.asked) {
      row.asked = true;
      return;
    }
    row.asked = false;
    row.sum = static_cast<std::int16_t>(row.sum + step.add);
    const std::size_t behind = row.step + 1;
    bool ends = false;
    if (step.above >= 0 && row.sum >= step.limit) {
      row.step = static_cast<std::size_t>(step.above);
    } else if (step.otherwise >= 0) {
      row.step = static_cast<std::size_t>(step.otherwise);
    } else if (step.above < 0 && behind < table_.at(t).steps.size()) {
      row.step = behind;
    } else {
      ends = step.above < 0;
    }
    bool stopped = false;
    if (step.starts >= 0) start(static_cast<std::size_t>(step.starts));
    if (step.stops >= 0) {
      Row& other = rows_.at(static_cast<std::size_t>(step.stops));
      other.started = other.asked = false;
      stopped = step.stops == static_cast<int>(t);
    }
    if (ends && !stopped) row.started = false;
  }

  std::int16_t sum(std::size_t t) const { return rows_.at(t).sum; }
  bool started(std::size_t t) const { return rows_.at(t).started; }
  std::size_t step(std::size_t t) const { return rows_.at(t).step; }

 private:
  struct Row {
    bool started = false;
    bool asked = false;
    std::size_t step = 0;
    std::int16_t sum = 0;
  };

  void start(std::size_t t) {
    Row& row = rows_.at(t);
    if (row.started) return;
    row.started = true;
    row.asked = false;
    row.step = 0;
  }

  const Table& table_;
  std::array<Row, kTasks> rows_;
};

void run_beside(const Table& table, const Flowchart& chart) {
  Walk walk(table);
  FlowRounds rounds(chart);
  std::size_t turns = 0;
  for (int round = 0; round < 200; ++round) {
    rounds.begin_round();
    std::array<bool, kTasks> had{};
    while (true) {
      const FlowCounters before = rounds.counters();
      const auto task = rounds.turn();
      if (!task) break;
      EXPECT_TRUE(walk.started(*task));
      EXPECT_FALSE(had.at(*task));
      had.at(*task) = true;
      ++turns;
      // Without a block, nothing has happened.
      if (rounds.counters().pool_full == before.pool_full) walk.turn(*task);
    }
    rounds.end_round();
    while (!rounds.requests().empty()) rounds.complete(rounds.requests().front().id, 0, {1});
    for (std::size_t t = 0; t < kTasks; ++t) {
      ASSERT_EQ(rounds.get({DeviceKind::D, static_cast<std::uint32_t>(t)}), walk.sum(t)) << t;
      ASSERT_EQ(rounds.task(t).started, walk.started(t)) << t;
      if (!walk.started(t)) continue;
      ASSERT_EQ(rounds.task(t).step, chart.tasks[t].first + walk.step(t)) << t;
    }
  }
  EXPECT_GT(turns, 1000U);
}

TEST(FlowHundred, ReadsBackAndRuns) {
  const bool alone = std::getenv("RUNG_SEED") != nullptr;
  const std::uint64_t first = from_environment("RUNG_SEED", 0);
  for (std::uint64_t seed = first; seed < first + (alone ? 1 : 3); ++seed) {
    const Table table = random_table(seed);
    const ReadResult result = read_text_of(written(table));
    ASSERT_TRUE(result.chart) << result.messages;
    compare(table, *result.chart);
    run_beside(table, *result.chart);
    if (HasFailure()) {
      FAIL() << "replay: RUNG_SEED=" << seed
             << " build/test/tb/flowchart/unit_flowchart --gtest_filter=FlowHundred.*";
    }
  }
}

}  // namespace
}  // namespace rung::flowchart
