// SPDX-License-Identifier: Apache-2.0
// What stands in an LDmicro file before PROGRAM.
#pragma once

#include <string>
#include <vector>

#include "ldmicro/lines.hpp"
#include "rungs/program.hpp"

namespace rung {

struct LdHeader {
  // A variable to which a VAR LIST gives another size than 16 bits.
  struct OddSize {
    std::string name;
    int bits = 0;
    SourcePosition position;
  };
  LdmicroSettings settings;
  bool extended = false;  // of format 0.2
  std::vector<OddSize> odd_sizes;
};

// Reads `lines` up to PROGRAM, and that too.
LdHeader read_ld_header(LdLines& lines, const std::string& file, Diagnostics& diagnostics);

}  // namespace rung
