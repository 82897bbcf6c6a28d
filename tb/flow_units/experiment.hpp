// SPDX-License-Identifier: Apache-2.0
// The experiment of the FA controller paper (section 4) on our controllers: how long after a change
// of its input a flow task changes its output, with 1 to 100 tasks beside a ladder, while other
// units, a PC and a touch panel want things.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "flow_units/probe.hpp"

namespace rung::tb {

// Section 4.2.
struct FlowScenario {
  int number = 1;
  std::string title;
  bool pc = false;
  enum class Sub : std::uint8_t {
    None,
    Memory,
    Panel
  } sub = Sub::None;  // what a second unit asks the first for
};
const std::vector<FlowScenario>& flow_scenarios();

enum class FlowMode : std::uint8_t {
  Waiting,    // (a): steps and commands wait in their place, the paper's Table 1
  Suspended,  // (b): they give the processor up, the paper's Table 2
  Sampled,    // (c): as (b), with inputs sampled in every round instead of polled
};

// The ladder beside the tasks.
enum class FlowLadder {
  Paper,  // some 1,000 clocks
  Short,  // one rung: starting a unit is most of what a test simulates, and takes as long as its
          // program
};

struct FlowResult {
  int scenario = 1;
  int tasks = 1;
  FlowMode mode = FlowMode::Suspended;
  int inputs = 1000;
  FlowResponse least, most;
  std::uint64_t least_clocks = 0,
                most_clocks = 0;  // of the processor's part, wherever they were found
  std::int64_t bound_clocks = 0;  // of it, as the compiler prints it
  std::int64_t round_bound = 0;
  std::uint64_t most_round = 0;
  std::int64_t ladder_clocks = 0;
  std::uint32_t ladder_min = 0, ladder_max = 0;  // as the controller counted them
  std::int64_t pc_commands = 0, event_commands = 0, panel_answers = 0;
  std::vector<std::string> complaints;
};

// Runs the scenarios one behind the other on the same two units: one mode and number of tasks, and
// of each as many inputs. Where a scenario has one unit, the link is cut. Throws std::runtime_error
// if something is not as it should be.
std::vector<FlowResult> run_flow_cells(FlowMode mode, int tasks, int inputs, std::uint64_t seed,
                                       const std::vector<int>& scenarios = {1, 2, 3, 4, 5, 6},
                                       FlowLadder ladder = FlowLadder::Paper);
// Of the simulation.
std::uint64_t flow_clocks_per_ms();

// The programs, for the report and tests: the unit that is measured, and the one below it.
std::string measured_program(int tasks, const std::string& ladder_file);
// It asks for 8 words of unit 1's memory without end while its X0 is on, of its panel while X1 is.
std::string asking_program();

}  // namespace rung::tb
