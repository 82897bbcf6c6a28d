// SPDX-License-Identifier: Apache-2.0
// The bound of a round, against sums made by hand.
#include <nlohmann/json.hpp>

#include "flow_compile/support.hpp"
#include "load/flow_bound.hpp"
#include "load/load_file.hpp"

namespace rung::tb {
namespace {

using load::FlowBound;
using load::FlowClocks;
using load::Phases;

// Powers of ten apart, so that a sum shows what it is made of.
FlowClocks clocks() {
  FlowClocks c;
  c.round = 1;
  c.turn = 1'000;
  c.suspend = 10'000;
  c.resume = 100'000;
  c.copy = 1'000'000;
  c.copy_word = 2;
  c.own = 10'000'000;
  c.own_word = 3;
  c.command = 100'000'000;
  c.command_word = 1'000'000'000;
  return c;
}

// Routine clocks that are round numbers.
image::Image image() {
  image::Image image;
  image.clocks = 507;
  image::FlowImage flow;
  flow.boards = {{"memory", 1, 0, false, false, false},
                 {"panel", 1, 3, true, true, true},
                 {"other", 2, 5, true, false, false}};
  flow.transfers = {{0, 0, 5, 0}, {1, 0, 4, 0}, {2, 0, 32, 0}};
  const auto step = [&](int task, int read, int write, std::int64_t routine) {
    image::FlowStep& each = flow.steps.emplace_back();
    each.name = "s" + std::to_string(flow.steps.size() - 1);
    each.task = task;
    each.read = read;
    each.write = write;
    each.clocks = routine;
  };
  flow.tasks = {{"plain", 0, true}, {"own", 2, true}, {"link", 4, false}};
  step(0, 0, 0, 17);
  step(0, 0, 0, 23);
  step(1, 1, 0, 10);
  step(1, 1, 1, 9);
  step(2, 0, 0, 50);
  step(2, 2, 0, 11);
  step(2, 3, 2, 8);
  image.flow = flow;
  return image;
}

TEST(FlowBoundSum, TurnsOfSteps) {
  const FlowBound bound = load::flow_bound(image(), {}, clocks());
  const std::int64_t turns[] = {
      1'000 + 17,
      1'000 + 23,
      1'000 + (10'000'000 + 3 * 5) + 10,
      1'000 + 2 * (10'000'000 + 3 * 5) + 9,
      1'000 + 100'000 + 50,  // the step before it may have stored
      1'000 + 100'000 + (1'000'000 + 2 * 4) + 11,
      1'000 + 100'000 + (1'000'000 + 2 * 32) + 8 + (1'000'000 + 2 * 4) + 10'000,
  };
  ASSERT_EQ(bound.steps.size(), std::size(turns));
  for (std::size_t i = 0; i < std::size(turns); ++i) EXPECT_EQ(bound.steps[i].turn, turns[i]) << i;
  EXPECT_EQ(bound.steps[1].routine, 23);
  ASSERT_EQ(bound.tasks.size(), 3U);
  const int worst[] = {1, 3, 6};
  for (std::size_t task = 0; task < 3; ++task) {
    EXPECT_EQ(bound.tasks[task].worst_step, worst[task]);
    EXPECT_EQ(bound.tasks[task].turn, turns[worst[task]]);
  }
  EXPECT_EQ(bound.turns, turns[1] + turns[3] + turns[6]);
}

TEST(FlowBoundSum, ARequestThatTakesLongerThanTheStepCounts) {
  FlowClocks c = clocks();
  c.suspend = 50'000'000;
  const FlowBound bound = load::flow_bound(image(), {}, c);
  EXPECT_EQ(bound.steps[5].turn, 1'000 + 100'000 + 50'000'000);
  EXPECT_EQ(bound.steps[2].turn, 1'000 + 10'000'015 + 10);
}

// The hardware takes them one after the other when the routine has ended.
TEST(FlowBoundSum, StartsAndStopsCount) {
  image::Image with = image();
  with.flow->task_word = 7;
  isa::SlotInstruction other;
  other.opcode = isa::Opcode::Mv;
  other.rd = 6;
  isa::SlotInstruction command = other;
  command.rd = 7;
  isa::SlotInstruction test;
  test.opcode = isa::Opcode::Set;
  with.steps = {{other, command}, {command, command}, {test, other}};
  with.flow->steps[0].end = 2;
  with.flow->steps[1].entry = 2;
  with.flow->steps[1].end = 3;
  FlowClocks c = clocks();
  c.starts = 100;
  c.start = 5;
  FlowBound bound = load::flow_bound(with, {}, c);
  EXPECT_EQ(bound.steps[0].turn, 1'000 + 17 + 100 + 5 * 3);
  EXPECT_EQ(bound.steps[1].turn, 1'000 + 23);
  // No more than the hardware takes.
  with.steps.assign(2, std::vector<isa::SlotInstruction>(2 * flow::flow_task_commands, command));
  with.steps.push_back({other});
  bound = load::flow_bound(with, {}, c);
  EXPECT_EQ(bound.steps[0].turn, 1'000 + 17 + 100 + 5 * flow::flow_task_commands);
}

TEST(FlowBoundSum, RoundAndResponse) {
  Phases phases;
  phases.latch = 11;
  phases.scan = 4;
  phases.refresh = 7;
  phases.exchange = 2050;
  phases.pins = 6;
  phases.filter = 900;
  const FlowBound bound = load::flow_bound(image(), phases, clocks());
  EXPECT_EQ(bound.command_count, 9);  // eight in the ring and the PC's
  EXPECT_EQ(bound.commands, 9 * (100'000'000 + 32 * std::int64_t{1'000'000'000}));
  const std::int64_t flow = 1 + bound.commands + bound.turns;
  EXPECT_EQ(bound.flow(), flow);
  const std::int64_t round = flow + 507 + 4 + 11 + 7 + 2050;
  EXPECT_EQ(bound.round(), round);
  EXPECT_EQ(bound.response(1), 2 * round + 6 + 900);
  EXPECT_EQ(bound.response(3), 4 * round + 6 + 900);
  phases.period = 2 * round;
  EXPECT_EQ(load::flow_bound(image(), phases, clocks()).response(1), 4 * round + 6 + 900);
}

TEST(FlowBoundSum, TurnsOfAPath) {
  const image::FlowImage flow = *image().flow;
  EXPECT_EQ(load::turns_of(flow, {}), 0);
  EXPECT_EQ(load::turns_of(flow, {0, 1}), 2);
  EXPECT_EQ(load::turns_of(flow, {2, 3}), 2);  // its own memory is there at once
  EXPECT_EQ(load::turns_of(flow, {4, 5, 6}), 5);
}

TEST(FlowBoundSum, TheTablesConstantsCount) {
  const FlowBound bound = load::flow_bound(image());
  const FlowClocks c;
  EXPECT_GT(c.turn, 0);
  EXPECT_EQ(bound.steps[0].turn, c.turn + 17);
  EXPECT_EQ(bound.commands, 9 * (c.command + 32 * c.command_word));
  EXPECT_EQ(bound.overhead, c.round);
}

// Of a compiled program, its routines' clocks are the schedule's; what surrounds them is the
// controller's.
TEST(FlowBoundSum, OfACompiledProgramWithItsMap) {
  const image::Image image = image_of(example().chart);
  Diagnostics diagnostics;
  const io::Subject subject = load::subject_of(image);
  const auto bindings = io::bind(io::default_map(subject, diagnostics), subject, diagnostics);
  const load::Timing timing = load::timing_of(image, bindings, 25'000'000);
  const FlowBound bound = load::flow_bound(image, load::phases_of(timing, image));
  EXPECT_EQ(bound.round(), timing.cycle);
  EXPECT_EQ(bound.flow(), timing.flow);
  for (std::size_t i = 0; i < bound.steps.size(); ++i) {
    EXPECT_EQ(bound.steps[i].routine, image.flow->steps[i].clocks);
  }
  // An output that the ladder drives follows a little sooner than the exchange ends.
  EXPECT_EQ(bound.response(1), timing.worst + timing.exchange);
  EXPECT_LT(timing.best, timing.worst - timing.period - timing.flow + 1);

  const std::string text = load::to_string(bound, *image.flow, 25'000'000);
  for (const std::string& part :
       {std::string("fill"), std::string("s1 (1)"), std::string("all 2 tasks"),
        "round: " + std::to_string(bound.round()) + " clocks (",
        "input to output in 1 turn: " + std::to_string(bound.response(1)) + " clocks ("}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  const auto json = load::to_json(bound, *image.flow, 25'000'000);
  EXPECT_EQ(json["round_clocks"], bound.round());
  EXPECT_EQ(json["response_clocks"], bound.response(1));
  EXPECT_EQ(json["further_turn_clocks"], bound.round());
  EXPECT_EQ(json["steps"].size(), 3U);
  EXPECT_EQ(json["steps"][2]["turn_clocks"], bound.steps[2].turn);
  EXPECT_EQ(json["tasks"][1]["worst_step_name"], "s2");
}

}  // namespace
}  // namespace rung::tb
