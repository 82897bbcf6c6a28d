// SPDX-License-Identifier: Apache-2.0
// What a FORMATTED_STRING of LDmicro sends, one step for each byte (compiler/LDMICRO.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rung {

struct StringStep {
  enum class Kind : std::uint8_t {
    Byte,   // `value` as it stands
    Sign,   // of the variable
    Digit,  // of the variable, that of the power of ten `value`: 10000, 1000, ... 1
  };
  Kind kind = Kind::Byte;
  int value = 0;
  bool last = false;  // Digit: the last one, which is never a blank
  bool operator==(const StringStep&) const = default;
};

// The steps of the characters `codes`, escapes still as they stand in the source. They have been
// checked: string_fault() finds nothing.
std::vector<StringStep> string_steps(const std::vector<std::int32_t>& codes);

// Why `codes` are no format string, and how to mend it.
struct StringFault {
  std::string what;
  std::string mend;
};
std::optional<StringFault> string_fault(const std::vector<std::int32_t>& codes);

// True if the string shows digits, so that it needs a variable. For checked ones.
bool shows_variable(const std::vector<std::int32_t>& codes);

}  // namespace rung
