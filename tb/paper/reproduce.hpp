// SPDX-License-Identifier: Apache-2.0
// The paper's figures and tables, made again by this compiler. What the paper prints stands in
// paper_test.cpp; here everything is computed.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "driver/compile.hpp"

namespace rung::paper {

// A list of the paper's dialect; throws std::logic_error if it is refused.
Program parse(const std::string& text);
// Compiled with --paper or without; throws std::logic_error if it does not fit.
Compiled compile_for(const Program& program, isa::Mpu mpu, bool paper);
Compiled compile_with(const Program& program, const CompileOptions& options);

// The programs of Figures 2 and 14.
std::string figure2();
std::string figure14();
// Figures 14, 15, 16: each step's instructions as text, slot by slot.
std::vector<std::vector<std::string>> figure_steps(isa::Mpu mpu);

// Table 1: runs of each length in the program of Figure 2.
std::map<int, int> table1();
// Table 6: look-ups that MPU2 takes for one run of `contacts`.
int lookups_of_run(int contacts);
// Table 7: for each length of run in Sample 1's stand-in, runs, contacts and look-ups.
struct Table7Row {
  int runs = 0;
  int contacts = 0;
  int lookups = 0;
};
std::map<int, Table7Row> table7();

// Table 8: one stand-in on the three processors.
struct SampleSteps {
  int mpu1 = 0, mpu2 = 0, mpu3 = 0;        // --paper
  int bound = 0;                           // of MPU3's schedule with --paper
  int mpu2_default = 0, mpu3_default = 0;  // everything the hardware can do
  int bound_default = 0;
  std::int64_t mpu3_clocks = 0, mpu3_default_clocks = 0;
};
SampleSteps sample_steps(int sample, int density, std::uint64_t seed);

// Steps on MPU3, default mode, with XOR banks as built and if every device had a home slot.
struct WritePortSteps {
  int xor_banks = 0;
  int home_banks = 0;
};
WritePortSteps write_port_steps(int sample, int density, std::uint64_t seed);

}  // namespace rung::paper
