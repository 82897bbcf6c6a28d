// SPDX-License-Identifier: Apache-2.0
// Conditions and actions as rungs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "flowchart/expression.hpp"
#include "flowchart/flowchart.hpp"
#include "flowchart/logic.hpp"

namespace rung::flowchart {

// What the rungs of all steps need to know.
struct Frame {
  std::string file;
  Dialect dialect = Dialect::Fx;
  std::vector<bool> starts;  // by task
  std::vector<bool> asked;   // by task: some condition asks whether it runs
};

// Makes the rungs of one step.
class RungWriter {
 public:
  RungWriter(const Frame& frame, std::size_t task) : frame_(frame), task_(task) {}

  // `failed` means here: a read failed before, or the last transfer did.
  void failed_of_read_too() { read_too_ = true; }

  // Rungs that compute its words, and what is left for contacts.
  Logic condition(const Expression& expression);
  // One or more outputs under the same condition.
  void outputs(const Logic& guard, std::vector<Instruction> instructions);
  void assign_bit(const Operand& bit, const Logic& logic, SourcePosition position);
  void assign_word(const Operand& target, const Expression& expression, const Logic& guard,
                   SourcePosition position);
  void start_or_stop(std::size_t task, bool start, const Logic& guard, SourcePosition position);
  // Where `guard` holds, the next step is this one, or the task ends.
  void go(std::int16_t step, const Logic& guard, SourcePosition position);
  // The task's own bit, where it ends.
  void note_end(const Logic& guard, SourcePosition position);

  // The words of what was written so far are not needed any more.
  void forget_words() { words_ = 0; }

  static Instruction instruction(Op op, std::vector<Operand> operands, SourcePosition position);

  Program take();

 private:
  // The value of an expression: a constant, a device, or scratch with rungs that compute it. Where
  // it divides, `valid` is narrowed to when it does not divide by 0.
  Operand value(const Expression& expression, Logic& valid);
  Operand remainder(const Expression& expression, Logic& valid);
  void narrow(const Operand& divisor, Logic& valid, SourcePosition position) const;
  Device scratch_word() { return scratch(words_++); }
  Instruction always(SourcePosition position) const;
  // Bit: whether task runs is not as it was at the start.
  Instruction turned(std::size_t task, bool runs, SourcePosition position) const;

  const Frame& frame_;
  std::size_t task_;
  bool read_too_ = false;
  bool always_open_ = false;  // the last network is one that always runs
  std::uint32_t words_ = 0;
  std::vector<Instruction> instructions_;
};

// "LD> D0 K5": a list's instruction, with names for what no program names.
std::string instruction_text(const Instruction& instruction, Dialect dialect);

}  // namespace rung::flowchart
