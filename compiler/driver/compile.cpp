// SPDX-License-Identifier: Apache-2.0
#include "driver/compile.hpp"

#include <fmt/format.h>

#include "driver/compile_wide.hpp"
#include "driver/passes.hpp"
#include "driver/peripherals.hpp"
#include "image/frame.hpp"
#include "lower/lower.hpp"

namespace rung {
namespace {

using isa::Mpu;
using mapping::Mapping;
using passes::Lowered;
using passes::Plan;

bool assemble(const Lowered& lowered, const Plan& plan, const CompileOptions& options,
              Compiled& compiled) {
  compiled.schedule = plan.report;
  return image::assemble_slots(lowered.source, lowered.program, plan.mapping, plan.schedule,
                               plan.temporaries, *options.config, options.mpu, compiled.image);
}

Compiled compile_slots(const Lowered& lowered, const CompileOptions& options) {
  Compiled best;
  if (options.paper) {
    // Of NOPs the paper's order keeps the steps; a schedule has no use for them.
    const bool keep_nops = options.mpu == Mpu::Mpu2;
    const Mapping mapping = mapping::map_paper(lowered.logic, lowered.program, keep_nops);
    assemble(lowered, passes::plan(lowered, mapping, options), options, best);
    return best;
  }

  mapping::Options how;
  Plan plan = passes::plan(lowered, how, options);
  if (!assemble(lowered, plan, options, best)) {
    // Without fused writes, functions that differ in the order of inputs share a row: 80 at most.
    how.fuse = false;
    plan = passes::plan(lowered, how, options);
    passes::expect(
        assemble(lowered, plan, options, best) ? "" : "the look-ups need more rows than there are",
        "assembly");
  }
  const auto waiting = passes::plan_waiting(lowered, plan, how, options);
  Compiled other;
  if (waiting && assemble(lowered, *waiting, options, other)) best = std::move(other);
  return best;
}

}  // namespace

std::optional<Compiled> compile(const Program& program, const CompileOptions& options,
                                Diagnostics& diagnostics) {
  if (options.mpu == Mpu::Mpu4) return compile_wide(program, options, diagnostics);
  const int errors = diagnostics.error_count();
  check_peripherals(program, *options.config, diagnostics);
  const Lowered lowered = passes::lower(program, options);
  Compiled compiled;
  if (options.mpu == Mpu::Mpu1) {
    passes::check_stacks(program, lowered.program, diagnostics);
    compiled.image = image::assemble_mpu1(program, lowered.program, *options.config);
  } else {
    compiled = compile_slots(lowered, options);
  }
  compiled.image.paper = options.paper;

  const image::Statistics& statistics = compiled.image.statistics;
  passes::check_size(program.file, "steps", static_cast<int>(compiled.image.steps.size()),
                     options.config->steps(options.mpu), *options.config, diagnostics);
  passes::check_size(program.file, "bit devices", statistics.bit_devices,
                     options.config->bit_devices, *options.config, diagnostics);
  passes::check_size(program.file, "word devices", statistics.word_devices,
                     options.config->word_devices, *options.config, diagnostics);
  if (diagnostics.error_count() > errors) return std::nullopt;
  const image::Addresses addresses(program, lowered.program, *options.config);
  compiled.meanings.push_back(image::meaning(program, lowered.program, addresses.devices()));
  compiled.meanings[0].end_step = static_cast<int>(compiled.image.steps.size());
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
