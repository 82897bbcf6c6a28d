// SPDX-License-Identifier: Apache-2.0
// Random programs beside the model of rounds: what routines write, requests, replies, counters and
// states, in every round. What comes from outside comes between rounds here, so that the
// model knows when; elsewhere (traffic_test.cpp) it comes at any time.
// Replay one: RUNG_SEED=n flow_test --gtest_filter='*RandomPrograms*'
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "flow/clocks.hpp"
#include "flow/model.hpp"

namespace rung::tb::flow {
namespace {

using namespace rung::flow;

std::string text(const std::vector<Write>& writes) {
  std::string text;
  for (const Write& w : writes) text += fmt::format(" {}<-{}", w.word, w.value);
  return text;
}
std::string text(const std::vector<Request>& requests) {
  std::string text;
  for (const Request& r : requests) {
    text += fmt::format(" [{} block {} {} {}.{} {}+{}", r.panel ? "panel" : "link", r.block,
                        r.write ? "write" : "read", r.unit, r.board, r.first, r.count);
    for (const auto word : r.words) text += fmt::format(" {}", word);
    text += "]";
  }
  return text;
}
std::string text(const std::vector<Reply>& replies) {
  std::string text;
  for (const Reply& r : replies) {
    text += fmt::format(" [{} {} {} to {} tag {}", r.write ? "write" : "read", r.status, r.count,
                        r.to, r.tag);
    for (const auto word : r.words) text += fmt::format(" {}", word);
    text += "]";
  }
  return text;
}

// What is not held for the test to decide: the answer depends on the request alone.
Answer at_once(const Request& r) {
  Answer answer;
  answer.delay = r.first * 3;
  answer.status = r.first % 5 == 4 ? 1 : 0;
  for (int i = 0; i < r.count && !r.write && answer.status == 0; ++i) {
    answer.words.push_back(static_cast<std::uint16_t>(r.first * 100 + r.unit * 10 + i));
  }
  return answer;
}

class Story {
 public:
  Story(Rig& rig, std::uint32_t seed) : rig_(rig), random_(seed) {}

  // What has happened, so that no test is one of nothing.
  const Counters& seen() const { return seen_; }

  void play() {
    const int tasks = below(4) == 0 ? flow_tasks : 1 + below(12);
    const bool in_place = below(6) == 0;
    const Program program = random_program(random_, tasks, in_place);
    rig_.reset();
    rig_.load(program);
    Model model(program);
    const auto held = [=](const Request& r) {
      return !in_place && !(r.panel && r.board == kInPlace);
    };
    rig_.answer = [=](const Request& r) { return held(r) ? Answer{-1, 0, {}} : at_once(r); };
    model.answer = at_once;
    for (int i = 0; i < flow_block_words; ++i) rig_.bus_write(reg_flow_pc_data + i, 0);
    rig_.first();
    const std::int64_t bound = clocks::bound(program).round();
    const int rounds = 6 + below(8);
    for (int n = 0; n < rounds && !testing::Test::HasFailure(); ++n) {
      SCOPED_TRACE(fmt::format("round {}", n));
      outside(model, tasks, static_cast<int>(program.steps.size()));
      const Expected expected = model.round();
      const Round round = rig_.round();
      EXPECT_EQ(text(round.writes), text(expected.writes));
      EXPECT_EQ(text(round.requests), text(expected.requests));
      EXPECT_EQ(text(round.replies), text(expected.replies));
      const bool awaited = std::any_of(round.requests.begin(), round.requests.end(),
                                       [=](const Request& r) { return in_place || !held(r); });
      if (!awaited) {
        EXPECT_LE(round.clocks, bound) << "the bound of a round";
      }
      compare(model, tasks);
    }
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  void outside(Model& model, int tasks, int steps) {
    std::vector<Request> held = rig_.held();
    for (std::size_t i = 0; i < held.size();) {
      if (below(3) == 0) {
        ++i;
        continue;
      }
      Answer answer;
      answer.status = below(8) == 0 ? 1 + below(2) : 0;
      if (!held[i].write && answer.status == 0) {
        for (int k = 0; k < held[i].count; ++k) {
          answer.words.push_back(static_cast<std::uint16_t>(random_()));
        }
      }
      model.come(held[i].block, answer);
      rig_.release(i, answer);
      rig_.drain();
      held.erase(held.begin() + static_cast<std::ptrdiff_t>(i));
    }
    while (free_events_ > 0 && below(3) == 0) event(model);
    pc_command(model);
    if (below(4) == 0) {
      const int step = below(steps);
      const bool on = below(2) != 0;
      rig_.bus_write(reg_flow_break_step, step);
      rig_.bus_write(reg_flow_break, on ? 1 : 0);
      if (on)
        model.breakpoints.insert(step);
      else
        model.breakpoints.erase(step);
    }
    if (below(3) == 0) {
      const int task = below(tasks);
      const bool go = below(4) != 0;
      rig_.bus_write(reg_flow_task, task);
      rig_.bus_write(reg_flow_task_continue, go ? 1 : 0);
      if (go)
        model.go_on(task);
      else
        model.ask(task);
    }
    if (below(20) == 0) {
      model.first();
      rig_.first();
    }
    rig_.idle(4);
  }

  void event(Model& model) {
    Event event;
    event.write = below(2) != 0;
    constexpr int kBoards[] = {kMemory,      kMemory, kSlow, kAlone,
                               kAloneMemory, kNobody, 33,    kInPlace};
    event.board = kBoards[below(8)];
    event.count = 1 + below(6);
    event.first = below(kPoints + 2 - event.count);
    event.from = 1 + below(15);
    event.tag = below(256);
    if (event.write) {
      for (int i = 0; i < event.count; ++i) {
        event.words.push_back(static_cast<std::uint16_t>(random_()));
      }
    }
    model.receive(event, model.lowest_event_block());
    rig_.send(event);
    rig_.drain();
    free_events_ = model.free_event_blocks();
  }

  void pc_command(Model& model) {
    if (model.pc.state == 0 && below(3) == 0) {
      Transfer t;
      constexpr int kBoards[] = {kMemory, kSlow, kAlone, kNobody, kInPlace};
      t.board = kBoards[below(5)];
      t.count = below(20) == 0 ? below(2) * 40 : 1 + below(flow_block_words);
      t.first = below(kPoints);
      if (below(3) == 0) t.unit = 1 + below(15);
      model.pc.transfer = t;
      model.pc.write = below(2) != 0;
      for (int i = 0; i < flow_block_words; ++i) {
        const auto word = static_cast<std::uint16_t>(random_());
        rig_.bus_write(reg_flow_pc_data + i, word);
        model.blocks[flow_pc_block][static_cast<std::size_t>(i)] = word;
      }
      rig_.bus_write(reg_flow_pc_resource, t.unit << 8 | t.board);
      rig_.bus_write(reg_flow_pc_first, t.first);
      rig_.bus_write(reg_flow_pc_count, t.count);
      rig_.bus_write(reg_flow_pc_control, 1 | (model.pc.write ? 2 : 0));
      model.pc.state = 1;
    }
  }

  void compare(Model& model, int tasks) {
    EXPECT_EQ(rig_.bus_read(reg_flow_pc_control), model.pc.state);
    EXPECT_EQ(rig_.bus_read(reg_flow_pc_status), model.pc.status);
    if (model.pc.state == 0) {
      for (int i = 0; i < flow_block_words; ++i) {
        EXPECT_EQ(rig_.bus_read(reg_flow_pc_data + i),
                  model.blocks[flow_pc_block][static_cast<std::size_t>(i)])
            << "word " << i << " of the PC's command";
      }
    }
    const Counters& c = model.counters;
    EXPECT_EQ(rig_.bus_read(reg_flow_pool_full), c.full);
    EXPECT_EQ(rig_.bus_read(reg_flow_held), c.held);
    EXPECT_EQ(rig_.bus_read(reg_flow_failed), c.failed);
    EXPECT_EQ(rig_.bus_read(reg_flow_events), c.events);
    EXPECT_EQ(rig_.bus_read(reg_flow_event_waits), c.event_waits);
    EXPECT_EQ(rig_.bus_read(reg_flow_late), 1000 + c.vanished);
    for (int task = 0; task < tasks; ++task) {
      EXPECT_EQ(rig_.state(task), model.state(task)) << "state of task " << task;
      if ((model.state(task) & 4) == 0)
        continue;  // the step of a task that is stopped says nothing
      EXPECT_EQ(rig_.step(task), model.step(task)) << "step of task " << task;
    }
    for (int word = kFirstData; word < kWords; ++word) {
      ASSERT_EQ(rig_.read_word(word), model.words[static_cast<std::size_t>(word)])
          << "word " << word;
    }
    free_events_ = model.free_event_blocks();
    seen_ = c;
  }

  Rig& rig_;
  Counters seen_;
  std::mt19937 random_;
  int free_events_ = flow_event_blocks;
};

class Rounds : public testing::TestWithParam<isa::Mpu> {};

TEST_P(Rounds, RandomPrograms) {
  const char* given = std::getenv("RUNG_SEED");
  const std::uint32_t first = given != nullptr ? static_cast<std::uint32_t>(std::atol(given)) : 1;
  const char* many = std::getenv("RUNG_COUNT");
  const std::uint32_t count = given != nullptr  ? 1
                              : many != nullptr ? static_cast<std::uint32_t>(std::atol(many))
                                                : 40;
  const auto rig = make_rig(GetParam());
  Counters all;
  for (std::uint32_t seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(
        fmt::format("replay: RUNG_SEED={} flow_test --gtest_filter='*RandomPrograms*'", seed));
    Story story(*rig, seed);
    EXPECT_NO_THROW(story.play());
    const Counters& one = story.seen();
    all.full += one.full;
    all.held += one.held;
    all.failed += one.failed;
    all.events += one.events;
    all.event_waits += one.event_waits;
    all.vanished += one.vanished;
    if (HasFailure()) break;
  }
  if (count < 40) return;
  for (const int number :
       {all.full, all.held, all.failed, all.events, all.event_waits, all.vanished}) {
    EXPECT_GT(number, 5);
  }
}

INSTANTIATE_TEST_SUITE_P(Flow, Rounds, testing::Values(isa::Mpu::Mpu2, isa::Mpu::Mpu3),
                         [](const auto& info) {
                           return fmt::format("Mpu{}", static_cast<int>(info.param));
                         });

}  // namespace
}  // namespace rung::tb::flow
