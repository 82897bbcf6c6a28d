// SPDX-License-Identifier: Apache-2.0
// LDmicro programs: rungs of elements in series and in parallel.
#pragma once

#include "core/program.hpp"
#include "rungs/program.hpp"

namespace rung::lower {

core::Program lower_ldmicro(const Program& program);

}  // namespace rung::lower
