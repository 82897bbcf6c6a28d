// SPDX-License-Identifier: Apache-2.0
// rung-flow DATE MARKDOWN JSON: all of the experiment, or with --only N its Nth mode and number of
// tasks without a report. Exit 1 if a bound or goal is missed.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <mutex>
#include <thread>

#include "flow_units/report.hpp"

namespace {

using rung::tb::FlowMode;
using rung::tb::FlowResult;

constexpr std::string_view kModeLetters = "abc";

// All scenarios of one mode and number of tasks.
struct Group {
  FlowMode mode;
  int tasks, inputs;
  std::uint64_t seed;
};

std::vector<Group> all_groups(const std::string& modes, int inputs, int waiting_inputs,
                              std::uint64_t seed) {
  std::vector<Group> groups;
  std::uint64_t number = 0;
  for (const FlowMode mode : {FlowMode::Suspended, FlowMode::Sampled, FlowMode::Waiting}) {
    for (const int tasks : rung::tb::kTaskCounts) {
      const bool waiting = mode == FlowMode::Waiting;
      const Group group{mode, tasks, waiting ? waiting_inputs : inputs, seed + number++};
      if (modes.find(kModeLetters[static_cast<std::size_t>(mode)]) != std::string::npos)
        groups.push_back(group);
    }
  }
  return groups;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The experiment of flow tasks"};
  std::string date, page, data, modes(kModeLetters);
  int inputs = 1000, waiting_inputs = 50, jobs = 2;
  std::uint64_t seed = 1;
  std::size_t only = 0;
  app.add_option("date", date)->required();
  app.add_option("page", page, "markdown to write")->required();
  app.add_option("data", data, "JSON to write")->required();
  app.add_option("--inputs", inputs)->capture_default_str()->check(CLI::Range(1, 1'000'000));
  app.add_option("--waiting-inputs", waiting_inputs, "of each scenario with suspension off")
      ->capture_default_str();
  app.add_option("--modes", modes, "of a, b and c: a part of the report")->capture_default_str();
  app.add_option("--jobs", jobs)->capture_default_str()->check(CLI::Range(1, 64));
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--only", only,
                 "the one mode and number of tasks to run, numbered as it is printed");
  CLI11_PARSE(app, argc, argv);

  const auto start = std::chrono::steady_clock::now();
  const std::vector<Group> groups = all_groups(modes, inputs, waiting_inputs, seed);
  std::vector<FlowResult> results;
  std::atomic<std::size_t> next = only == 0 ? 0 : only - 1;
  const std::size_t end = only == 0 ? groups.size() : std::min(only, groups.size());
  std::atomic<bool> failed = false;
  std::mutex say;
  const auto work = [&] {
    for (std::size_t i = next++; i < end && !failed; i = next++) {
      const Group& group = groups[i];
      const std::string name =
          fmt::format("{} of {}: mode {}, {} tasks", i + 1, groups.size(),
                      kModeLetters[static_cast<std::size_t>(group.mode)], group.tasks);
      try {
        const auto found =
            rung::tb::run_flow_cells(group.mode, group.tasks, group.inputs, group.seed);
        const std::lock_guard lock(say);
        for (const FlowResult& result : found) {
          fmt::print("{}, scenario {}: {:.3f} to {:.3f} ms\n", name, result.scenario,
                     milliseconds(result.least), milliseconds(result.most));
          results.push_back(result);
        }
        std::fflush(stdout);
      } catch (const std::exception& error) {
        const std::lock_guard lock(say);
        fmt::print(stderr, "{} (seed {}): {}\n", name, group.seed, error.what());
        failed = true;
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < jobs; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (failed) return 1;

  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const rung::tb::FlowReport report(results);
  if (only == 0) {
    std::ofstream(page) << report.markdown(date, seed, seconds);
    std::ofstream(data) << report.json(date, seed);
  }
  for (const std::string& failure : report.failures()) {
    fmt::print(stderr, "{}\n", failure);
    failed = true;
  }
  return failed ? 1 : 0;
}
