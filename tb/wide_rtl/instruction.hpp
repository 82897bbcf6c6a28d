// SPDX-License-Identifier: Apache-2.0
// Instructions of MPU4 as the tests write them, and their bits: hdl/wide/README.md, written down a
// second time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "wide/machine.hpp"

namespace rung::tb::wide {

using rung::wide::Opcode;
namespace constant = rung::wide::constant;

// A place, or with a special row a near value.
struct Place {
  int row = 0;
  int lane = 0;
  bool operator==(const Place&) const = default;
};

inline constexpr int kRows = 1 << constant::layout_row_bits;
inline constexpr int kSpecial =
    kRows - (1 << (constant::layout_row_bits - constant::layout_special_bits));

inline bool is_special(int row) { return row >= kSpecial; }
// What the same slot or unit computed so many (1, 2) steps ago.
inline Place own(int steps) { return {kSpecial + constant::near_own_first + steps - 1, 0}; }
inline Place zero() { return {kSpecial + constant::near_zero, 0}; }
inline Place flag() { return {kSpecial + constant::near_flag, 0}; }
// What `lane` computed so many (3 to 5) steps ago.
inline Place bus(int steps, int lane) { return {kSpecial + steps, lane}; }
// `keep`: what the own unit computed so many (1 to 5) steps ago.
inline int keep_near(int steps) { return kSpecial + steps; }

struct BitInstruction {
  std::uint8_t table = 0;
  std::array<Place, 3> operands{};  // a, b, c
};

enum class Kind : std::uint8_t { Places = 0, ConstantS2 = 1, ConstantS1 = 2 };

struct WordInstruction {
  Opcode op = Opcode::Nop;
  Kind kind = Kind::Places;
  bool always = false;
  std::uint16_t constant = 0;
  Place s1{};  // with ConstantS1 the place of s2
  Place s2{};
  int keep = 0;
};

// A step: an instruction of every slot and one of every unit.
struct Step {
  std::vector<BitInstruction> bits;
  std::vector<WordInstruction> words;
};

// The bits of slot `slot`'s instruction in chunks of 16, the lowest first, as the load port takes
// them.
std::vector<std::uint16_t> chunks(const Step& step, int slot);

}  // namespace rung::tb::wide
