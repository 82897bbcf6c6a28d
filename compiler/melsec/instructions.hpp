// SPDX-License-Identifier: Apache-2.0
// The instructions that lists may hold: one table drives the parser and the list writer.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rungs/program.hpp"

namespace rung {

// What an operand is to its instruction, and with that what it may be (operand_rules.hpp).
enum class Role : std::uint8_t {
  None,
  // Bits.
  Contact,     // read; may be indexed, or a bit of a word
  Edge,        // read; may be a bit of a word
  Coil,        // written; may be indexed, or a bit of a word
  Reset,       // as Coil, or a word, timer or counter
  Bit,         // written
  SourceBits,  // the first of a row that is read
  TargetBits,  // the first of a row that is written
  State,
  // Timers and counters.
  Timer,
  Counter,
  Preset,  // constant or word
  // Words.
  Source,       // constant, word or digit group
  Target,       // word or digit group
  WordTarget,   // word
  SourceBlock,  // the first of a row that is read: word or digit group
  TargetBlock,
  SourceWords,  // the first of a row that is read: word
  TargetWords,
  // Numbers.
  Count,    // a constant, in the range of count_range()
  Repeats,  // of a loop
  Pointer,  // P
  Level,    // N
  // ZRST.
  First,
  Last,
};

// A set of dialects, one bit each.
using DialectSet = std::uint8_t;
constexpr DialectSet dialect_bit(Dialect dialect) {
  return static_cast<DialectSet>(1U << static_cast<unsigned>(dialect));
}

// Properties of a row, one bit each.
enum InstructionFlag : std::uint8_t {
  kWideForm = 1,     // also for 32 bits: D before the name, or before the sign of a compare
  kPulseForm = 2,    // also executed on the rising edge only: P after the name
  kTwoOperands = 4,  // in paper and q also as `source, target`: target <- target op source
  kOnlyWide = 8,     // the name itself says 32 bits
  kOnlyPulse = 16,   // the name itself says: on the rising edge
};

struct SourceInstruction {
  std::string_view name;
  Op op;
  std::array<Role, 4> roles;
  DialectSet dialects;
  std::uint8_t flags = 0;
  Relation relation = Relation::Equal;

  bool has(InstructionFlag flag) const { return (flags & flag) != 0; }
  int operands() const;
};

// A row in the form that a name gives it: MOV, DMOV, MOVP, DMOVP are one row.
struct InstructionForm {
  const SourceInstruction* row;
  int width = 16;
  bool pulse = false;
};

// q's timer coil that counts tenths of the timer's base.
inline constexpr std::string_view kHighSpeedTimer = "OUTH";

// The whole table; END is not in it.
std::span<const SourceInstruction> source_instructions();
// All forms called `name` (upper case), of all dialects; OUT alone has several in one dialect
// (bits, timers, counters). Empty if there is none.
std::span<const InstructionForm> find_instruction(std::string_view name);
// All names, the usual ones first.
std::vector<std::string_view> instruction_names();
// What `instruction` is called in `dialect`: what the paper calls MV is MOV elsewhere, and so on.
// Empty if the dialect has no name for it.
std::string_view instruction_name(const Instruction& instruction, Dialect dialect);
// The same for the 16-bit form of an operation.
std::string_view instruction_name(Op op, Dialect dialect);

// How many operands an instruction takes.
struct OperandCount {
  int least;
  int most;
};
OperandCount operand_count(const SourceInstruction& row, Dialect dialect);
// The same for all forms of a name in all dialects: what the grouping of words needs.
OperandCount operand_count(std::span<const InstructionForm> forms);

// The least and the greatest number that a Role::Count of `op` may be.
struct CountRange {
  int least;
  int most;
};
CountRange count_range(Op op, int width, Dialect dialect);

}  // namespace rung
