// SPDX-License-Identifier: Apache-2.0
// What the environment asks of the agreement tests: RUNG_SEED, RUNG_COUNT, RUNG_FAMILIES.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "programs/random_melsec.hpp"

namespace rung::tb {

// The number in this variable, or `otherwise`.
std::uint64_t from_environment(const char* name, std::uint64_t otherwise);

// The families in RUNG_FAMILIES; none, for all of them, if it is not set. A name that is no family
// fails the test.
std::vector<Family> families_of_environment();

// What to put before a command that replays a program: RUNG_FAMILIES=... if it is set.
std::string replay_families();

}  // namespace rung::tb
