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
constexpr int kTurns =
    2;  // of the task: the step that sees the input, the step that sets the output
constexpr std::uint64_t kSampleSeed = 1, kSecondSampleSeed = 2;
constexpr int kDensity = 30;

std::string map_text(FlowMode mode, bool inputs) {
  const controller::Board& board = *io::find_board("simulated");
  std::string text = fmt::format(
      "board = 'simulated'\n[controller]\nexchange_points = 64\nfilter_us = 1000\nwatchdog_us = 0\n"
      "[modbus]\nbaud = 115200\n[flow]\nsuspend = {}\npanel_unit = {}\n",
      mode != FlowMode::Waiting, kPanelUnit);
  if (inputs) {
    text +=
        fmt::format("[inputs]\nX200 = {{ pin = '{}', filter = {} }}\n[outputs]\nY200 = '{}'\n",
                    board.inputs.front(), mode == FlowMode::Sampled ? 0 : 2, board.outputs.front());
  }
  return text;
}

// Two stand-ins of the paper's Sample 1 one behind the other: some 1,000 clocks on MPU3.
std::string ladder_text() {
  return sample_program(1, kDensity, kSampleSeed) + sample_program(1, kDensity, kSecondSampleSeed);
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

std::string asking_program(FlowScenario::Sub what) {
  return fmt::format(
      "dialect paper\nunit 2\nboard WANTED = unit 1 board {}\ntask ASK start\nstep AGAIN\n"
      "  read D0 count 8 from WANTED at 0\n  D10 = D10 + 1 if not failed\n  goto AGAIN\n",
      what == FlowScenario::Sub::Panel ? 1 : 0);
}

FlowResult run_flow_cell(const FlowCell& cell) {
  const FlowScenario& scenario = flow_scenarios().at(static_cast<std::size_t>(cell.scenario - 1));
  const bool sub = scenario.sub != FlowScenario::Sub::None;
  const Folder folder;
  folder.put("ladder.il", ladder_text());
  const FlowBuilt measured =
      build_flow(folder.put("measured.flow", measured_program(cell.tasks, "ladder.il")),
                 map_text(cell.mode, true));
  FlowSystem system(sub ? 2 : 1, cell.seed);
  system.load(1, measured.words);
  if (sub) {
    const FlowBuilt asking = build_flow(folder.put("asking.flow", asking_program(scenario.sub)),
                                        map_text(FlowMode::Suspended, false));
    system.load(2, asking.words);
  }
  if (scenario.sub == FlowScenario::Sub::Panel)
    system.attach_panel(1, kPanelUnit, kPanelLeastMs, kPanelMostMs);
  if (scenario.pc) system.attach_pc(1, 1, 0, 0, 8);
  system.start();

  FlowResult result;
  result.cell = cell;
  result.least.polled_ms = std::numeric_limits<double>::max();
  result.least_clocks = std::numeric_limits<std::uint64_t>::max();
  result.bound_clocks = measured.bound.response(kTurns);
  result.round_bound = measured.bound.round();
  result.ladder_clocks = measured.bound.ladder;
  FlowProbe probe(system, cell.mode != FlowMode::Sampled, cell.seed);
  for (int i = 0; i < cell.inputs; ++i) {
    const FlowResponse response = probe.input();
    if (milliseconds(response) < milliseconds(result.least)) result.least = response;
    if (milliseconds(response) > milliseconds(result.most)) result.most = response;
    result.least_clocks = std::min(result.least_clocks, response.clocks);
    result.most_clocks = std::max(result.most_clocks, response.clocks);
    if (system.faulted(1)) throw std::runtime_error("the unit is in fault");
  }
  result.most_round = system.most_round_clocks(1);
  if (scenario.pc) {
    result.pc_commands = system.pc_done(1);
  } else {
    result.ladder_min = system.registers(1, flow::reg_flow_ladder_min, 1).at(0);
    result.ladder_max = system.registers(1, flow::reg_flow_ladder_max, 1).at(0);
    result.event_commands = system.registers(1, flow::reg_flow_events, 1).at(0);
  }
  result.panel_answers = system.panel_answers(1);
  result.complaints = system.complaints();
  return result;
}

}  // namespace rung::tb
