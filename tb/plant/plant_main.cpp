// SPDX-License-Identifier: Apache-2.0
// rung-plant MINUTES: each plant with the controller for that time, as a table for
// reports/plant.md; exit code 1 at a difference.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "plant/controlled_plant.hpp"

int main(int argc, char** argv) {
  using namespace rung::tb;
  const int minutes = argc > 1 ? std::atoi(argv[1]) : 0;
  if (minutes <= 0 || argc != 2) {
    fmt::print(stderr, "usage: rung-plant MINUTES\n");
    return 2;
  }
  constexpr std::uint64_t kSeed = 1;
  PlantRun run;
  run.plant_ms = std::int64_t{minutes} * 60'000;
  fmt::print(
      "| plant | plant time, min | scans | clocks of a scan, least | most | as compiled | overruns "
      "| replies "
      "checked | what was done | simulated in, s |\n|---|--:|--:|--:|--:|--:|--:|--:|---|--:|\n");
  int code = 0;
  std::uint64_t clocks_per_ms = 0;
  for (const auto& plant : {make_crossing(kSeed), make_conveyor(kSeed)}) {
    const auto start = std::chrono::steady_clock::now();
    const PlantResult result = run_plant(*plant, run);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    clocks_per_ms = result.clocks_per_ms;
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.0f} |\n", plant->name(), minutes,
               result.scans, result.least_clocks, result.most_clocks, result.expected_clocks,
               result.overruns, result.polls, plant->work(), seconds);
    std::fflush(stdout);
    if (!result.difference.empty()) {
      fmt::print(stderr, "{}: {}\n", plant->name(), result.difference);
      code = 1;
    }
  }
  fmt::print("\nA millisecond is {} clocks; a scan every {} ms; seed {}.\n", clocks_per_ms,
             run.period_ms, kSeed);
  return code;
}
