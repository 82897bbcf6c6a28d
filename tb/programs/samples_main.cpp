// SPDX-License-Identifier: Apache-2.0
// rung-samples: prints a stand-in for one of the paper's sample programs.
#include <CLI/CLI.hpp>
#include <iostream>

#include "programs/samples.hpp"

int main(int argc, char** argv) {
  CLI::App app("A stand-in for one of the paper's sample programs", "rung-samples");
  int sample = 1;
  int density = 30;
  std::uint64_t seed = 1;
  app.add_option("--sample", sample, "1, 2 or 3")->check(CLI::Range(1, 3))->capture_default_str();
  app.add_option("--density", density, "percent of operands that an earlier rung writes")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  std::cout << rung::sample_program(sample, density, seed);
  return 0;
}
