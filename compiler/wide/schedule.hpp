// SPDX-License-Identifier: Apache-2.0
// When and where each look-up and each group runs. Whether that is right is checked on
// the instructions that are made of it (verify() of assemble.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "wide/order.hpp"
#include "wide/work.hpp"

namespace rung::wide {

// Step and lane: slot of a bit, unit of a word.
struct Place {
  int step = kNone;
  int lane = kNone;
  bool operator==(const Place&) const = default;
};

struct Schedule {
  std::vector<Place> look_ups;
  std::vector<Place> groups;  // of the first step
  int steps = 0;

  Place word(const Work& work, const Work::Made& made) const {
    const Place& group = groups[made.group];
    return {group.step + work.groups[made.group].words[made.word].offset, group.lane};
  }
};

struct SearchOptions {
  int tries = 24;  // schedules tried at most; the search ends early at the lower bound
  std::uint64_t seed = 1;
};

// List scheduling, step by step, with several orders of priority.
Schedule search(const Work& work, const values::Values& values, const Machine& machine,
                const SearchOptions& options);

// What no schedule can go below, and why.
struct Bounds {
  int look_ups = 0;    // steps for so many look-ups
  int words = 0;       // for so many word instructions
  int dividers = 0;    // for so many divisions
  int dependence = 0;  // the longest chain
  int steps() const;
  std::string_view binding() const;  // which of them it is
};
Bounds bounds(const Work& work, const values::Values& values, const Machine& machine);

}  // namespace rung::wide
