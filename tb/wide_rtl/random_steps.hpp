// SPDX-License-Identifier: Apache-2.0
// Random programs of MPU4 that read nothing which the contract leaves open.
#pragma once

#include <random>
#include <vector>

#include "wide_rtl/instruction.hpp"

namespace rung::tb::wide {

struct RandomProgram {
  std::vector<Step> steps;
  int latch_row = 0;
  int latch_rows = 0;
};

RandomProgram random_program(std::mt19937& random, int slots, int steps);

}  // namespace rung::tb::wide
