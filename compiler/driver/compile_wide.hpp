// SPDX-License-Identifier: Apache-2.0
// The passes for MPU4: logic, values, look-ups and groups, schedule, instructions.
#pragma once

#include "driver/compile.hpp"

namespace rung {

// As compile(), which calls it for MPU4.
std::optional<Compiled> compile_wide(const Program& program, const CompileOptions& options,
                                     Diagnostics& diagnostics);

}  // namespace rung
