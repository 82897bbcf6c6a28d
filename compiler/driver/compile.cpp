// SPDX-License-Identifier: Apache-2.0
#include "driver/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "driver/peripherals.hpp"
#include "lower/lower.hpp"

namespace rung {
namespace {

using isa::Mpu;
using mapping::Mapping;

void expect(const std::string& problem, const char* pass) {
  if (!problem.empty())
    throw std::logic_error(fmt::format("internal error in {}: {}", pass, problem));
}

// A program on its way: what its source says, and what was made of it.
struct Lowered {
  const Program& source;
  core::Program program;
  logic::Logic logic;
};

struct Candidate {
  Compiled compiled;
  bool rows_fit = false;
};

// Mapping, schedule and image of one way to compile for MPU2 or MPU3.
Candidate build(const Lowered& lowered, const Mapping& mapping, const CompileOptions& options) {
  // What runs may not depend on luck: each pass is checked by something that did not make it.
  expect(mapping::verify(mapping, lowered.logic, lowered.program), "mapping");

  const auto problem = schedule::make_problem(mapping, *options.config, isa::slots(options.mpu));
  const bool keeps_order = options.paper && options.mpu == Mpu::Mpu2;
  schedule::SearchOptions search = options.search;
  search.by_steps = options.paper;  // steps are what the paper counts
  const auto steps = keeps_order ? schedule::in_order(mapping) : schedule::search(problem, search);
  const auto temporaries = schedule::allocate_temporaries(steps, mapping);
  expect(schedule::verify(steps, mapping, temporaries, *options.config), "schedule");

  Candidate candidate;
  candidate.compiled.schedule = schedule::report(steps, problem);
  candidate.rows_fit =
      image::assemble_slots(lowered.source, lowered.program, mapping, steps, temporaries,
                            *options.config, options.mpu, candidate.compiled.image);
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

Compiled compile_slots(const Lowered& lowered, const CompileOptions& options) {
  const auto map = [&](const mapping::Options& how) {
    return mapping::map_logic(lowered.logic, lowered.program, how);
  };
  if (options.paper) {
    // Of NOPs the paper's order keeps the steps; a schedule has no use for them.
    const bool keep_nops = options.mpu == Mpu::Mpu2;
    const Mapping mapping = mapping::map_paper(lowered.logic, lowered.program, keep_nops);
    return build(lowered, mapping, options).compiled;
  }

  mapping::Options how;
  Mapping mapping = map(how);
  Candidate best = build(lowered, mapping, options);
  if (!best.rows_fit) {
    // Without fused writes, functions that differ in the order of inputs share a row: 80 at most.
    how.fuse = false;
    mapping = map(how);
    best = build(lowered, mapping, options);
    expect(best.rows_fit ? "" : "the look-ups need more rows than there are", "assembly");
  }
  // MULS and DIVS pay where other steps fill the time until they are collected; else waiting does.
  if (options.waiting_muldiv && has_muldiv(mapping)) {
    how.split_muldiv = false;
    Candidate waiting = build(lowered, map(how), options);
    if (waiting.rows_fit && is_better(waiting.compiled.image, best.compiled.image)) {
      best = std::move(waiting);
    }
  }
  return best.compiled;
}

// MPU1's stacks are as deep as the makers'; what lowering adds to a rung that is itself as deep as
// they allow may not fit.
void check_stacks(const Program& source, const core::Program& program, Diagnostics& diagnostics) {
  int blocks = 0;
  int branches = 0;
  std::size_t network = 0;
  for (std::size_t i = 0; i < program.instructions.size(); ++i) {
    if (network < program.networks.size() && program.networks[network].first == i) {
      ++network;
      blocks = branches = 0;
    }
    switch (program.instructions[i].op) {
      case core::Op::Ld:
      case core::Op::Ldi:
      case core::Op::LoadBit:
        ++blocks;
        break;
      case core::Op::Anb:
      case core::Op::Orb:
      case core::Op::Pop:
        --blocks;
        break;
      case core::Op::Mps:
        ++branches;
        break;
      case core::Op::Mpp:
        --branches;
        break;
      default:
        break;
    }
    if (program.instructions[i].op == core::Op::LoadBit) --blocks;
    if (blocks <= isa::constant::block_stack && branches <= isa::constant::branch_stack) continue;
    const Instruction& at = source.instructions[program.instructions[i].origin];
    diagnostics.error(source.file, at.position,
                      fmt::format("{}: this rung nests too deep for MPU1, whose stacks hold {} "
                                  "blocks and {} branches",
                                  at.text, isa::constant::block_stack, isa::constant::branch_stack),
                      "use a relay (M) for a part of the logic, or compile for MPU2 or MPU3");
    return;
  }
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
  const int errors = diagnostics.error_count();
  check_peripherals(program, *options.config, diagnostics);
  Lowered lowered{program, lower::lower(program), {}};
  Compiled compiled;
  if (options.mpu == Mpu::Mpu1) {
    check_stacks(program, lowered.program, diagnostics);
    compiled.image = image::assemble_mpu1(program, lowered.program, *options.config);
  } else {
    lowered.logic = logic::build(lowered.program);
    compiled = compile_slots(lowered, options);
  }
  compiled.image.paper = options.paper;

  const image::Statistics& statistics = compiled.image.statistics;
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
  const core::Program lowered = lower::lower(program);
  const logic::Logic logic = logic::build(lowered);
  const Mapping mapping = options.paper ? mapping::map_paper(logic, lowered, true)
                                        : mapping::map_logic(logic, lowered, {});
  return {logic::dump(logic, lowered, program.dialect), mapping::dump(mapping, program.dialect)};
}

}  // namespace rung
