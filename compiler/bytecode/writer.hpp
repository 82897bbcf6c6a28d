// SPDX-License-Identifier: Apache-2.0
// Portable byte code for the interpreter in interpreter/ (README.md).
#pragma once

#include <optional>
#include <string>

#include "core/program.hpp"
#include "rungs/program.hpp"

namespace rung::bytecode {

struct Options {
  bool names = true;  // the names of devices; without them a file is smaller
};

// The file, made of `source` and of what its lowering has made of it. Nothing, with an error, when
// the program has more devices than byte code can number.
std::optional<std::string> write(const Program& source, const core::Program& program,
                                 const Options& options, Diagnostics& diagnostics);

}  // namespace rung::bytecode
