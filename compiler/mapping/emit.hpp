// SPDX-License-Identifier: Apache-2.0
// Pieces that both mappings (paper.cpp, mapper.cpp) build their operations with.
#pragma once

#include "mapping/mapping.hpp"

namespace rung::mapping {

// Appends `op` to the mapping and to `unit`; gives its number.
OpId append(Mapping& mapping, Unit& unit, MappedOp op);

// Appends the operations of action number `action` under the exc that operation `condition`
// computed, or under none if it always runs. What the multiply-divide unit leaves is collected by
// operations in `unit.collectors`.
void append_action(Mapping& mapping, Unit& unit, const logic::Logic& logic, std::int32_t action,
                   OpId condition, bool split_muldiv);

// A look-up with these inputs can also write `destination`: its third port is the one that reads
// the destination, so it must be free, N0, or the destination's own value.
bool can_write(const std::array<BitValue, 3>& inputs, const Destination& destination);

// Orders the inputs of a look-up so that c suits its destination and, of the orders that do, the
// one with the smallest function, so that equal functions share a row.
void order_inputs(MappedOp& op);

}  // namespace rung::mapping
