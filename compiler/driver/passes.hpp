// SPDX-License-Identifier: Apache-2.0
// The passes between a program's rungs and its instructions, for programs that are compiled whole
// (compile.cpp) and for those of many routines (compile_flow.cpp).
#pragma once

#include <optional>
#include <string>

#include "driver/compile.hpp"
#include "logic/logic.hpp"
#include "mapping/mapping.hpp"

namespace rung::passes {

// Throws std::logic_error for a problem that a check of `pass` has found.
void expect(const std::string& problem, const char* pass);

// A program on its way: what its source says, and what was made of it. `source` stays.
struct Lowered {
  const Program& source;
  core::Program program;
  logic::Logic logic;  // of MPU2 and MPU3
};
Lowered lower(const Program& source, const CompileOptions& options);
Lowered lower(const Program& source, core::Program program, const CompileOptions& options);

// Mapping and schedule for MPU2 and MPU3, both verified; everything but the addresses.
struct Plan {
  mapping::Mapping mapping;
  schedule::Schedule schedule;
  schedule::Temporaries temporaries;
  std::int64_t clocks = 0;  // of the steps, without the pipeline's filling
  schedule::Report report;
};
Plan plan(const Lowered& lowered, mapping::Mapping mapping, const CompileOptions& options);
Plan plan(const Lowered& lowered, const mapping::Options& how, const CompileOptions& options);

// The same with MUL and DIV that wait for their results, if that is wanted and better than `plan`.
std::optional<Plan> plan_waiting(const Lowered& lowered, const Plan& plan, mapping::Options how,
                                 const CompileOptions& options);

// MPU1's stacks are as deep as the makers'; what lowering adds to a rung that is itself as deep as
// they allow may not fit.
void check_stacks(const Program& source, const core::Program& program, Diagnostics& diagnostics);

void check_size(const std::string& file, const char* what, int needed, int available,
                const isa::Config& config, Diagnostics& diagnostics);

}  // namespace rung::passes
