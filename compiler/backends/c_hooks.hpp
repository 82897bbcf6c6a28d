// SPDX-License-Identifier: Apache-2.0
// What surrounds an LDmicro program: its named devices, and the hooks, which are functions that its
// user writes, one for each input, output and peripheral that the program has.
#pragma once

#include "backends/c_source.hpp"
#include "backends/c_unit.hpp"

namespace rung {

// The lines of the head comment that say how the file is used.
void write_hooks_manual(const CUnit& unit, CSource& source);
// Prototypes of the hooks and of the access to internal devices.
void write_hooks_prototypes(const CUnit& unit, CSource& source);
// Of the devices' structure.
void write_named_variables(const CUnit& unit, CSource& source);
// The access to internal relays and variables.
void write_named_access(const CUnit& unit, CSource& source);
// The lines of a cycle before and after the scan.
void write_hooks_before(const CUnit& unit, CSource& source);
void write_hooks_after(const CUnit& unit, CSource& source);

}  // namespace rung
