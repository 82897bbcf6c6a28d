// SPDX-License-Identifier: Apache-2.0
// rung-soak BOARD SEED SCANS [LEAST MOST]: one chunk of `make soak`, with LEAST to MOST scans of
// each program; its counts as a JSON object on standard output, exit code 1 and the difference in
// it where there is one.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "soak/session.hpp"

namespace {

using rung::tb::Swap;

// A reset and a power cut among thirty programs: after each of them the controller's start alone
// takes as long as some ten thousand scans.
std::vector<Swap> usual_swaps(std::uint64_t seed) {
  std::vector<Swap> swaps;
  for (int i = 0; i < 2; ++i) {
    swaps.insert(swaps.end(), {Swap::Running, Swap::Stopped, Swap::Again, Swap::Running,
                               Swap::WrongCrc, Swap::Running, Swap::Trip, Swap::Running,
                               Swap::Damaged, Swap::Stopped, Swap::Running, Swap::Again,
                               Swap::Running, Swap::Trip, i == 0 ? Swap::Reset : Swap::Power});
  }
  // A chunk has fewer programs than that: each seed begins somewhere else.
  const auto first = static_cast<std::ptrdiff_t>(seed * 7 % swaps.size());
  std::rotate(swaps.begin(), swaps.begin() + first, swaps.end());
  return swaps;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4 && argc != 6) {
    fmt::print(stderr, "usage: rung-soak BOARD SEED SCANS [LEAST MOST]\n");
    return 2;
  }
  rung::tb::SoakOptions options;
  options.board = argv[1];
  options.seed = std::strtoull(argv[2], nullptr, 10);
  options.scans = std::atoll(argv[3]);
  if (argc == 6) {
    options.least_scans = std::atoll(argv[4]);
    options.most_scans = std::atoll(argv[5]);
  }
  options.swaps = usual_swaps(options.seed);
  const auto start = std::chrono::steady_clock::now();
  const rung::tb::SoakResult result = rung::tb::run_soak(options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  nlohmann::ordered_json chunk{{"board", options.board},
                               {"seed", options.seed},
                               {"scans_asked", options.scans},
                               {"seconds", seconds.count()},
                               {"difference", result.difference}};
  for (const auto& [name, count] : result.counts) chunk["counts"][name] = count;
  fmt::print("{}\n", chunk.dump());
  return result.difference.empty() ? 0 : 1;
}
