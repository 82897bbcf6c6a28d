// SPDX-License-Identifier: Apache-2.0
// Outputs on bits.
#pragma once

#include "lower/context.hpp"

namespace rung::lower {

// Lowers the current instruction if it writes bits (coils, pulses, shifts); false if it does not.
bool lower_bits(Context& context);

}  // namespace rung::lower
