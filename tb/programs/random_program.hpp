// SPDX-License-Identifier: Apache-2.0
// Valid programs by rule, as source text: what the lockstep tests run by the thousand.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rungs/program.hpp"

namespace rung {

// What the programs look like. Percentages are chances from 0 to 100. The fewer devices there are,
// the more often one instruction reads or writes what another has just written.
struct RandomProgramOptions {
  Dialect dialect = Dialect::Fx;
  int networks = 20;

  // Devices of each kind, numbered from 0; at least 1 each, words at least 2.
  int inputs = 16;
  int outputs = 16;
  int relays = 24;
  int words = 12;
  // A contact's device: an input, an output or a relay, by these weights.
  std::vector<int> contact_weights = {4, 2, 4};

  // Weight of a run of 1, 2, 3, ... contacts.
  std::vector<int> run_lengths = {10, 10, 6, 5, 3, 2, 2, 1, 1, 1};

  int block_percent = 25;         // after a run: one more block, with ANB or ORB
  int branch_percent = 15;        // outputs behind MPS, MRD, MPP
  int more_outputs_percent = 20;  // after an output: another one on the same result
  int continue_percent = 15;      // after an output: contacts and another output
  int word_percent = 20;          // an output is a word instruction
  int multiply_percent = 25;      // of those, MUL or DIV
  int set_reset_percent = 20;     // an output of a bit is SET or RST
  int nop_percent = 2;            // NOP before an instruction
};

// The options for programs that `--paper` allows: Table 4 of the paper only.
RandomProgramOptions paper_options();

// A program that parse_list accepts when given the same dialect. The same seed and options give the
// same text everywhere.
std::string random_program(std::uint64_t seed, const RandomProgramOptions& options);

}  // namespace rung
