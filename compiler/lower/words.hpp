// SPDX-License-Identifier: Apache-2.0
// Outputs on words.
#pragma once

#include "lower/context.hpp"

namespace rung::lower {

// Lower the current instruction if it is one of theirs; false if it is not.
bool lower_words(Context& context);       // moves, logic, ranges
bool lower_arithmetic(Context& context);  // + - * / and their kin
bool lower_shifts(Context& context);      // rotates and shifts
bool lower_codes(Context& context);       // BCD and BIN

}  // namespace rung::lower
