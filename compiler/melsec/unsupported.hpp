// SPDX-License-Identifier: Apache-2.0
// MELSEC instructions and devices that are known by name and refused with a reason.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rungs/structure.hpp"

namespace rung {

struct Unsupported {
  std::string reason;  // completes "NAME is ..."
  std::string mend;    // may be empty
  // Of an instruction: its part in the structure of a network.
  Effect effect = Effect::None;
};

// Why the instruction `name` (upper case) is refused; nothing when no MELSEC instruction is known
// by that name, or it is one of source_instructions().
std::optional<Unsupported> unsupported_instruction(std::string_view name);
inline bool is_unsupported_name(std::string_view name) {
  return unsupported_instruction(name).has_value();
}

// Why the operand `text` (upper case) is refused; nothing when it has not the form of any operand
// that is known to be missing.
std::optional<Unsupported> unsupported_operand(std::string_view text);

// True for what may stand in place of an instruction: a label, P0; and where an interrupt program
// begins, I10, which is refused.
bool is_label(std::string_view text);
bool is_interrupt_label(std::string_view text);

// All instruction names of the table, for suggestions.
std::vector<std::string_view> unsupported_names();

}  // namespace rung
