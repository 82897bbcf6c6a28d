// SPDX-License-Identifier: Apache-2.0
// What LDmicro 2.3 has room for.
#pragma once

#include "rungs/program.hpp"

namespace rung::ld_limits {

inline constexpr int kItems = 15;  // in a SERIES, a PARALLEL or a rung
inline constexpr std::size_t kRungs = 99;
inline constexpr std::size_t kName = 127;
inline constexpr std::size_t kComment = 383;  // bytes
inline constexpr std::size_t kLookUp = 60;    // values
inline constexpr std::size_t kPoints = 30;
inline constexpr std::size_t kString = 59;  // characters as the source has them
inline constexpr std::size_t kNames = 512;
// Without the line's end.
inline constexpr std::size_t kLine = 510;
inline constexpr std::size_t kPinLine = 78;

// Errors for names, tables and counts that are beyond them, and for what it cannot compile.
void check(const Program& program, Diagnostics& diagnostics);

}  // namespace rung::ld_limits
