// SPDX-License-Identifier: Apache-2.0
// rung-steps: the text of reports/steps.md.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>

#include "paper/reproduce.hpp"
#include "programs/samples.hpp"

namespace {

using namespace rung;

constexpr int kSeeds = 20;

// Table 8 of the paper: steps on MPU1, MPU2 and MPU3.
constexpr int kTable8[3][3] = {{1425, 1046, 530}, {834, 542, 272}, {454, 317, 192}};

void figures() {
  static constexpr const char* kNames[] = {"Figure 14, MPU1", "Figure 15, MPU2", "Figure 16, MPU3"};
  fmt::print("## Figures 14 to 16\n\nThe eleven instructions of Figure 14 with `--paper`.\n");
  for (int mpu = 1; mpu <= 3; ++mpu) {
    const auto steps = paper::figure_steps(static_cast<isa::Mpu>(mpu));
    fmt::print("\n{}: {} steps\n\n```\n", kNames[mpu - 1], steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      std::string line = fmt::format("{:2}  {:<32}", i + 1, fmt::join(steps[i], "  |  "));
      if (steps[i].size() == 2)
        line = fmt::format("{:2}  {:<32}{}", i + 1, steps[i][0], steps[i][1]);
      line.erase(line.find_last_not_of(' ') + 1);
      fmt::print("{}\n", line);
    }
    fmt::print("```\n");
  }
}

void tables() {
  fmt::print(
      "\n## Table 1: runs of contacts in Figure 2\n\n| contacts in a row | runs |\n|---|---|\n");
  auto runs = paper::table1();
  for (int length = 1; length <= 3; ++length) fmt::print("| {} | {} |\n", length, runs[length]);

  const auto rows = paper::table7();
  fmt::print(
      "\n## Tables 6 and 7: look-ups of a run, and of Sample 1\n\n"
      "| contacts in a row | look-ups (Table 6) | runs | contacts | look-ups (Table 7) |\n"
      "|---|---|---|---|---|\n");
  paper::Table7Row sum;
  for (const auto& [length, row] : rows) {
    fmt::print("| {} | {} | {} | {} | {} |\n", length, paper::lookups_of_run(length), row.runs,
               row.contacts, row.lookups);
    sum.runs += row.runs;
    sum.contacts += row.contacts;
    sum.lookups += row.lookups;
  }
  fmt::print("| sum | | {} | {} | {} |\n", sum.runs, sum.contacts, sum.lookups);
}

void formula() {
  fmt::print(
      "\n## Section 6: look-ups of m operands\n\n"
      "1 for n <= m contacts, else ceil((n - m) / (m - 1)) + 1, summed over the runs; steps of an "
      "MPU2 with such look-ups.\nThe LUT would have the opcodes of Table 2 for m operands: 2 x "
      "5^(m-1) functions.\n\n"
      "| sample | contacts | m = 2 look-ups, steps | m = 3 | m = 4 |\n|---|---|---|---|---|\n");
  for (int sample = 1; sample <= 3; ++sample) {
    const SampleShape& shape = sample_shape(sample);
    fmt::print("| {} | {} |", sample, shape.contacts());
    for (int m = 2; m <= 4; ++m) {
      int lookups = 0;
      for (const auto& [length, count] : shape.runs)
        lookups += count * mapping::run_lookups(length, m);
      fmt::print(" {}, {} |", lookups, shape.instructions() - shape.contacts() + lookups);
    }
    fmt::print("\n");
  }
}

// "530 (526 to 533)": median, minimum and maximum.
template <typename T, typename F>
std::string spread(const std::vector<T>& all, F&& of) {
  std::vector<double> values;
  for (const auto& one : all) values.push_back(static_cast<double>(of(one)));
  std::sort(values.begin(), values.end());
  const double median = (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
  if (values.front() == values.back()) return fmt::format("{}", median);
  return fmt::format("{} ({} to {})", median, values.front(), values.back());
}

void table8() {
  fmt::print(
      "\n## Table 8: steps of the samples\n\n"
      "The programs of the paper are not public. These are stand-ins made by "
      "`tb/programs/samples.cpp`: the paper's numbers of\ninstructions, contacts and look-ups, for "
      "Sample "
      "1 its histogram of runs; the mix of outputs is ours. Density is the chance\nthat a contact "
      "or a "
      "word operand is a device that an earlier rung writes. Seeds 1 to {}: median (minimum to "
      "maximum).\n"
      "Lower bound: the larger of half the operations and the longest chain of dependences.\n\n"
      "| sample | density | MPU1 | MPU2 | MPU3 `--paper` | lower bound | median above it | the "
      "paper's "
      "MPU1, MPU2, MPU3 | MPU2 default | MPU3 default | lower bound | clocks a scan, MPU3 "
      "`--paper` | "
      "default |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
      kSeeds);
  for (int sample = 1; sample <= 3; ++sample) {
    for (const int density : kDensities) {
      std::vector<paper::SampleSteps> all;
      for (int seed = 1; seed <= kSeeds; ++seed) {
        all.push_back(paper::sample_steps(sample, density, seed));
      }
      const int* theirs = kTable8[sample - 1];
      fmt::print("| {} | {} % | {} | {} | {} | {} | {} | {}, {}, {} | {} | {} | {} | {} | {} |\n",
                 sample, density, spread(all, [](const auto& s) { return s.mpu1; }),
                 spread(all, [](const auto& s) { return s.mpu2; }),
                 spread(all, [](const auto& s) { return s.mpu3; }),
                 spread(all, [](const auto& s) { return s.bound; }),
                 spread(all, [](const auto& s) { return s.mpu3 - s.bound; }), theirs[0], theirs[1],
                 theirs[2], spread(all, [](const auto& s) { return s.mpu2_default; }),
                 spread(all, [](const auto& s) { return s.mpu3_default; }),
                 spread(all, [](const auto& s) { return s.bound_default; }),
                 spread(all, [](const auto& s) { return s.mpu3_clocks; }),
                 spread(all, [](const auto& s) { return s.mpu3_default_clocks; }));
    }
  }
}

void write_ports() {
  fmt::print(
      "\n## Two write ports: XOR banks or home banks\n\n"
      "Steps of MPU3, default mode, if any slot may write any device (XOR banks, as built) and if "
      "the "
      "slot of the first rung\nthat writes a device is the only one that may (home banks: fewer "
      "block "
      "RAMs, but rungs that share a coil share a slot).\nSeeds 1 to {}, median (minimum to "
      "maximum).\n\n"
      "| sample | density | XOR banks | home banks |\n|---|---|---|---|\n",
      kSeeds);
  for (int sample = 1; sample <= 3; ++sample) {
    for (const int density : kDensities) {
      std::vector<paper::WritePortSteps> all;
      for (int seed = 1; seed <= kSeeds; ++seed) {
        all.push_back(paper::write_port_steps(sample, density, seed));
      }
      fmt::print("| {} | {} % | {} | {} |\n", sample, density,
                 spread(all, [](const auto& s) { return s.xor_banks; }),
                 spread(all, [](const auto& s) { return s.home_banks; }));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: rung-steps DATE\n");
    return 2;
  }
  fmt::print(
      "# Steps\n\nMade by `make steps` on {} with the compiler of this commit; configuration "
      "ecp5.\n\n",
      argv[1]);
  figures();
  tables();
  formula();
  table8();
  write_ports();
  return 0;
}
