// SPDX-License-Identifier: Apache-2.0
// Stand-ins for the paper's sample programs (sections 6, Tables 5 to 8), which are not public: the
// same numbers of instructions, contacts and look-ups, Sample 1 with its histogram of runs too.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace rung {

// What is known, and what we chose where the paper says nothing.
struct SampleShape {
  int number = 1;
  std::map<int, int> runs;  // contacts of a run -> how many runs have them (Sample 1: Table 7)
  // Output instructions. The paper gives their sum; the split is ours.
  int out, mv, add, sub, mul, div;

  int contacts() const;
  int instructions() const;
};
// `number` is 1, 2 or 3.
const SampleShape& sample_shape(int number);

// How much of a program depends on what stands before it: the chance in percent that a contact or a
// word operand is a device that an earlier rung writes (any of them alike). The others are inputs,
// words that nothing writes, constants, and one time in ten any relay of the program, whose value
// is then that of the scan before if its coil stands further down.
inline constexpr int kDensities[] = {10, 30, 60};

// The program in the paper's dialect. The same arguments give the same text everywhere. Every run
// begins with LD or LDI and ends in one output or more; one coil in twenty is written before.
std::string sample_program(int number, int density, std::uint64_t seed);

// 14 stand-ins of Sample 1 behind each other: 19,950 instructions. `contacts_only`: outputs are
// coils, as many different ones as there are.
std::string long_program(bool contacts_only);

}  // namespace rung
