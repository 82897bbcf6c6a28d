// SPDX-License-Identifier: Apache-2.0
// `rung translate --to verilog`: a program as hard-wired logic (README.md).
#pragma once

#include <optional>
#include <string>

#include "hardwired/plan.hpp"

namespace rung::hardwired {

struct Options {
  std::string name = "rung_program";  // of the module
  double step_ns = kDefaultStepNs;    // longest estimated path of a program with words
};

struct Module {
  std::string text;  // the file
  Interface interface;
  int clocks = 0;         // of a scan
  std::size_t holds = 0;  // registers beside those of the devices
};

// Nothing, with an error, when the program would be larger than any FPGA.
std::optional<Module> to_verilog(const Program& program, const Options& options,
                                 Diagnostics& diagnostics);

}  // namespace rung::hardwired
