// SPDX-License-Identifier: Apache-2.0
#include "flow_units/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

namespace rung::tb {
namespace {

constexpr double kPollMs = 2;           // the input board's two equal reads, 1 ms apart
constexpr double kClocksPerUs = 100;    // of a processor at 100 MHz
constexpr double kSampledGoalUs = 100;  // (c), at most, with 100 tasks
constexpr std::string_view kModeNames[] = {"waiting", "suspended", "sampled"};

// The paper's Tables 1 and 2, in ms: scenario, then 1, 10, 30, 50 tasks.
struct PaperRow {
  std::array<double, 4> least, most;
};
constexpr std::array<PaperRow, 6> kTable1{{
    {{1.19, 1.47, 2.34, 3.16}, {2.23, 3.15, 5.34, 7.88}},
    {{1.15, 1.46, 2.32, 3.22}, {2.26, 3.11, 5.50, 8.04}},
    {{1.17, 1.45, 2.30, 3.16}, {2.29, 3.23, 5.60, 7.88}},
    {{1.20, 34.00, 28.90, 34.00}, {34.80, 100.80, 100.80, 100.00}},
    {{1.19, 1.46, 2.46, 3.40}, {2.29, 3.13, 5.44, 7.84}},
    {{1.24, 34.80, 34.80, 35.20}, {34.80, 100.40, 99.60, 100.80}},
}};
constexpr std::array<PaperRow, 6> kTable2{{
    {{1.16, 1.45, 2.26, 3.14}, {2.25, 3.11, 5.44, 7.92}},
    {{1.17, 1.50, 2.32, 3.14}, {2.28, 3.18, 5.06, 7.96}},
    {{1.16, 1.50, 2.28, 3.14}, {2.26, 3.18, 5.56, 7.96}},
    {{1.19, 1.52, 2.28, 3.20}, {2.26, 3.20, 5.58, 8.60}},
    {{1.16, 1.74, 2.26, 3.18}, {2.24, 3.24, 5.58, 7.54}},
    {{1.19, 1.52, 2.32, 3.20}, {2.25, 3.24, 5.56, 8.12}},
}};

std::optional<std::pair<double, double>> paper(FlowMode mode, int scenario, int tasks) {
  const auto& rows = mode == FlowMode::Waiting ? kTable1 : kTable2;
  const PaperRow& row = rows.at(static_cast<std::size_t>(scenario - 1));
  for (std::size_t i = 0; i < row.least.size(); ++i) {
    if (kTaskCounts[i] == tasks) return std::pair{row.least[i], row.most[i]};
  }
  return {};
}

double microseconds(std::uint64_t clocks) { return static_cast<double>(clocks) / kClocksPerUs; }
double bound_ms(const FlowResult& result) {
  return kPollMs + static_cast<double>(result.bound_clocks) / (1000 * kClocksPerUs);
}

}  // namespace

FlowReport::FlowReport(const std::vector<FlowResult>& results) {
  for (const FlowResult& result : results) {
    results_[{result.mode, result.scenario, result.tasks}] = result;
  }
}

const FlowResult* FlowReport::find(FlowMode mode, int scenario, int tasks) const {
  const auto found = results_.find({mode, scenario, tasks});
  return found == results_.end() ? nullptr : &found->second;
}

std::vector<std::string> FlowReport::failures() const {
  std::vector<std::string> out;
  for (const auto& [key, result] : results_) {
    const std::string where =
        fmt::format("{}, scenario {}, {} tasks", kModeNames[static_cast<int>(result.mode)],
                    result.scenario, result.tasks);
    for (const std::string& complaint : result.complaints) out.push_back(where + ": " + complaint);
    if (result.ladder_min != result.ladder_max) {
      out.push_back(fmt::format("{}: the ladder took {} to {} clocks", where, result.ladder_min,
                                result.ladder_max));
    }
    if (result.mode == FlowMode::Waiting) continue;
    if (result.most_clocks > static_cast<std::uint64_t>(result.bound_clocks)) {
      out.push_back(fmt::format("{}: {} clocks, beyond the bound of {}", where, result.most_clocks,
                                result.bound_clocks));
    }
    if (result.most_round > static_cast<std::uint64_t>(result.round_bound)) {
      out.push_back(fmt::format("{}: a round of {} clocks, beyond the bound of {}", where,
                                result.most_round, result.round_bound));
    }
    if (result.mode == FlowMode::Sampled && microseconds(result.most_clocks) > kSampledGoalUs) {
      out.push_back(fmt::format("{}: {:.1f} us, the goal is {}", where,
                                microseconds(result.most_clocks), kSampledGoalUs));
    }
    if (result.mode == FlowMode::Suspended && milliseconds(result.most) > bound_ms(result)) {
      out.push_back(fmt::format("{}: {:.3f} ms, beyond {:.3f}", where, milliseconds(result.most),
                                bound_ms(result)));
    }
  }
  return out;
}

std::string FlowReport::table(FlowMode mode) const {
  std::string out = "| scenario |";
  for (const int tasks : kTaskCounts)
    out += fmt::format(" {} task{} |", tasks, tasks == 1 ? "" : "s");
  out += "\n|---|" + std::string();
  for ([[maybe_unused]] const int tasks : kTaskCounts) out += "---:|";
  out += "\n";
  for (const FlowScenario& scenario : flow_scenarios()) {
    out += fmt::format("| {} {} |", scenario.number, scenario.title);
    for (const int tasks : kTaskCounts) {
      const FlowResult* result = find(mode, scenario.number, tasks);
      if (result == nullptr) {
        out += " - |";
        continue;
      }
      out += fmt::format(" {:.2f} to **{:.2f}**", milliseconds(result->least),
                         milliseconds(result->most));
      if (mode == FlowMode::Suspended) {
        out += fmt::format("<br>{:.2f} + {} clocks, bound {:.2f} ({})", result->most.polled_ms,
                           result->most.clocks, bound_ms(*result), result->bound_clocks);
      } else {
        out += fmt::format("<br>{:.2f} + {:.2f} + {} clocks", result->most.polled_ms,
                           result->most.waited_ms, result->most.clocks);
      }
      if (const auto theirs = paper(mode, scenario.number, tasks)) {
        out += fmt::format("<br>paper {:.2f} to {:.2f}", theirs->first, theirs->second);
      }
      out += " |";
    }
    out += "\n";
  }
  return out;
}

std::string FlowReport::sampled_table() const {
  std::string out = "| scenario |";
  for (const int tasks : kTaskCounts)
    out += fmt::format(" {} task{} |", tasks, tasks == 1 ? "" : "s");
  out += "\n|---|";
  for ([[maybe_unused]] const int tasks : kTaskCounts) out += "---:|";
  out += "\n";
  for (const FlowScenario& scenario : flow_scenarios()) {
    out += fmt::format("| {} {} |", scenario.number, scenario.title);
    for (const int tasks : kTaskCounts) {
      const FlowResult* result = find(FlowMode::Sampled, scenario.number, tasks);
      out +=
          result == nullptr
              ? " - |"
              : fmt::format(" {:.1f} to **{:.1f}**<br>bound {:.1f} |",
                            microseconds(result->least_clocks), microseconds(result->most_clocks),
                            microseconds(static_cast<std::uint64_t>(result->bound_clocks)));
    }
    out += "\n";
  }
  return out;
}

std::string FlowReport::markdown(const std::string& date, std::uint64_t seed,
                                 double seconds) const {
  std::string out = "# Flow tasks: the paper's experiment\n\n";
  int inputs = 0, inputs_waiting = 0;
  std::int64_t ladder = 0;
  for (const auto& [key, result] : results_) {
    (result.mode == FlowMode::Waiting ? inputs_waiting : inputs) = result.inputs;
    ladder = result.ladder_clocks;
  }
  out += fmt::format(
      "Made by `make flow-report` on {}, seed {}, {:.0f} s. MPU3 with the sizes of the ECP5, "
      "simulated by Verilator; a simulated "
      "millisecond has {} clocks (a board at 100 MHz has 100,000). Beside the tasks runs a ladder "
      "of {} clocks (two stand-ins of the "
      "paper's Sample 1), in every round. {} inputs a cell ({} with suspension off), by turns up "
      "and down, each at a random phase. A response is from the edge at "
      "the pin to the edge at the output's pin: the polling part in simulated ms, and the clocks "
      "after it at 100 MHz; least to **most**; in (a) the panel's delay, which the processor waits "
      "for, is simulated ms too. PC and "
      "panel are pymodbus programs on pseudo-terminals; the panel answers after 25 to 95 simulated "
      "ms, and the simulation holds its clock for both. Nothing here has run on a board.\n\n",
      date, seed, seconds, flow_clocks_per_ms(), ladder, inputs, inputs_waiting);
  out +=
      "The task is Figure 6 of the paper: one step that sees the input, one that sets the "
      "output.\n\n";
  out +=
      "## (b) Steps give the processor up while they wait; inputs polled at 1 ms with two equal "
      "reads\n\nms. The bound is 2 ms of polling and "
      "what the compiler prints (clocks in brackets). Goal: within it at every number of tasks; "
      "the paper's own goal was 5 ms.\n\n";
  out += table(FlowMode::Suspended);
  out +=
      "\n## (c) The same with inputs sampled in every round\n\nMicroseconds at 100 MHz. Goal: at "
      "most 100 with 100 tasks.\n\n";
  out += sampled_table();
  out +=
      "\n## (a) Suspension off: the paper's Table 1\n\nms: polling, waiting for the panel, clocks. "
      "What "
      "waits holds everything up: scenarios 4 and 6.\n\n";
  out += table(FlowMode::Waiting);
  out +=
      "\n## Rounds\n\n| mode | scenario | tasks | longest round, clocks | bound | PC commands | "
      "event commands | panel answers |\n|---|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const auto& [key, result] : results_) {
    out += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} | {} |\n", kModeNames[static_cast<int>(result.mode)],
        result.scenario, result.tasks, result.most_round,
        result.mode == FlowMode::Waiting ? std::string("none") : std::to_string(result.round_bound),
        result.pc_commands, result.event_commands, result.panel_answers);
  }
  return out;
}

std::string FlowReport::json(const std::string& date, std::uint64_t seed) const {
  nlohmann::ordered_json out;
  out["date"] = date;
  out["seed"] = seed;
  out["clocks_per_ms"] = flow_clocks_per_ms();
  for (const auto& [key, result] : results_) {
    nlohmann::ordered_json cell;
    cell["mode"] = kModeNames[static_cast<int>(result.mode)];
    cell["scenario"] = result.scenario;
    cell["tasks"] = result.tasks;
    cell["inputs"] = result.inputs;
    cell["least_ms"] = milliseconds(result.least);
    cell["most_ms"] = milliseconds(result.most);
    cell["most_polled_ms"] = result.most.polled_ms;
    cell["most_waited_ms"] = result.most.waited_ms;
    cell["least_clocks"] = result.least_clocks;
    cell["most_clocks"] = result.most_clocks;
    if (result.mode != FlowMode::Waiting) {
      cell["bound_clocks"] = result.bound_clocks;
      cell["round_bound"] = result.round_bound;
    }
    cell["most_round"] = result.most_round;
    cell["ladder_clocks"] = result.ladder_clocks;
    out["cells"].push_back(std::move(cell));
  }
  return out.dump(1) + "\n";
}

}  // namespace rung::tb
