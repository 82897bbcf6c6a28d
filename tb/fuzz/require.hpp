// SPDX-License-Identifier: Apache-2.0
// What a reader must keep to: a fault ends the program, for libFuzzer to see.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace rung::fuzz {

inline void require(bool condition, std::string_view what) {
  if (condition) return;
  std::cerr << what << '\n';
  std::abort();
}

}  // namespace rung::fuzz
