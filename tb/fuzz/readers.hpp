// SPDX-License-Identifier: Apache-2.0
// The readers of files that people bring, and of what comes to the programs on a PC.
#pragma once

#include <span>

#include "fuzz/reader.hpp"

namespace rung::fuzz {

std::span<const Reader> readers();

}  // namespace rung::fuzz
