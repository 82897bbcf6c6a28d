// SPDX-License-Identifier: Apache-2.0
// Lowering: a source program becomes core instructions (core/program.hpp). Control flow turns into
// gates, inlined and unrolled copies; timers, counters, edges, wide and indexed operations into a
// few core instructions each, with memories and temporaries that no program names.
#pragma once

#include "core/program.hpp"
#include "rungs/program.hpp"

namespace rung::lower {

// Lowers a program that its front end has checked. A program of basic instructions comes out as it
// went in, instruction by instruction.
core::Program lower(const Program& program);

}  // namespace rung::lower
