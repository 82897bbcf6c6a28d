// SPDX-License-Identifier: Apache-2.0
// Timers and counters.
#pragma once

#include "lower/context.hpp"

namespace rung::lower {

// Marks of timers whose ticks may be asked for more than once in a scan go off at its start.
void begin_timers(Context& context);

void lower_timer(Context& context);
void lower_counter(Context& context);
// RST of a timer or counter.
void reset_timer(Context& context);

}  // namespace rung::lower
