// SPDX-License-Identifier: Apache-2.0
// rung-plant MINUTES: each plant with the controller for that time, as a table for
// reports/plant.md; exit code 1 at a difference.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "plant/controlled_plant.hpp"

namespace {

constexpr std::uint64_t kSeed = 1;

void print_head(const rung::tb::PlantRun& run, int minutes, const char* date) {
  fmt::print(R"(# Plants in simulation

Made by `make plant MINUTES={}`, {}. The controller of board `{}`, Verilated, drives each plant
(`tb/plant`) through its pins, with the firmware on its micro-sequencer and its program started from the flash. A scan
every {} ms; input filters of two samples a millisecond apart; at most 64 points a request; a Modbus client
asks again as soon as it is answered (at the bytes of the line, 16 clocks each). In every scan all outputs are compared with the reference
interpreter's, and the clock in which the scan begins with the period. Every reply has to be what the reference had
after one scan between request and reply. The first difference would end the run.

)",
             minutes, date, run.board, run.period_ms);
  fmt::print(
      "| plant | plant time, min | scans | clocks of a scan: least | most | as compiled | overruns "
      "| replies "
      "checked | differences | work | simulated in, s "
      "|\n|---|--:|--:|--:|--:|--:|--:|--:|--:|---|--:|\n");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace rung::tb;
  const int minutes = argc == 3 ? std::atoi(argv[1]) : 0;
  if (minutes <= 0) {
    fmt::print(stderr, "usage: rung-plant MINUTES DATE\n");
    return 2;
  }
  PlantRun run;
  run.plant_ms = std::int64_t{minutes} * 60'000;
  print_head(run, minutes, argv[2]);
  std::uint64_t clocks_per_ms = 0;
  for (const auto& plant : {make_crossing(kSeed), make_conveyor(kSeed)}) {
    const auto start = std::chrono::steady_clock::now();
    const PlantResult result = run_plant(*plant, run);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!result.difference.empty()) {
      fmt::print(stderr, "{}: {}\n", plant->name(), result.difference);
      return 1;
    }
    clocks_per_ms = result.clocks_per_ms;
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | 0 | {} | {:.0f} |\n", plant->name(),
               minutes, result.scans, result.least_clocks, result.most_clocks,
               result.expected_clocks, result.overruns, result.polls, plant->work(), seconds);
  }
  fmt::print("\nA simulated millisecond is {} clocks. Seed of both plants: {}.\n", clocks_per_ms,
             kSeed);
  return 0;
}
