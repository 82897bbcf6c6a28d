// SPDX-License-Identifier: Apache-2.0
// Which look-ups compute the bits of a program: cuts of its graph of ANDs with as many inputs as a
// look-up has operands.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "values/values.hpp"

namespace rung::wide {

inline constexpr int kMaxArity = 4;

// A way to compute a node: the nodes that are read, ascending, and the function of them: bit
// {leaf 0, leaf 1, ...} of `table`, the last leaf the lowest bit of the address.
struct Cut {
  std::array<values::NodeId, kMaxArity> leaves{};
  int size = 0;
  std::uint16_t table = 0;
  bool operator==(const Cut&) const = default;
};

struct Cover {
  std::vector<Cut> cuts;               // by node: its look-up if it gets one
  std::vector<bool> look_up;           // by node: a look-up computes it and its value is kept
  std::vector<std::int32_t> captures;  // by node: the test whose flag its look-up reads, or -1
};

// `roots`: nodes whose value must be kept; `gates`: nodes that are computed where they are used,
// once for each time that they stand there.
Cover cover(const values::Values& values, const std::vector<values::NodeId>& roots,
            const std::vector<values::NodeId>& gates, int arity);

}  // namespace rung::wide
