// SPDX-License-Identifier: Apache-2.0
// Why a special relay or register is refused: what of a maker's controller it belongs to.
#pragma once

#include <string_view>

#include "melsec/unsupported.hpp"

namespace rung {

// The reason for `name` (M8029, SD1880; upper case), which has the form of a special device of
// `dialect` but is none that this controller has.
Unsupported special_reason(std::string_view name, Dialect dialect);

}  // namespace rung
