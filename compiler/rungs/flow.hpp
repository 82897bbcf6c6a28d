// SPDX-License-Identifier: Apache-2.0
// What stands outside of networks: labels and jumps, subroutines, loops, master-control zones and
// states.
#pragma once

#include "rungs/program.hpp"

namespace rung {

// A program may not be larger than this when its loops and subroutines are written out.
inline constexpr std::int64_t kMostExpandedInstructions = 65536;

// Fills Instruction::destination and checks that the scan is constant and what SEMANTICS.md says of
// flow: jumps forward only and within their routine, loop, zone and state; zones, loops and states
// closed in order; subroutines behind FEND and ended by SRET; no recursion; depths within the
// maker's limits; not too large when written out. Every fault is an error at its place.
void resolve_flow(Program& program, Diagnostics& diagnostics);

}  // namespace rung
