// SPDX-License-Identifier: Apache-2.0
#include "driver/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "lower/lower.hpp"

namespace rung::passes {
namespace {

bool has_muldiv(const mapping::Mapping& mapping) {
  return std::any_of(mapping.ops.begin(), mapping.ops.end(),
                     [](const mapping::MappedOp& op) { return op.started_by != mapping::kNoOp; });
}

bool is_better(const Plan& a, const Plan& b) {
  if (a.clocks != b.clocks) return a.clocks < b.clocks;
  return a.schedule.steps.size() < b.schedule.steps.size();
}

}  // namespace

void expect(const std::string& problem, const char* pass) {
  if (!problem.empty())
    throw std::logic_error(fmt::format("internal error in {}: {}", pass, problem));
}

Lowered lower(const Program& source, const CompileOptions& options) {
  return lower(source, lower::lower(source), options);
}

Lowered lower(const Program& source, core::Program program, const CompileOptions& options) {
  Lowered lowered{source, std::move(program), {}};
  if (options.mpu != isa::Mpu::Mpu1) lowered.logic = logic::build(lowered.program);
  return lowered;
}

Plan plan(const Lowered& lowered, mapping::Mapping mapping, const CompileOptions& options) {
  // What runs may not depend on luck: each pass is checked by something that did not make it.
  expect(mapping::verify(mapping, lowered.logic, lowered.program), "mapping");

  Plan out;
  out.mapping = std::move(mapping);
  const auto problem =
      schedule::make_problem(out.mapping, *options.config, isa::slots(options.mpu));
  const bool keeps_order = options.paper && options.mpu == isa::Mpu::Mpu2;
  schedule::SearchOptions search = options.search;
  search.by_steps = options.paper;  // steps are what the paper counts
  out.schedule = keeps_order ? schedule::in_order(out.mapping) : schedule::search(problem, search);
  out.temporaries = schedule::allocate_temporaries(out.schedule, out.mapping);
  expect(schedule::verify(out.schedule, out.mapping, out.temporaries, *options.config), "schedule");
  out.clocks = schedule::clocks(out.schedule, out.mapping, *options.config);
  out.report = schedule::report(out.schedule, problem);
  return out;
}

Plan plan(const Lowered& lowered, const mapping::Options& how, const CompileOptions& options) {
  return plan(lowered, mapping::map_logic(lowered.logic, lowered.program, how), options);
}

std::optional<Plan> plan_waiting(const Lowered& lowered, const Plan& plan, mapping::Options how,
                                 const CompileOptions& options) {
  // MULS and DIVS pay where other steps fill the time until they are collected; else waiting does.
  if (!options.waiting_muldiv || !has_muldiv(plan.mapping)) return std::nullopt;
  how.split_muldiv = false;
  Plan waiting = passes::plan(lowered, how, options);
  if (!is_better(waiting, plan)) return std::nullopt;
  return waiting;
}

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

}  // namespace rung::passes
