// SPDX-License-Identifier: Apache-2.0
#include "schedule/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <queue>

namespace rung::schedule {

using mapping::BitValue;
using mapping::Destination;
using mapping::kNoOp;
using mapping::MappedOp;
using mapping::Mapping;
using mapping::OpId;

Temporaries allocate_temporaries(const Schedule& schedule, const Mapping& mapping) {
  struct Life {
    int temporary;
    int written = -1;
    int last_read = -1;
  };
  std::vector<Life> lives(mapping.temporaries);
  for (int t = 0; t < mapping.temporaries; ++t) lives[t].temporary = t;
  for (std::size_t step = 0; step < schedule.steps.size(); ++step) {
    for (const OpId id : schedule.steps[step]) {
      if (id == kNoOp) continue;
      const MappedOp& op = mapping.ops[id];
      for (const BitValue& input : op.inputs) {
        if (input.kind != BitValue::Kind::Temporary) continue;
        lives[input.temporary].last_read = static_cast<int>(step);
      }
      if (op.destination.kind == Destination::Kind::Temporary) {
        lives[op.destination.temporary].written = static_cast<int>(step);
      }
    }
  }
  std::sort(lives.begin(), lives.end(),
            [](const Life& a, const Life& b) { return a.written < b.written; });

  // A step reads before it writes, so an address is free again in the step of its last read.
  Temporaries result;
  result.address.assign(mapping.temporaries, -1);
  using Release = std::pair<int, int>;  // step from which it is free, address
  std::priority_queue<Release, std::vector<Release>, std::greater<>> taken;
  std::vector<int> free;
  for (const Life& life : lives) {
    while (!taken.empty() && taken.top().first <= life.written) {
      free.push_back(taken.top().second);
      taken.pop();
    }
    int address = result.count;
    if (free.empty()) {
      ++result.count;
    } else {
      address = free.back();
      free.pop_back();
    }
    result.address[life.temporary] = address;
    taken.push({std::max(life.last_read, life.written + 1), address});
  }
  return result;
}

std::int64_t clocks(const Schedule& schedule, const Mapping& mapping, const isa::Config& config) {
  std::int64_t total = 0;
  for (const auto& step : schedule.steps) {
    int longest = 1;
    for (const OpId id : step) {
      if (id != kNoOp) longest = std::max(longest, config.clocks(mapping.ops[id].opcode));
    }
    total += longest;
  }
  return total;
}

Report report(const Schedule& schedule, const Problem& problem) {
  Report result;
  result.steps = static_cast<int>(schedule.steps.size());
  result.slots = result.steps * problem.slots;
  result.operations = static_cast<int>(problem.mapping->ops.size());
  result.holes = result.slots - result.operations;
  result.by_operations = problem.by_operations;
  result.by_dependence = problem.by_dependence;
  result.lower_bound = problem.lower_bound();
  return result;
}

std::string to_string(const Report& report) {
  return fmt::format("{} steps, {} of {} slots used, {} holes; lower bound {} ({}), {} above it",
                     report.steps, report.operations, report.slots, report.holes,
                     report.lower_bound,
                     report.by_dependence > report.by_operations ? "dependence" : "operations",
                     report.steps - report.lower_bound);
}

}  // namespace rung::schedule
