// SPDX-License-Identifier: Apache-2.0
// Answers and events that come at any time, in any order: no word is lost, mixed up or seen twice,
// no round takes longer than the bound, and in the end every block and board is free. Replay one:
// RUNG_SEED=n flow_test --gtest_filter='*AnyTime*'
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <map>
#include <random>
#include <set>

#include "flow/clocks.hpp"
#include "flow/rig.hpp"

namespace rung::tb::flow {
namespace {

using namespace rung::flow;

constexpr int kPairs = 25;   // tasks with two steps each
constexpr int kOthers = 10;  // with one

class Traffic {
 public:
  Traffic(Rig& rig, std::uint32_t seed) : rig_(rig), random_(seed) {}

  void play() {
    const Program program = pairs();
    rig_.reset();
    rig_.load(program);
    rig_.answer = [this](const Request& request) { return carry_out(request); };
    rig_.first();
    rig_.idle(clocks::kWalk);
    const int ladder = static_cast<int>(program.ladder.size()) + clocks::kRoutine + clocks::kPorts;
    const std::int64_t bound = clocks::bound(program).round();
    for (int n = 0; n < 60 && !testing::Test::HasFailure(); ++n) {
      if (below(2) == 0) event();
      if (below(3) == 0) pc();
      const Round round = rig_.round();
      EXPECT_LE(round.clocks, bound) << "the bound of a round";
      EXPECT_EQ(round.ladder, ladder);
      check(round);
      rig_.idle(below(60));
    }
    EXPECT_GT(loads_, 50);
    EXPECT_GT(stores_, 30);
    EXPECT_GT(alone_, 3);
    settle();
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  // Step 2n of task n loads a word and logs it with the status, step 2n + 1 stores it; the board is
  // another one for each task, by the transfer's first variable.
  Program pairs() {
    Program program;
    program.boards = usual_boards();
    program.ladder = {set(200, 1), set(201, 2), set(202, 3)};
    for (int n = 0; n < kPairs; ++n) {
      const bool alone = below(4) == 0 || n < 3;
      Transfer t{kUnit, alone ? kAlone : kSlow, n, 1, kFirstData + n};
      if (below(3) == 0 && n >= 3) t.unit = 6;
      const int number = program.add(t);
      program.steps.push_back(
          {{log(n), copy(kLog, kFirstData + n), copy(kLog, kStatusWord), next(2 * n + 1)},
           number,
           0});
      program.steps.push_back({{log(256 + n), next(2 * n)}, 0, number});
      program.tasks.push_back({2 * n, true});
    }
    // Those that always run; one of them starts what runs already.
    for (int n = kPairs; n < kPairs + kOthers; ++n) {
      Step step{{log(1000), next(n + kPairs)}, 0, 0};
      const Transfer own{kUnit, kMemory, 0, 1 + below(flow_block_words), kFirstData + kPairs};
      if (below(2) == 0) step.before = program.add(own);
      if (below(2) == 0) step.after = program.add(own);
      for (int i = n == kPairs ? flow_task_commands : 0; i > 0; --i) {
        step.routine.push_back(start(kPairs + below(kOthers)));
      }
      program.steps.push_back(step);
      program.tasks.push_back({n + kPairs, true});
    }
    return program;
  }

  Answer carry_out(const Request& r) {
    if (r.block < flow_task_blocks) {
      if (r.panel && r.board == kAlone) {
        const auto all = rig_.outstanding();
        EXPECT_EQ(std::count_if(
                      all.begin(), all.end(),
                      [](const Request& other) { return other.panel && other.board == kAlone; }),
                  1)
            << "two at a board that cannot be shared";
        ++alone_;
      }
      if (r.write) {
        ++stores_;
        EXPECT_EQ(r.words, std::vector<std::uint16_t>{last_[r.first]})
            << "STORE of task " << r.first;
        return {below(600), below(6) == 0 ? 1 : 0, {}};
      }
    }
    Answer answer{below(600), below(6) == 0 ? 1 : 0, {}};
    for (int i = 0; i < r.count && !r.write; ++i) {
      answer.words.push_back(static_cast<std::uint16_t>(random_()));
    }
    if (r.block < flow_task_blocks) coming_[r.first].push_back(answer);
    return answer;
  }

  // Three words logged in a row are a LOAD: task, word, status.
  void check(const Round& round) {
    std::vector<int> log;
    for (const Write& write : round.writes) {
      if (write.word == kLog) log.push_back(write.value);
    }
    int others = 0;
    for (std::size_t i = 0; i < log.size();) {
      const int task = log[i];
      others += task == 1000;
      if (task == 1000 || task >= 256) {
        ++i;
        continue;
      }
      ASSERT_LT(i + 2, log.size());
      ASSERT_FALSE(coming_[task].empty()) << "data that nobody sent, task " << task;
      const Answer answer = coming_[task].front();
      coming_[task].pop_front();
      if (answer.status == 0) last_[task] = answer.words[0];
      EXPECT_EQ(log[i + 1], last_[task]) << "task " << task;
      EXPECT_EQ(log[i + 2], answer.status) << "task " << task;
      ++loads_;
      i += 3;
    }
    EXPECT_EQ(others, kOthers) << "each of the others, once a round";
    for (const Reply& reply : round.replies) {
      ASSERT_TRUE(asked_.contains(reply.tag)) << "a reply nobody waits for";
      const Event event = asked_[reply.tag];
      asked_.erase(reply.tag);
      EXPECT_EQ(reply.to, event.from);
      EXPECT_EQ(reply.write, event.write);
      if (event.board == kMemory) {
        EXPECT_EQ(reply.status, 0);
      }
    }
  }

  void event() {
    if (asked_.size() > 200) return;
    Event event;
    event.write = below(2) != 0;
    event.board = below(2) == 0 ? kMemory : kSlow;
    event.count = 1 + below(event.write && event.board == kMemory ? 4 : flow_block_words);
    event.first = event.board == kMemory ? below(kPoints - event.count) : 100;
    event.from = 1 + below(15);
    event.tag = tag_++ % 256;
    if (event.write) event.words.assign(static_cast<std::size_t>(event.count), 7);
    asked_[event.tag] = event;
    rig_.send(event);
  }

  void pc() {
    rig_.bus_write(reg_flow_pc_resource, below(2) == 0 ? kUnit << 8 | kMemory : 9 << 8);
    rig_.bus_write(reg_flow_pc_first, below(30));
    rig_.bus_write(reg_flow_pc_count, 1 + below(flow_block_words));
    rig_.bus_write(reg_flow_pc_control, 1);
  }

  // A program's start while all is under way; then one with a task for each block.
  void settle() {
    rig_.first();
    rig_.idle(clocks::kWalk);
    Program program;
    program.boards = usual_boards();
    for (int n = 0; n < flow_task_blocks; ++n) {
      program.steps.push_back(
          {{log(n)}, program.add({kUnit, n == 0 ? kAlone : kSlow, n, 1, 20}), 0});
      program.tasks.push_back({n, true});
    }
    rig_.drain();
    rig_.load(program);
    rig_.first();
    rig_.idle(clocks::kWalk);
    rig_.answer = [](const Request& r) {
      return Answer{r.block < flow_task_blocks ? -1 : 0, 0, {}};
    };
    std::size_t replies = 0;
    for (int n = 0; n < 3; ++n) {
      const Round round = rig_.round();
      replies += round.replies.size();
      rig_.drain();
      EXPECT_EQ(rig_.bus_read(reg_flow_pc_control), 0);
    }
    EXPECT_EQ(replies, asked_.size()) << "events without a reply";
    std::set<int> blocks;
    for (const Request& request : rig_.held()) blocks.insert(request.block);
    EXPECT_EQ(blocks.size(), static_cast<std::size_t>(flow_task_blocks)) << "blocks are lost";
  }

  Rig& rig_;
  std::mt19937 random_;
  std::map<int, std::deque<Answer>> coming_;  // to LOADs, by task
  std::map<int, std::uint16_t> last_;         // word that a task has
  std::map<int, Event> asked_;                // by tag
  int alone_ = 0;                             // requests to kAlone
  int tag_ = 0;
  int loads_ = 0;
  int stores_ = 0;
};

class AnyTime : public testing::TestWithParam<isa::Mpu> {};

TEST_P(AnyTime, RandomTraffic) {
  const char* given = std::getenv("RUNG_SEED");
  const char* many = std::getenv("RUNG_COUNT");
  const auto number = [](const char* text) { return static_cast<std::uint32_t>(std::atol(text)); };
  const std::uint32_t first = given != nullptr ? number(given) : 1;
  const std::uint32_t count = given != nullptr ? 1 : many != nullptr ? number(many) : 4;
  const auto rig = make_rig(GetParam());
  for (std::uint32_t seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(fmt::format("replay: RUNG_SEED={} flow_test --gtest_filter='*AnyTime*'", seed));
    EXPECT_NO_THROW(Traffic(*rig, seed).play());
    if (HasFailure()) break;
  }
}

INSTANTIATE_TEST_SUITE_P(Flow, AnyTime, testing::Values(isa::Mpu::Mpu2, isa::Mpu::Mpu3),
                         [](const auto& info) {
                           return fmt::format("Mpu{}", static_cast<int>(info.param));
                         });

}  // namespace
}  // namespace rung::tb::flow
