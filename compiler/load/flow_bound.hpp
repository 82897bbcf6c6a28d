// SPDX-License-Identifier: Apache-2.0
// The worst case of a round of flow tasks (hdl/flow/README.md), and of the response to an input, in
// clocks. Every routine's clocks are exact; what the task hardware adds is in hdl/isa/flow.toml,
// [clocks].
//
//   turn of a step = switch
//                  + resume, if its task has any transfer over a link
//                  + the longer of suspend (its read over a link is sent) and
//                    [copy of its read] + routine + [starts + start * its starts and stops]
//                    + [copy of its write] + [suspend, over a link]
//   round = round + (events of a full ring + the PC's) * (command + command_word * block_words)
//         + the sum over the tasks of their longest turn
//         + ladder + latch + refresh + exchange
//   response after n turns = (n + 1) * the longer of round and the minimum period + pins + filter
//
// A copy is copy + copy_word * count, of the unit's own memory own + own_word * count. No task has
// more than one turn in a round. An input that changes just behind the latch is seen by the next
// one, within a round; the turn that sees it is in that round, and the outputs leave at its end.
// Each further turn on the way (a further step, a further look at a condition, going on when data
// have come) is in the round after at the latest; what passes through the ladder on the way counts
// as one turn more. The time in which a link or panel has the data is not in it, and with
// suspension off there is no bound.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "load/latency.hpp"
#include "rung_flow.hpp"

namespace rung::load {

struct FlowClocks {
  std::int64_t round = flow::clocks_round;
  std::int64_t turn = flow::clocks_switch;
  std::int64_t suspend = flow::clocks_suspend;
  std::int64_t resume = flow::clocks_resume;
  std::int64_t copy = flow::clocks_copy;
  std::int64_t copy_word = flow::clocks_copy_word;
  std::int64_t own = flow::clocks_own;
  std::int64_t own_word = flow::clocks_own_word;
  std::int64_t starts = flow::clocks_starts;
  std::int64_t start = flow::clocks_start;
  std::int64_t command = flow::clocks_command;
  std::int64_t command_word = flow::clocks_command_word;
};

// What surrounds the flow in a round; all 0 if it is not known.
struct Phases {
  std::int64_t latch = 0;
  std::int64_t scan = 0;  // of the controller around the ladder's routine
  std::int64_t refresh = 0;
  std::int64_t exchange = 0;
  std::int64_t period = 0;  // from latch to latch at least
  std::int64_t pins = 0;    // from an input's pin to the latch and from the refresh to a pin
  std::int64_t filter = 0;  // of the slowest input
};
Phases phases_of(const Timing& timing, const image::Image& image);

struct FlowBound {
  struct Step {
    std::int64_t routine = 0;
    std::int64_t turn = 0;
  };
  struct Task {
    std::string name;
    int worst_step = 0;
    std::int64_t turn = 0;  // of that step
  };
  std::vector<Step> steps;
  std::vector<Task> tasks;
  std::int64_t overhead = 0;
  int command_count = 0;
  std::int64_t commands = 0;  // of all of them
  std::int64_t turns = 0;     // of all tasks
  std::int64_t ladder = 0;    // its routine
  Phases phases;

  // What the flow adds to a scan.
  std::int64_t flow() const { return overhead + commands + turns; }
  std::int64_t round() const {
    return flow() + ladder + phases.scan + phases.latch + phases.refresh + phases.exchange;
  }
  // From an input's edge to the output that follows in the n-th turn that has to do with it, n
  // >= 1.
  std::int64_t response(int turns_needed) const;
};

// Of an image with flow tasks.
FlowBound flow_bound(const image::Image& image, const Phases& phases = {},
                     const FlowClocks& clocks = {});

// Turns that a task takes to go through `path`: one a step, and one more for a step whose read is
// over a link.
int turns_of(const image::FlowImage& flow, const std::vector<int>& path);

// As a table for people, and as one object; times where `clock_hz` is not 0.
std::string to_string(const FlowBound& bound, const image::FlowImage& flow, std::int64_t clock_hz);
nlohmann::ordered_json to_json(const FlowBound& bound, const image::FlowImage& flow,
                               std::int64_t clock_hz);

}  // namespace rung::load
