// SPDX-License-Identifier: Apache-2.0
// Instructions of MPU4 as fields and as bits; hdl/wide/README.md says where each field is.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "wide/cover.hpp"
#include "wide/machine.hpp"

namespace rung::wide {

// A row, or one of the near values behind `constant::special_row`.
struct Operand {
  int row = 0;
  int lane = 0;
  bool operator==(const Operand&) const = default;
};
inline constexpr int kSpecialRow =
    (1 << constant::layout_row_bits) -
    (1 << (constant::layout_row_bits - constant::layout_special_bits));
inline constexpr Operand near_value(int code, int lane = 0) { return {kSpecialRow + code, lane}; }
inline bool is_near(const Operand& operand) { return operand.row >= kSpecialRow; }

struct BitInstruction {
  std::uint16_t table = 0;
  std::array<Operand, kMaxArity> inputs{};  // as many as the arity; the first is a
  bool operator==(const BitInstruction&) const = default;
};

struct WordInstruction {
  Opcode opcode = Opcode::Nop;
  bool always = false;
  int kind = 0;
  Operand keep, s1, s2;
  std::uint16_t constant = 0;  // kinds 1 and 2, in the place of s2
  bool operator==(const WordInstruction&) const = default;
};

struct Step {
  std::vector<BitInstruction> bits;    // by slot
  std::vector<WordInstruction> words;  // by unit
  bool operator==(const Step&) const = default;
};

// 16-bit chunks of the instruction of one slot, the lowest first: what the load port takes.
using Chunks = std::vector<std::uint16_t>;
int chunks_of(const Machine& machine, int slot);
Chunks encode(const Step& step, int slot, const Machine& machine);
// The reverse, into `step`, which has its vectors; false if it is no instruction.
bool decode(const Chunks& chunks, int slot, const Machine& machine, Step& step);

// Of the slot's instruction: what it computes of what, for a listing.
std::string disassemble(const Step& step, int slot, const Machine& machine);

}  // namespace rung::wide
