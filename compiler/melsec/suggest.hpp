// SPDX-License-Identifier: Apache-2.0
// "Did you mean": the known word nearest to an unknown one.
#pragma once

#include <string_view>

namespace rung {

// The name of a supported or known MELSEC instruction that differs from `word` (upper case) by the
// fewest edits (insert, delete, replace or swap a character), at most 1 in a short word and 2 in
// one of more than four characters; empty when none is that near. Supported ones win a tie.
std::string_view suggest_instruction(std::string_view word);

}  // namespace rung
