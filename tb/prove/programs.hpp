// SPDX-License-Identifier: Apache-2.0
// Programs that the proofs are tried on: those of the tests, those of the corpora where they are
// present, and random ones.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "driver/compile.hpp"
#include "prove/prove.hpp"

namespace rung::tb {

inline constexpr isa::Mpu kMpus[] = {isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3};

// By its suffix and, of a list, its header. Nothing if it is refused.
std::optional<Program> read_program(const std::string& file);
// Files of `folder` with a program in them, by name.
std::vector<std::string> program_files(const std::string& folder);

// Random program number `seed`: two lists of MELSEC instructions, then an LDmicro program, then a
// list of the paper's.
Program random_case(std::uint64_t seed);

// Nothing if the program does not fit the processor.
std::optional<Compiled> compiled_for(const Program& program, isa::Mpu mpu, bool paper = false,
                                     bool small = false);

// The same for MPU4.
inline constexpr int kSlots[] = {4, 8, 16};
std::optional<Compiled> compiled_wide(const Program& program, int slots, bool merge);

inline std::string errors_of(const prove::Proof& proof, const Compiled& compiled) {
  Diagnostics diagnostics;
  prove::report(proof, compiled.image, compiled.meanings, diagnostics);
  std::ostringstream out;
  diagnostics.print(out);
  return out.str();
}

}  // namespace rung::tb
