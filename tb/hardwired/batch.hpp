// SPDX-License-Identifier: Apache-2.0
// Many hard-wired programs side by side in one Verilog file, so that one Verilated model runs them
// all: Verilator and the compiler take longer to begin than for a program of this size. The top,
// `hardwired_batch`, has each port of each program behind that of the one before.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "agree/case.hpp"
#include "hardwired/verilog.hpp"

namespace rung::tb {

struct Subject {
  std::string name;    // "random-17"
  std::string replay;  // what makes it again, for a reader
  Case what;
};

// Where a program's bits begin in the ports of the top.
struct Offsets {
  int in = 0, clocks = 0, ticks = 0, out = 0, state = 0;
};
struct Placed : Offsets {
  hardwired::Module module;
};

class Batch {
 public:
  // Throws std::runtime_error for a program that is refused.
  explicit Batch(const std::vector<Subject>& subjects, double step_ns = hardwired::kDefaultStepNs);

  const std::vector<Placed>& modules() const { return modules_; }
  std::string verilog() const;

 private:
  std::vector<Placed> modules_;
  Offsets widths_;  // of the top's ports
};

// Random lists of all instructions and of the basic ones, random LDmicro programs, the stand-in
// samples, the programs of tb/golden, and, where they are there, programs that nobody here wrote.
std::vector<Subject> all_subjects();
// Some of them, for every `make test`.
std::vector<Subject> agree_subjects();
// Random rungs of bits on few devices.
std::vector<Subject> exhaustive_subjects();
// The subjects of a set: "all", "agree" or "exhaustive".
std::vector<Subject> subjects_of(const std::string& set);

}  // namespace rung::tb
