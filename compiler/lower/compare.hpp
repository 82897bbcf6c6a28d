// SPDX-License-Identifier: Apache-2.0
// Compares: contacts, CMP and ZCP.
#pragma once

#include "lower/context.hpp"

namespace rung::lower {

// A bit with the result of a compare, or with its opposite.
struct Test {
  Device bit;
  bool inverted = false;
};

// The compare contact that is the current instruction; an operand out of its window makes it 0.
Test compare_contact(Context& context);

// hidden bit <- a = b, a < b (signed)
Device test_equal(Context& context, const Pair& a, const Pair& b, int width);
Device test_less(Context& context, const Pair& a, const Pair& b, int width);

void lower_cmp(Context& context);
void lower_zcp(Context& context);

}  // namespace rung::lower
