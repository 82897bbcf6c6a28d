// SPDX-License-Identifier: Apache-2.0
// Many programs as C in one translation unit: compiled once, run as one process.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "agree/case.hpp"

namespace rung::tb {

struct CRun {
  std::string failure;                // what the compiler said, or that the process ended early
  std::vector<Behaviour> behaviours;  // of each case
};

// Strict: the C compiler of the build; warnings are errors, undefined behaviour ends the process.
// Fast: tcc, which takes a twentieth of the time; without one, strict.
enum class CCompiler : std::uint8_t { Strict, Fast };

// An LDmicro program has the peripherals of LDmicro's simulator. Translates, compiles and runs
// `cases`; files named after `name` are left in `folder`.
CRun run_as_c(std::span<const Case> cases, CCompiler compiler, const std::string& folder,
              const std::string& name);

}  // namespace rung::tb
