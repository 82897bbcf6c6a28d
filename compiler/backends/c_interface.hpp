// SPDX-License-Identifier: Apache-2.0
// What surrounds the instructions: the functions that a user calls, the devices' variables, time.
#pragma once

#include "backends/c_source.hpp"
#include "backends/c_unit.hpp"

namespace rung {

// The head comment, the prototypes and the variables. The instructions are in `unit.body` already,
// so that it is known what they need.
void write_declarations(const CUnit& unit, CSource& source);
// The functions that know the devices: reset, access by number and by name; or the bare table.
void write_accessors(const CUnit& unit, CSource& source);
// At the beginning and the end of a scan, to the body: time, special relays, hooks.
void write_scan_start(CUnit& unit);
void write_scan_end(CUnit& unit);
// The helper that sets the error relays.
void write_fault(const CUnit& unit, CSource& source);

}  // namespace rung
