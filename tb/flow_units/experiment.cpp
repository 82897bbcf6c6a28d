// SPDX-License-Identifier: Apache-2.0
#include "flow_units/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "flow_units/probe.hpp"
#include "flow_units/programs.hpp"
#include "flow_units/system.hpp"
#include "io/map.hpp"
#include "programs/samples.hpp"
#include "rung_controller.hpp"
#include "rung_flow.hpp"

namespace rung::tb {
namespace {

// The panel of the paper: answers after tens of milliseconds (its Table 1 shows 30 to 100 with what
// waits for it).
constexpr double kPanelLeastMs = 25, kPanelMostMs = 95;
constexpr int kPanelUnit = 5;
constexpr int kSettleMs = 150;  // longer than the panel takes
constexpr int kTurns =
    2;  // of the task: the step that sees the input, the step that sets the output
constexpr std::uint64_t kSampleSeed = 1, kSecondSampleSeed = 2;
constexpr int kDensity = 30;

std::string map_text(FlowMode mode) {
  return fmt::format(
      "board = 'simulated'\n[controller]\nexchange_points = 64\nfilter_us = 1000\nwatchdog_ms = 0\n"
      "[modbus]\nbaud = 57600\n[flow]\nsuspend = {}\nlink_timeout_ms = 1000\npanel_unit = {}\n"
      "panel_baud = 57600\n",
      mode != FlowMode::Waiting, kPanelUnit);
}

std::string probe_pins(FlowMode mode) {
  const controller::Board& board = *io::find_board("simulated");
  return fmt::format("[inputs]\nX200 = {{ pin = '{}', filter = {} }}\n[outputs]\nY200 = '{}'\n",
                     board.inputs.front(), mode == FlowMode::Sampled ? 0 : 2,
                     board.outputs.front());
}

// Two stand-ins of the paper's Sample 1 one behind the other: some 1,000 clocks on MPU3.
std::string ladder_text(FlowLadder ladder) {
  if (ladder == FlowLadder::Short) return "LDI M0\nOUT M0\nEND\n";
  std::string first = sample_program(1, kDensity, kSampleSeed);
  first.erase(first.rfind("END"));
  return first + sample_program(1, kDensity, kSecondSampleSeed);
}

}  // namespace

const std::vector<FlowScenario>& flow_scenarios() {
  using Sub = FlowScenario::Sub;
  static const std::vector<FlowScenario> all{
      {1, "one unit", false, Sub::None},
      {2, "one unit, commands from the PC", true, Sub::None},
      {3, "a second unit asks for its memory", false, Sub::Memory},
      {4, "a second unit asks for its panel", false, Sub::Panel},
      {5, "as 3, and the PC", true, Sub::Memory},
      {6, "as 4, and the PC", true, Sub::Panel},
  };
  return all;
}

std::uint64_t flow_clocks_per_ms() { return FlowSystem::clocks_per_ms(); }

// Figure 6 of the paper, as many times as there are tasks: the first at the pins, the others on
// relays.
std::string measured_program(int tasks, const std::string& ladder_file) {
  std::string text = fmt::format(
      "dialect paper\nunit 1\nladder \"{}\"\nboard MEMORY = unit 1 board 0\n"
      "board PANEL = unit 1 board 1 panel\n",
      ladder_file);
  for (int n = 0; n < tasks; ++n) {
    const std::string in = n == 0 ? "X200" : fmt::format("M{}", 2000 + 2 * n);
    const std::string out = n == 0 ? "Y200" : fmt::format("M{}", 2001 + 2 * n);
    text += fmt::format(
        "task T{0} start\nstep OFF\n  {2} = off\n  when {1} goto ON\n"
        "step ON\n  {2} = on\n  when not {1} goto OFF\n",
        n, in, out);
  }
  return text;
}

std::string asking_program() {
  std::string text = "dialect paper\nunit 2\n";
  for (int board = 0; board < 2; ++board) {
    text += fmt::format(
        "board WANTED{0} = unit 1 board {0}\ntask ASK{0} start\nstep IDLE\n  when X{0} goto AGAIN\n"
        "step AGAIN\n  read D{1} count 8 from WANTED{0} at 0\n  when X{0} goto AGAIN\n  goto "
        "IDLE\n",
        board, 16 * board);
  }
  // All boards stand before the tasks.
  const std::size_t second = text.find("board WANTED1");
  const std::size_t end = text.find("task", second);
  const std::string board = text.substr(second, end - second);
  text.erase(second, end - second);
  return text.insert(text.find("task"), board);
}
namespace {

class Bench {
 public:
  Bench(FlowMode mode, int tasks, FlowLadder ladder, std::uint64_t seed)
      : mode_(mode), tasks_(tasks), measured_(measured(mode, tasks, ladder)), system_(2, seed) {
    const Folder folder;
    const auto& pins = io::find_board("simulated")->inputs;
    const std::string map = fmt::format("[inputs]\nX0 = '{}'\nX1 = '{}'\n", pins.at(0), pins.at(1));
    system_.load(1, measured_.words);
    system_.load(2, build_flow(folder.put("asking.flow", asking_program()),
                               map_text(FlowMode::Suspended) + map)
                        .words);
    system_.attach_panel(1, kPanelUnit, kPanelLeastMs, kPanelMostMs);
    system_.start();
  }

  FlowResult run(const FlowScenario& scenario, int inputs, std::uint64_t seed) {
    using Sub = FlowScenario::Sub;
    system_.set_fault(1, scenario.sub == Sub::None ? LineFault::Cut : LineFault::None);
    system_.set_input(2, 0, scenario.sub == Sub::Memory);
    system_.set_input(2, 1, scenario.sub == Sub::Panel);
    if (scenario.pc) system_.attach_pc(1, 1, 0, 0, 8);
    settle();

    FlowResult result;
    result.scenario = scenario.number;
    result.tasks = tasks_;
    result.mode = mode_;
    result.inputs = inputs;
    result.least.polled_ms = std::numeric_limits<double>::max();
    result.least_clocks = std::numeric_limits<std::uint64_t>::max();
    result.bound_clocks = measured_.bound.response(kTurns);
    result.round_bound = measured_.bound.round();
    result.ladder_clocks = measured_.bound.ladder;
    system_.forget_most_round(1);
    const std::int64_t answers = system_.panel_answers(1);
    FlowProbe probe(system_, mode_ != FlowMode::Sampled, mode_ == FlowMode::Waiting, seed);
    for (int i = 0; i < inputs || i % 2 != 0; ++i) {
      const FlowResponse response = probe.input();
      if (milliseconds(response) < milliseconds(result.least)) result.least = response;
      if (milliseconds(response) > milliseconds(result.most)) result.most = response;
      result.least_clocks = std::min(result.least_clocks, response.clocks);
      result.most_clocks = std::max(result.most_clocks, response.clocks);
      if (system_.faulted(1)) throw std::runtime_error("the unit is in fault");
    }
    result.most_round = system_.most_round_clocks(1);
    result.panel_answers = system_.panel_answers(1) - answers;
    if (scenario.pc) {
      result.pc_commands = system_.pc_done(1);
      system_.detach_pc(1);
      settle();
    }
    result.complaints = system_.complaints();
    result.ladder_min = system_.registers(1, flow::reg_flow_ladder_min, 1).at(0);
    result.ladder_max = system_.registers(1, flow::reg_flow_ladder_max, 1).at(0);
    const int events = system_.registers(1, flow::reg_flow_events, 1).at(0);
    result.event_commands = (events - events_) & 0xFFFF;
    events_ = events;
    return result;
  }

 private:
  static FlowBuilt measured(FlowMode mode, int tasks, FlowLadder ladder) {
    const Folder folder;
    folder.put("ladder.il", ladder_text(ladder));
    return build_flow(folder.put("measured.flow", measured_program(tasks, "ladder.il")),
                      map_text(mode) + probe_pins(mode));
  }
  // Until what went before has ended, and what is new is under way.
  void settle() { system_.run(static_cast<std::uint64_t>(kSettleMs) * flow_clocks_per_ms()); }

  FlowMode mode_;
  int tasks_;
  FlowBuilt measured_;
  FlowSystem system_;
  int events_ = 0;
};

}  // namespace

std::vector<FlowResult> run_flow_cells(FlowMode mode, int tasks, int inputs, std::uint64_t seed,
                                       const std::vector<int>& scenarios, FlowLadder ladder) {
  Bench bench(mode, tasks, ladder, seed);
  std::vector<FlowResult> results;
  for (const int number : scenarios) {
    results.push_back(
        bench.run(flow_scenarios().at(static_cast<std::size_t>(number - 1)), inputs, seed));
  }
  return results;
}

}  // namespace rung::tb
