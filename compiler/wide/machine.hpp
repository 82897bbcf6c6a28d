// SPDX-License-Identifier: Apache-2.0
// MPU4 in numbers: what hdl/isa/wide.toml says of it, and what an exploration varies.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace rung::wide {

enum class Opcode : std::uint8_t {
#define RUNG_WIDE_OP(id, name, code) id = code,
#define RUNG_WIDE_CONFIG(...)
#define RUNG_WIDE_NUMBER(...)
#include "wide_table.inc"
};
std::string_view name_of(Opcode opcode);
// Nothing else has this code.
bool is_opcode(unsigned code);

// Constants of the table: layout_row_bits, distance_memory, scan_fill and so on.
namespace constant {
#define RUNG_WIDE_OP(...)
#define RUNG_WIDE_CONFIG(...)
#define RUNG_WIDE_NUMBER(name, value) inline constexpr int name = value;
#include "wide_table.inc"
}  // namespace constant

struct Machine {
  std::string_view name;
  int slots = 8;
  int units = 4;
  int arity = 3;
  int rows = 0;       // of the bit memories, steps included
  int word_rows = 0;  // of the word memories
  int steps = 0;
  // Distances: what the same slot or unit computed can be used so many steps later, what another
  // one did, and an old value so many steps after it is replaced.
  int own = 1;
  int other = constant::near_bus_first;
  int old = constant::distance_old;
  int mul = constant::distance_mul;
  int div = constant::distance_div;
  // Steps from one start of a unit's divider to the next.
  int div_interval = constant::distance_div_interval;
  // Units that have a divider: the first so many.
  int dividers = 2;
  // Of an exploration: results of others that one slot can take in a step; 0: all of them.
  int captures = 0;
};

// MPU4 with so many slots, or null.
const Machine* find_machine(int slots);
std::span<const Machine> machines();

}  // namespace rung::wide
