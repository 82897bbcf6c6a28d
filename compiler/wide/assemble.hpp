// SPDX-License-Identifier: Apache-2.0
// A schedule with addresses.
#pragma once

#include <map>
#include <vector>

#include "wide/code.hpp"
#include "wide/schedule.hpp"

namespace rung::wide {

// One write of the program, as a trace shows it: the writes of one device in the order of the
// program, which need not be that of their steps, for each has a place of its own.
struct Write {
  int step = 0;
  int lane = 0;
  Device device;
  std::size_t instruction = 0;  // the core instruction that writes
};

struct Code {
  std::vector<Step> steps;
  int first_latch_row = 0;
  int latch_rows = 0;
  // Place of each device: row * lanes + lane, of slots for a bit, of units for a word.
  std::map<Device, int> addresses;
  std::vector<Write> writes;
  // By step and lane the core instruction that it is shown with, or -1.
  std::vector<std::vector<int>> origins;
  int rows = 0;       // used, of the bit memories
  int word_rows = 0;  // and of the word memories
  std::int64_t clocks() const;
};

// `devices`: those that need a place though the program does not write them, or does not name them.
Code assemble(const Schedule& schedule, const Work& work, const values::Values& values,
              const Machine& machine, const std::vector<Device>& devices);

// Runs the instructions on names of values: every operand is what the work means, every old value
// is read before it is replaced, gates, flags and results of MUL and DIV are found where they must
// be, and each device holds its last value. Empty, or the first thing that is wrong.
std::string verify(const Code& code, const Schedule& schedule, const Work& work,
                   const values::Values& values, const Machine& machine);

}  // namespace rung::wide
