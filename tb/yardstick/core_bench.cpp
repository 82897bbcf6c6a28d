// SPDX-License-Identifier: Apache-2.0
// Bench of a Verilated soft core: counts the clocks between the marks that core_main.c writes and
// prints one JSON object {"empty", "cold", "warm", "checksum"}; clocks include the marks' own
// ("empty").
//
// usage: bench +ram=FILE      (the program as hexadecimal words)
// exit: 1 if the program does not finish.
#include <fmt/core.h>
#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "Vyard.h"

namespace {

enum Mark : std::uint32_t { kStart = 0, kEnd = 1, kChecksum = 2, kFinish = 3 };
constexpr int kKinds = 3;
constexpr std::uint64_t kClockLimit = 2'000'000'000;

std::string summary(std::vector<std::uint64_t> clocks) {
  if (clocks.empty()) return "null";
  std::sort(clocks.begin(), clocks.end());
  return fmt::format(R"({{"count": {}, "min": {}, "median": {}, "max": {}}})", clocks.size(),
                     clocks.front(), clocks[clocks.size() / 2], clocks.back());
}

}  // namespace

int main(int argc, char** argv) {
  const auto context = std::make_unique<VerilatedContext>();
  context->commandArgs(argc, argv);
  const auto dut = std::make_unique<Vyard>(context.get());

  std::vector<std::uint64_t> clocks[kKinds];
  std::uint64_t now = 0;
  std::uint64_t start = 0;
  std::uint32_t checksum = 0;
  bool finished = false;
  while (!finished && now < kClockLimit) {
    dut->clk_i = 1;
    dut->eval();
    if (dut->mark_valid_o) {
      const std::uint32_t data = dut->mark_data_o;
      switch (dut->mark_addr_o) {
        case kStart:
          start = now;
          break;
        case kEnd:
          if (data < kKinds) clocks[data].push_back(now - start);
          break;
        case kChecksum:
          checksum = data;
          break;
        case kFinish:
          finished = true;
          break;
        default:
          fmt::print(stderr, "unknown mark {}\n", dut->mark_addr_o);
          return EXIT_FAILURE;
      }
    }
    dut->clk_i = 0;
    dut->eval();
    ++now;
  }
  dut->final();
  if (!finished) {
    fmt::print(stderr, "the program did not finish within {} clocks\n", kClockLimit);
    return EXIT_FAILURE;
  }
  fmt::print(R"({{"empty": {}, "cold": {}, "warm": {}, "checksum": {}}})"
             "\n",
             summary(clocks[0]), summary(clocks[1]), summary(clocks[2]), checksum);
  return EXIT_SUCCESS;
}
