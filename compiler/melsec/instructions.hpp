// SPDX-License-Identifier: Apache-2.0
// The instructions that lists may hold: one table drives the parser and the list writer.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "rungs/program.hpp"

namespace rung {

// What operands an instruction takes.
enum class OperandForm : std::uint8_t {
  None,
  Contact,     // a bit device that is read
  Coil,        // a bit device that is written
  Reset,       // a bit device, or a word device to be cleared
  Move,        // source, target
  Arithmetic,  // source, source, target; where two will do: source, target
};

// A set of dialects, one bit each.
using DialectSet = std::uint8_t;
constexpr DialectSet dialect_bit(Dialect dialect) {
  return static_cast<DialectSet>(1U << static_cast<unsigned>(dialect));
}

struct SourceInstruction {
  std::string_view name;
  Op op;
  OperandForm form;
  DialectSet dialects;
};

// The whole table; END is not in it.
std::span<const SourceInstruction> source_instructions();
// The row called `name` (upper case), or null.
const SourceInstruction* find_instruction(std::string_view name);
// The name of `op` in `dialect`: what the paper calls MV is MOV elsewhere, and so on.
std::string_view instruction_name(Op op, Dialect dialect);

// How many operands the form takes in `dialect`.
struct OperandCount {
  int least;
  int most;
};
OperandCount operand_count(OperandForm form, Dialect dialect);
// The same in any dialect: what the grouping of words into instructions needs.
OperandCount operand_count(OperandForm form);

}  // namespace rung
