// SPDX-License-Identifier: Apache-2.0
// What a correct LDmicro program hardly means: warnings.
#pragma once

#include "rungs/program.hpp"

namespace rung {

void check_ld_program(const Program& program, Diagnostics& diagnostics);

}  // namespace rung
