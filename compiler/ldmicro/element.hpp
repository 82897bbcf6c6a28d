// SPDX-License-Identifier: Apache-2.0
// One element of an LDmicro program: its line, read word by word.
#pragma once

#include <optional>
#include <string>

#include "ldmicro/header.hpp"
#include "ldmicro/lines.hpp"
#include "ldmicro/symbols.hpp"
#include "rungs/program.hpp"

namespace rung {

// What elements share while a file is read.
struct LdContext {
  const std::string& file;
  const LdHeader& header;
  Diagnostics& diagnostics;
  LdSymbols symbols;
  int kept = 0;          // PERSISTs so far
  std::string pwm_name;  // that 0.2 gives the PWM output

  void error(SourcePosition position, std::string what, std::string mend = {}) {
    diagnostics.error(file, position, std::move(what), std::move(mend));
  }
  void warn(SourcePosition position, std::string what, std::string mend = {}) {
    diagnostics.warning(file, position, std::move(what), std::move(mend));
  }
};

// The words of one element. What is wrong is reported where it is met; the value given then means
// nothing, and good() is false.
class LdElement {
 public:
  LdElement(const LdLine& line, LdContext& context) : line_(line), context_(context) {}

  const LdLine& line() const { return line_; }
  LdContext& context() { return context_; }
  bool good() const { return good_; }
  bool at_end() const { return at_ == line_.words.size(); }
  // Of words that have not been read.
  std::size_t left() const { return line_.words.size() - at_; }

  const LdWord& word() { return line_.words[at_++]; }
  const LdWord& peek() const { return line_.words[at_]; }

  // The next word as one of these; there must be one.
  Operand bit();
  Operand variable();
  Operand variable_or_number();
  int flag();                             // 0 or 1
  std::int64_t whole_number();            // a decimal number of 32 bits, nothing behind it
  std::int32_t number16(const char* of);  // whole_number() within 16 bits

  void refuse(SourcePosition position, std::string what, std::string mend = {}) {
    good_ = false;
    context_.error(position, std::move(what), std::move(mend));
  }

 private:
  std::string name();
  std::int32_t literal(const LdWord& word);
  bool fits16(const LdWord& word, std::int64_t value);

  const LdLine& line_;
  LdContext& context_;
  std::size_t at_ = 1;
  bool good_ = true;
};

// The instruction of an element's line, or nothing, with errors. PARALLEL, SERIES, END and RUNG are
// not elements.
std::optional<Instruction> read_ld_element(const LdLine& line, LdContext& context);

// The elements with a table or a text in their line.
void read_shift_register(LdElement& element, Instruction& instruction);
void read_look_up_table(LdElement& element, Instruction& instruction);
void read_piecewise_linear(LdElement& element, Instruction& instruction);
void read_formatted_string(LdElement& element, Instruction& instruction);

// What follows the operands of 0.1: refused where it would change what the element does.
void check_ld_tail(LdElement& element, Op op);

// Says why an unknown keyword is none.
void refuse_ld_keyword(const LdLine& line, LdContext& context);

}  // namespace rung
