// SPDX-License-Identifier: Apache-2.0
// What `--paper` allows.
#pragma once

#include "rungs/program.hpp"

namespace rung {

// Refuses, each at its place, what Table 4 of the paper does not have: SET RST ANB ORB MPS MRD MPP,
// and MUL and DIV that write two words. True when there is none of them.
bool check_paper(const Program& program, Diagnostics& diagnostics);

}  // namespace rung
