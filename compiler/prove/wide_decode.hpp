// SPDX-License-Identifier: Apache-2.0
// MPU4's instructions from the chunks that its load port gets: a decoder of its own, written from
// the layout in hdl/wide/README.md.
#pragma once

#include <optional>
#include <vector>

#include "wide/code.hpp"

namespace rung::prove {

// Of all slots, the instruction of one step. Nothing if one is none of this processor's.
std::optional<wide::Step> decode(const std::vector<std::vector<std::uint16_t>>& slots,
                                 const wide::Machine& machine);

}  // namespace rung::prove
