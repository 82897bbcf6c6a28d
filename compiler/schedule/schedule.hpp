// SPDX-License-Identifier: Apache-2.0
// When and in which slot each operation runs. The problem (what must come before what), the
// algorithm that solves it and the check of a solution are three things: verify() knows nothing of
// Problem.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "isa/isa.hpp"
#include "mapping/mapping.hpp"

namespace rung::schedule {

// `after` may run `latency` steps after `before` at the earliest (0: in the same step).
struct Edge {
  mapping::OpId before = mapping::kNoOp;
  mapping::OpId after = mapping::kNoOp;
  int latency = 0;
};

// A scheduling problem: the operations of a mapping on `slots` slots.
struct Problem {
  const mapping::Mapping* mapping = nullptr;
  const isa::Config* config = nullptr;
  int slots = 1;
  std::vector<Edge> edges;  // dependences between any two operations, those of a unit included

  // Steps that no schedule can go below, and the two reasons for it.
  int by_operations = 0;  // operations / slots
  int by_dependence = 0;  // the longest chain of edges
  int lower_bound() const { return std::max(by_operations, by_dependence); }
};
Problem make_problem(const mapping::Mapping& mapping, const isa::Config& config, int slots);

// steps[step][slot]: the operation there, or kNoOp.
struct Schedule {
  std::vector<std::vector<mapping::OpId>> steps;
};

// The units one after the other in the order of the mapping, on one slot: MPU2 as in the paper.
Schedule in_order(const mapping::Mapping& mapping);

struct SearchOptions {
  int tries = 64;  // schedules tried at most; the search ends early at the lower bound
  std::uint64_t seed = 1;
  bool by_steps = false;  // fewest steps, then clocks; else fewest clocks, then steps
  // Home banks instead of XOR banks: every device has one slot that may write it. Only for the
  // comparison in reports/steps.md; the processors do not need it.
  bool home_banks = false;
};

// List scheduling with insertion: units by priority, each at the earliest place that suits it.
Schedule search(const Problem& problem, const SearchOptions& options);

// Addresses of temporary bits: temporaries whose lives do not overlap share one.
// `address[t]` counts from 0; `count` addresses are used.
struct Temporaries {
  std::vector<int> address;
  int count = 0;
};
Temporaries allocate_temporaries(const Schedule& schedule, const mapping::Mapping& mapping);

// Clocks of the steps, without the pipeline's filling.
std::int64_t clocks(const Schedule& schedule, const mapping::Mapping& mapping,
                    const isa::Config& config);

// Runs the schedule symbolically: every operation once; every read finds the version that the
// mapping names, every N0 and condition the operation meant, every collector its product in time;
// no two writes of one device in a step. Empty, or the first thing that is wrong.
std::string verify(const Schedule& schedule, const mapping::Mapping& mapping,
                   const Temporaries& temporaries, const isa::Config& config);

struct Report {
  int steps = 0;
  int slots = 0;
  int operations = 0;
  int holes = 0;
  int by_operations = 0;
  int by_dependence = 0;
  int lower_bound = 0;
};
Report report(const Schedule& schedule, const Problem& problem);
// "530 steps, 1046 of 1060 slots used, 14 holes; lower bound 523 (operations), 7 above it"
std::string to_string(const Report& report);

}  // namespace rung::schedule
