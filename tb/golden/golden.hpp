// SPDX-License-Identifier: Apache-2.0
// A program of tb/golden/programs with its golden trace, for whatever can run an image: what the
// tests of the RTL and of the netlists (tb/gate) have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "isa/isa.hpp"
#include "lockstep/any_machine.hpp"
#include "trace/stimulus.hpp"
#include "trace/trace.hpp"

namespace rung::tb {

// The programs, in the order of their names.
std::vector<std::string> golden_names();

class GoldenProgram {
 public:
  // Reads program, trace and stimulus. Throws std::runtime_error if one of them cannot be read.
  explicit GoldenProgram(const std::string& name);

  const Program& program() const { return program_; }
  const Trace& golden() const { return golden_; }
  const Stimulus& stimulus() const { return stimulus_; }

  // Table 4 of the paper has all of its instructions, so that it runs with `--paper` too.
  bool in_table_4() const;
  // Nothing if the configuration is too small for it, which none is for a program of up to 40
  // instructions: then std::runtime_error.
  std::optional<image::Image> compile(isa::Mpu mpu, bool paper, const isa::Config& config) const;
  // For MPU4: with merging, compared by the values after each scan, or without, by every write.
  image::Image compile_wide(int slots, bool merge) const;

  // Runs an image of it on `machine`, scan by scan; gives the first difference from the golden
  // trace or from the compiler's number of clocks, with the command that shows it again.
  std::optional<std::string> difference(const image::Image& image, AnyMachine& machine) const;

 private:
  std::string name_;
  std::string source_;
  Dialect dialect_ = Dialect::Fx;
  Trace golden_;
  Program program_;
  Stimulus stimulus_;
};

}  // namespace rung::tb
