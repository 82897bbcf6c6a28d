// SPDX-License-Identifier: Apache-2.0
// "Did you mean": the known word nearest to an unknown one.
#pragma once

#include <span>
#include <string_view>

namespace rung {

// The one of `names` that differs from `word` by the fewest edits (insert, delete, replace or swap
// a character), at most 1 in a short word and 2 in one of more than four characters; empty when
// none is that near. The first of several.
std::string_view nearest(std::string_view word, std::span<const std::string_view> names);

}  // namespace rung
