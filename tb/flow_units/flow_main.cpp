// SPDX-License-Identifier: Apache-2.0
// rung-flow DATE MARKDOWN JSON: all cells of the experiment. Exit 1 if a bound or goal is missed.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <fstream>
#include <mutex>
#include <thread>

#include "flow_units/report.hpp"

namespace {

using rung::tb::FlowCell;
using rung::tb::FlowMode;

std::vector<FlowCell> all_cells(int inputs, int waiting_inputs, std::uint64_t seed) {
  std::vector<FlowCell> cells;
  for (const FlowMode mode : {FlowMode::Suspended, FlowMode::Sampled, FlowMode::Waiting}) {
    for (const auto& scenario : rung::tb::flow_scenarios()) {
      for (const int tasks : rung::tb::kTaskCounts) {
        const bool waiting = mode == FlowMode::Waiting;
        cells.push_back(
            {scenario.number, tasks, mode, waiting ? waiting_inputs : inputs, seed + cells.size()});
      }
    }
  }
  return cells;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The experiment of flow tasks"};
  std::string date, page, data;
  int inputs = 1000, waiting_inputs = 100, jobs = 2;
  std::uint64_t seed = 1;
  app.add_option("date", date)->required();
  app.add_option("page", page, "markdown to write")->required();
  app.add_option("data", data, "JSON to write")->required();
  app.add_option("--inputs", inputs)->capture_default_str()->check(CLI::Range(1, 1'000'000));
  app.add_option("--waiting-inputs", waiting_inputs, "of each cell with suspension off")
      ->capture_default_str();
  app.add_option("--jobs", jobs)->capture_default_str()->check(CLI::Range(1, 64));
  app.add_option("--seed", seed)->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const auto start = std::chrono::steady_clock::now();
  const std::vector<FlowCell> cells = all_cells(inputs, waiting_inputs, seed);
  std::vector<rung::tb::FlowResult> results(cells.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex say;
  const auto work = [&] {
    for (std::size_t i = next++; i < cells.size() && !failed; i = next++) {
      const FlowCell& cell = cells[i];
      const std::string name =
          fmt::format("{} of {}: mode {}, scenario {}, {} tasks", i + 1, cells.size(),
                      "cba"[2 - static_cast<int>(cell.mode)], cell.scenario, cell.tasks);
      try {
        results[i] = run_flow_cell(cell);
        const std::lock_guard lock(say);
        fmt::print("{}: {:.2f} to {:.2f} ms\n", name, milliseconds(results[i].least),
                   milliseconds(results[i].most));
        std::fflush(stdout);
      } catch (const std::exception& error) {
        const std::lock_guard lock(say);
        fmt::print(stderr, "{} (seed {}): {}\n", name, cell.seed, error.what());
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
  std::ofstream(page) << report.markdown(date, seed, seconds);
  std::ofstream(data) << report.json(date, seed);
  for (const std::string& failure : report.failures()) {
    fmt::print(stderr, "{}\n", failure);
    failed = true;
  }
  return failed ? 1 : 0;
}
