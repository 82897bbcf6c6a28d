// SPDX-License-Identifier: Apache-2.0
// rung-explore: the text of reports/explore.md. Steps of a scan for other machines than there are.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "driver/compile.hpp"
#include "logic/logic.hpp"
#include "lower/lower.hpp"
#include "melsec/list.hpp"
#include "programs/samples.hpp"
#include "wide/schedule.hpp"

namespace {

using namespace rung;

constexpr int kSeeds = 5;

struct Kind {
  const char* name;
  std::string (*program)(std::uint64_t seed);
};

// The mix is the paper's counts; in the other two its outputs are replaced.
std::string replaced(std::uint64_t seed, bool contacts_only) {
  const std::string mix = sample_program(1, 30, seed);
  std::string out;
  int coil = 0;
  std::size_t at = 0;
  int outputs = 0;
  while (at < mix.size()) {
    const std::size_t end = mix.find('\n', at);
    const std::string line = mix.substr(at, end - at);
    at = end + 1;
    const std::string op = line.substr(0, line.find(' '));
    const bool word = op == "MV" || op == "ADD" || op == "SUB" || op == "MUL" || op == "DIV";
    if (!word && op != "OUT") {
      out += line + "\n";
      continue;
    }
    // One MV or ADD in four instructions: 356 of the 652 outputs.
    ++outputs;
    const bool keep = !contacts_only && (outputs - 1) * 356 / 652 != outputs * 356 / 652;
    if (!keep) {
      out += fmt::format("OUT M{}\n", 1000 + coil++);
    } else {
      const int n = coil++;
      out += n % 2 == 0 ? fmt::format("MV D{} D{}\n", n % 16, 16 + n)
                        : fmt::format("ADD D{} K{} D{}\n", 15 + n, n, 16 + n);
    }
  }
  return out;
}

const Kind kKinds[] = {
    {"contacts and OUT", [](std::uint64_t seed) { return replaced(seed, true); }},
    {"mix", [](std::uint64_t seed) { return sample_program(1, 30, seed); }},
    {"one MV or ADD in four", [](std::uint64_t seed) { return replaced(seed, false); }},
};

wide::Machine machine_of(int slots) {
  wide::Machine machine;
  machine.slots = slots;
  machine.units = slots / 2;
  machine.dividers = slots == 4 ? 1 : 2;
  return machine;
}

struct Found {
  double steps = 0;
  std::string binding;
};

Found explore(const Kind& kind, const wide::Machine& machine, bool merge = true) {
  std::vector<int> steps;
  Found out;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Diagnostics diagnostics;
    const auto source = decode_text(kind.program(seed), "sample.il", diagnostics);
    const auto program = parse_list(*source, Dialect::Paper, diagnostics);
    if (!program) throw std::runtime_error("the sample is refused");
    const core::Program core = lower::lower(*program);
    const values::Values values = values::build(logic::build(core), core);
    wide::Work work = wide::make_work(values, machine, {}, {merge});
    wide::untangle(work, values);
    wide::SearchOptions search;
    search.tries = 8;
    const wide::Schedule schedule = wide::search(work, values, machine, search);
    steps.push_back(schedule.steps);
    out.binding = wide::bounds(work, values, machine).binding();
  }
  std::sort(steps.begin(), steps.end());
  out.steps = steps[kSeeds / 2];
  return out;
}

void row(const char* name, int slots, const std::function<void(wide::Machine&)>& change,
         bool merge = true) {
  fmt::print("| {} | {} |", name, slots);
  for (const Kind& kind : kKinds) {
    wide::Machine machine = machine_of(slots);
    change(machine);
    const Found found = explore(kind, machine, merge);
    fmt::print(" {} ({}) |", found.steps, found.binding);
  }
  fmt::print("\n");
}

// Seconds, and steps of the result.
std::pair<double, std::size_t> compile_long_program() {
  Diagnostics diagnostics;
  const auto source = decode_text(long_program(true), "long.il", diagnostics);
  const auto program = parse_list(*source, Dialect::Paper, diagnostics);
  if (!program) throw std::runtime_error("the long program is refused");
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu4;
  options.slots = 16;
  const auto begin = std::chrono::steady_clock::now();
  const auto compiled = compile(*program, options, diagnostics);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  if (!compiled) throw std::runtime_error("the long program does not fit");
  return {took.count(), compiled->image.length()};
}

}  // namespace

int main(int argc, char** argv) {
  fmt::print(
      "# Exploration of MPU4\n\nMade by `make explore`{}{}. Sample 1 stand-ins of 1,425 "
      "instructions (`tb/programs/samples.cpp`, density 30), median of\nseeds 1 to {}: steps "
      "of a scan, without input latch and fill, and what bounds them. The chosen machine "
      "has\nhalf as many word units as slots, 3 operands a look-up, 2 pipelined dividers (4 "
      "slots: 1), all results on one bus.\n\n",
      argc > 1 ? " on " : "", argc > 1 ? argv[1] : "", kSeeds);
  fmt::print("| machine | slots |");
  for (const Kind& kind : kKinds) fmt::print(" {} |", kind.name);
  fmt::print("\n|---|---|---|---|---|\n");
  for (const int slots : {4, 8, 16, 32}) row("chosen", slots, [](auto&) {});
  for (const int slots : {8, 16}) {
    row(
        "without merging", slots, [](auto&) {}, false);
    row("4 operands a look-up", slots, [](auto& m) { m.arity = 4; });
    row("a quarter as many word units", slots, [](auto& m) { m.units = m.slots / 4; });
    row("results of others 1 step later", slots, [](auto& m) { m.other += 1; });
    row("results of others 2 steps earlier", slots, [](auto& m) { m.other -= 2; });
    row("MUL 3 steps", slots, [](auto& m) { m.mul = 3; });
    row("DIV 19 steps, pipelined", slots, [](auto& m) { m.div = 19; });
    row("DIV 19 steps, one at a time in every unit", slots, [](auto& m) {
      m.div = m.div_interval = 19;
      m.dividers = m.units;
    });
    row("1 divider", slots, [](auto& m) { m.dividers = 1; });
    row("4 dividers", slots, [](auto& m) { m.dividers = 4; });
  }
  const auto [took, steps] = compile_long_program();
  fmt::print(
      "\nTime to compile, all passes and checks, on the machine that made this page, which other "
      "jobs may share: 19,950 instructions of\ncontacts and coils for 16 slots in {:.2f} s, into "
      "{} steps.\n",
      took, steps);
}
