// SPDX-License-Identifier: Apache-2.0
// What each output instruction does, as C (compiler/SEMANTICS.md).
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "backends/c_operands.hpp"
#include "backends/c_unit.hpp"

namespace rung {

// When an instruction is executed.
struct CCondition {
  std::string result;          // of the contacts: 0 or 1
  std::string power;           // of the zones: 0 or 1; empty outside of all
  std::string cond;            // both
  std::string executed;        // cond; of a pulse form, where cond was 0 before
  std::vector<Device> states;  // whose zone the instruction is in
};

// Writes what `lines` writes, to be executed where `guard` is 1 and all indices are inside of their
// windows; else that is an error. No guard: always.
void write_guarded(CUnit& unit, const COperands& operands, std::string_view guard,
                   const std::function<void()>& lines);

// Each is given its own kind of instructions and gives false for all others.
bool write_bits(CUnit& unit, const Instruction& instruction, const CCondition& condition);
bool write_timers_counters(CUnit& unit, const Instruction& instruction,
                           const CCondition& condition);
bool write_words(CUnit& unit, const Instruction& instruction, const CCondition& condition);
bool write_arithmetic(CUnit& unit, const Instruction& instruction, const CCondition& condition);
bool write_rotates(CUnit& unit, const Instruction& instruction, const CCondition& condition);
bool write_shifts(CUnit& unit, const Instruction& instruction, const CCondition& condition);
bool write_blocks(CUnit& unit, const Instruction& instruction, const CCondition& condition);

// Elements of an LDmicro program with variables; `s` is the variable of the condition, which they
// change.
bool write_counts(CUnit& unit, const Instruction& instruction, const std::string& s);
bool write_tables(CUnit& unit, const Instruction& instruction, const std::string& s);
bool write_peripherals(CUnit& unit, const Instruction& instruction, const std::string& s);

// A line that puts `value` into the special relays of this role that the program names.
void write_flag(CUnit& unit, SpecialRole role, std::string_view value);

}  // namespace rung
