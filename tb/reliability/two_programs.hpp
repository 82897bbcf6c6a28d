// SPDX-License-Identifier: Apache-2.0
// Two small programs that a glance at the pins tells apart: with X0, `old` has Y0 and `fresh` Y1;
// without it, the other way round. Y2 is 1 in both, and safe is Y0 0, Y1 1, Y2 0. D100 to D105 are
// kept over power loss.
#pragma once

#include "reliability/bench.hpp"

namespace rung::tb {

struct TwoPrograms {
  Made old, fresh;
  int y0 = 0, y1 = 0, y2 = 0, x0 = 0;  // pins

  // `more` is added to both lists, `settings` to the table [controller] of their maps.
  explicit TwoPrograms(const std::string& board, const std::string& more = "",
                       const std::string& settings = "");

  std::uint64_t safe() const { return 1ULL << y1; }
  std::uint64_t shows(bool of_fresh, bool x) const {
    return 1ULL << y2 | 1ULL << (of_fresh == x ? y1 : y0);
  }
  std::uint64_t mask() const { return 1ULL << y0 | 1ULL << y1 | 1ULL << y2; }
  // Whether the pins do what the program says, for both levels of X0.
  testing::AssertionResult runs(SimulatedController& controller, bool of_fresh) const;
  testing::AssertionResult is_safe(const SimulatedController& controller) const;
};

}  // namespace rung::tb
