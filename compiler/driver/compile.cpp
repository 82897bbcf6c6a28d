// SPDX-License-Identifier: Apache-2.0
#include "driver/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace rung {
namespace {

using isa::Mpu;
using mapping::Mapping;

void expect(const std::string& problem, const char* pass) {
  if (!problem.empty())
    throw std::logic_error(fmt::format("internal error in {}: {}", pass, problem));
}

struct Candidate {
  Compiled compiled;
  bool rows_fit = false;
};

// Mapping, schedule and image of one way to compile for MPU2 or MPU3.
Candidate build(const Program& program, const logic::Logic& logic, const Mapping& mapping,
                const CompileOptions& options) {
  // What runs may not depend on luck: each pass is checked by something that did not make it.
  expect(mapping::verify(mapping, logic, program), "mapping");

  const auto problem = schedule::make_problem(mapping, *options.config, isa::slots(options.mpu));
  const bool keeps_order = options.paper && options.mpu == Mpu::Mpu2;
  schedule::SearchOptions search = options.search;
  search.by_steps = options.paper;  // steps are what the paper counts
  const auto steps = keeps_order ? schedule::in_order(mapping) : schedule::search(problem, search);
  const auto temporaries = schedule::allocate_temporaries(steps, mapping);
  expect(schedule::verify(steps, mapping, temporaries, *options.config), "schedule");

  Candidate candidate;
  candidate.compiled.schedule = schedule::report(steps, problem);
  candidate.rows_fit = image::assemble_slots(program, mapping, steps, temporaries, *options.config,
                                             options.mpu, candidate.compiled.image);
  return candidate;
}

bool has_muldiv(const Mapping& mapping) {
  return std::any_of(mapping.ops.begin(), mapping.ops.end(),
                     [](const mapping::MappedOp& op) { return op.started_by != mapping::kNoOp; });
}

bool is_better(const image::Image& a, const image::Image& b) {
  if (a.clocks != b.clocks) return a.clocks < b.clocks;
  return a.steps.size() < b.steps.size();
}

Compiled compile_slots(const Program& program, const CompileOptions& options) {
  const logic::Logic logic = logic::build(program);
  if (options.paper) {
    // Of NOPs the paper's order keeps the steps; a schedule has no use for them.
    const bool keep_nops = options.mpu == Mpu::Mpu2;
    return build(program, logic, mapping::map_paper(logic, program, keep_nops), options).compiled;
  }

  mapping::Options how;
  const auto attempt = [&] {
    return build(program, logic, mapping::map_logic(logic, program, how), options);
  };
  Candidate best = attempt();
  if (!best.rows_fit) {
    // Without fused writes, functions that differ in the order of inputs share a row: 80 at most.
    how.fuse = false;
    best = attempt();
    expect(best.rows_fit ? "" : "the look-ups need more rows than there are", "assembly");
  }
  // MULS and DIVS pay where other steps fill the time until they are collected; else waiting does.
  if (has_muldiv(mapping::map_logic(logic, program, how))) {
    how.split_muldiv = false;
    Candidate waiting = attempt();
    if (waiting.rows_fit && is_better(waiting.compiled.image, best.compiled.image)) {
      best = std::move(waiting);
    }
  }
  return best.compiled;
}

void check_size(const std::string& file, const char* what, int needed, int available,
                const isa::Config& config, Diagnostics& diagnostics) {
  if (needed <= available) return;
  diagnostics.error(file, {},
                    fmt::format("the program needs {} {}; configuration {} has {}", needed, what,
                                config.name, available),
                    "split the program, or choose a larger configuration with --config");
}

}  // namespace

std::optional<Compiled> compile(const Program& program, const CompileOptions& options,
                                Diagnostics& diagnostics) {
  Compiled compiled;
  if (options.mpu == Mpu::Mpu1) {
    compiled.image = image::assemble_mpu1(program, *options.config);
  } else {
    compiled = compile_slots(program, options);
  }
  compiled.image.paper = options.paper;

  const image::Statistics& statistics = compiled.image.statistics;
  const int errors = diagnostics.error_count();
  check_size(program.file, "steps", static_cast<int>(compiled.image.steps.size()),
             options.config->steps(options.mpu), *options.config, diagnostics);
  check_size(program.file, "bit devices", statistics.bit_devices, options.config->bit_devices,
             *options.config, diagnostics);
  check_size(program.file, "word devices", statistics.word_devices, options.config->word_devices,
             *options.config, diagnostics);
  if (diagnostics.error_count() > errors) return std::nullopt;
  return compiled;
}

Dumps dump_passes(const Program& program, const CompileOptions& options) {
  const logic::Logic logic = logic::build(program);
  const Mapping mapping = options.paper ? mapping::map_paper(logic, program, true)
                                        : mapping::map_logic(logic, program, {});
  return {logic::dump(logic, program), mapping::dump(mapping, program)};
}

}  // namespace rung
