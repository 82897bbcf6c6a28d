// SPDX-License-Identifier: Apache-2.0
// Whole numbers as C's scanf reads them, which is what LDmicro does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rung {

struct LdNumber {
  std::int64_t value = 0;  // cut off at 64 bits
  std::size_t length = 0;  // characters that belong to it; 0: there is none, and `value` is 0
  bool fits = true;        // into 32 bits
};

// The number that `text` begins with: a sign and decimal digits.
LdNumber leading_number(std::string_view text);

}  // namespace rung
