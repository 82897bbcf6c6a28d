// SPDX-License-Identifier: Apache-2.0
// A program as C, compiled by the C compiler and loaded, beside the reference.
#pragma once

#include <cstdint>
#include <string>

#include "programs/random_source.hpp"
#include "rungs/program.hpp"

namespace rung {

class CProgram {
 public:
  // Translates and compiles `program`, every warning an error; undefined behaviour traps. A failure
  // to compile is a failure of the test, with the compiler's messages.
  explicit CProgram(const Program& program);
  ~CProgram();
  CProgram(const CProgram&) = delete;
  CProgram& operator=(const CProgram&) = delete;

  bool good() const { return library_ != nullptr; }
  void reset() const;
  void cycle() const;
  bool error() const;
  std::int16_t read(Device device) const;
  void write(Device device, std::int16_t value) const;

 private:
  void* symbol(const std::string& name) const;

  void* library_ = nullptr;
};

// Runs `scans` scans of `program` as C and on the reference, with random inputs and at times a
// random preset, and expects every named device and the error flag to be equal after each.
void expect_c_equals_reference(const Program& program, int scans, RandomSource& random);

}  // namespace rung
