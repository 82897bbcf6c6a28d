// SPDX-License-Identifier: Apache-2.0
#include "paper/reproduce.hpp"

#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "melsec/list.hpp"
#include "programs/samples.hpp"

namespace rung::paper {
namespace {

[[noreturn]] void refuse(const Diagnostics& diagnostics) {
  diagnostics.print(std::cerr);
  throw std::logic_error("a program of the paper is refused");
}

}  // namespace

Program parse(const std::string& text) {
  Diagnostics diagnostics;
  const auto source = decode_text(text, "paper.il", diagnostics);
  if (!source) refuse(diagnostics);
  auto program = parse_list(*source, Dialect::Paper, diagnostics);
  if (!program) refuse(diagnostics);
  return std::move(*program);
}

Compiled compile_for(const Program& program, isa::Mpu mpu, bool paper) {
  CompileOptions options;
  options.mpu = mpu;
  options.paper = paper;
  return compile_with(program, options);
}

Compiled compile_with(const Program& program, const CompileOptions& options) {
  Diagnostics diagnostics;
  auto compiled = compile(program, options, diagnostics);
  if (!compiled) refuse(diagnostics);
  return std::move(*compiled);
}

std::string figure2() { return "LD\tX0\nOR\tM0\nANI\tX1\nOUT\tM0\nLD\tM0\nADD\tK1 D0\nEND\n"; }

std::string figure14() {
  return "LD X0\nOR M0\nANI X1\nOUT M0\nLD M0\nOUT Y0\nLD X2\nOR X3\nAND X4\nANI X5\nOUT Y1\nEND\n";
}

std::vector<std::vector<std::string>> figure_steps(isa::Mpu mpu) {
  const Compiled compiled = compile_for(parse(figure14()), mpu, true);
  std::vector<std::vector<std::string>> steps;
  for (const auto& step : compiled.image.steps) {
    auto& texts = steps.emplace_back();
    for (const auto& slot : step) texts.push_back(image::disassemble(slot, compiled.image));
  }
  return steps;
}

std::map<int, int> table1() {
  std::map<int, int> runs;
  for (const int length : count(parse(figure2())).run_lengths) ++runs[length];
  return runs;
}

int lookups_of_run(int contacts) {
  std::string text = "LD X0\n";
  for (int i = 1; i < contacts; ++i) text += fmt::format("{} X{:o}\n", i % 2 ? "OR" : "ANI", i);
  const Program program = parse(text + "OUT M0\nEND\n");
  return compile_for(program, isa::Mpu::Mpu2, true).image.statistics.lookups;
}

std::map<int, Table7Row> table7() {
  const Program program = parse(sample_program(1, kDensities[0], 1));
  // Every run of a stand-in begins a rung and every rung has one run, so the look-ups that a rung's
  // contacts became are those of its run.
  const Compiled compiled = compile_for(program, isa::Mpu::Mpu2, true);
  std::map<std::size_t, int> lookups;  // by the rung's first instruction
  for (std::size_t step = 0; step < compiled.image.steps.size(); ++step) {
    if (!mapping::is_lookup(compiled.image.steps[step][0].opcode)) continue;
    const auto at = static_cast<std::size_t>(compiled.image.origins[step][0]);
    for (const Network& network : program.networks) {
      if (at >= network.first && at < network.first + network.count) ++lookups[network.first];
    }
  }
  const std::vector<int> lengths = count(program).run_lengths;
  if (lengths.size() != program.networks.size()) throw std::logic_error("a rung has several runs");
  std::map<int, Table7Row> rows;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    Table7Row& row = rows[lengths[i]];
    ++row.runs;
    row.contacts += lengths[i];
    row.lookups += lookups[program.networks[i].first];
  }
  return rows;
}

SampleSteps sample_steps(int sample, int density, std::uint64_t seed) {
  const Program program = parse(sample_program(sample, density, seed));
  const auto steps = [](const Compiled& compiled) {
    return static_cast<int>(compiled.image.steps.size());
  };
  SampleSteps result;
  result.mpu1 = steps(compile_for(program, isa::Mpu::Mpu1, true));
  result.mpu2 = steps(compile_for(program, isa::Mpu::Mpu2, true));
  const Compiled mpu3 = compile_for(program, isa::Mpu::Mpu3, true);
  result.mpu3 = steps(mpu3);
  result.bound = mpu3.schedule->lower_bound;
  result.mpu3_clocks = mpu3.image.clocks;
  result.mpu2_default = steps(compile_for(program, isa::Mpu::Mpu2, false));
  const Compiled best = compile_for(program, isa::Mpu::Mpu3, false);
  result.mpu3_default = steps(best);
  result.bound_default = best.schedule->lower_bound;
  result.mpu3_default_clocks = best.image.clocks;
  return result;
}

WritePortSteps write_port_steps(int sample, int density, std::uint64_t seed) {
  const Program program = parse(sample_program(sample, density, seed));
  WritePortSteps result;
  CompileOptions options;
  result.xor_banks = static_cast<int>(compile_with(program, options).image.steps.size());
  options.search.home_banks = true;
  result.home_banks = static_cast<int>(compile_with(program, options).image.steps.size());
  return result;
}

}  // namespace rung::paper
