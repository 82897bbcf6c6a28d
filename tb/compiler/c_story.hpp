// SPDX-License-Identifier: Apache-2.0
// A program, what it is given before each scan and what it must have after it: rows of the tables
// in the tests of the C back end, worked out by hand.
#pragma once

#include <cstdint>
#include <span>

#include "rungs/device.hpp"

namespace rung {

struct CStory {
  const char* name;
  const char* text;    // instructions between commas, without END; rungs between semicolons
  const char* before;  // of each scan, between bars: "X0=1 D0=7 | | X0=0"; RX=65: a byte arrives
  const char* after;   // of each scan; TX=65: this byte is sent, ERROR=1: division by zero
  Dialect dialect = Dialect::Fx;
  std::uint32_t tick_us = 10000;
};

// Runs all of them as C, in one translation unit, against what they say; then against the
// reference, with random inputs.
void expect_c_stories(std::span<const CStory> stories);

}  // namespace rung
