// SPDX-License-Identifier: Apache-2.0
// All passes from a program to an image, in their order.
#pragma once

#include <optional>

#include "image/image.hpp"
#include "image/meaning.hpp"
#include "schedule/schedule.hpp"

namespace rung {

struct CompileOptions {
  isa::Mpu mpu = isa::Mpu::Mpu3;
  bool paper = false;  // only the paper's instruction forms; the program must pass check_paper()
  const isa::Config* config = isa::find_config("ecp5");
  schedule::SearchOptions search;
  // Also try MUL and DIV that wait for their result, and take what gives fewer clocks.
  bool waiting_muldiv = true;
  // MPU4: its slots; compute what is equal once, and nothing that nobody can see (MERGING.md).
  int slots = 8;
  bool merge = true;
};

struct Compiled {
  image::Image image;
  std::optional<schedule::Report> schedule;  // of MPU2 and MPU3
  std::vector<image::Meaning> meanings;      // of the image's routines, in their order
};

// Nothing, with errors, when the program does not fit the configuration. Every pass is verified;
// throws std::logic_error if one of them has failed.
std::optional<Compiled> compile(const Program& program, const CompileOptions& options,
                                Diagnostics& diagnostics);

// The forms that passes print, for people and tests.
struct Dumps {
  std::string logic;
  std::string mapping;
};
Dumps dump_passes(const Program& program, const CompileOptions& options);

}  // namespace rung
