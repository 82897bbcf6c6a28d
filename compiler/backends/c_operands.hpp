// SPDX-License-Identifier: Apache-2.0
// The operands of one instruction as C expressions, and stores to them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "backends/c_unit.hpp"

namespace rung {

// The expression without parentheses around all of it.
std::string_view bare(std::string_view expression);

class COperands {
 public:
  COperands(CUnit& unit, const Instruction& instruction) : unit_(unit), instruction_(instruction) {}

  // Value of operand `i`, a bit: 0 or 1.
  std::string bit(std::size_t i) const;
  // A statement that writes it; `value` is an expression that gives 0 or 1.
  std::string set_bit(std::size_t i, std::string_view value) const;

  // Value of operand `i` as a signed number of `width` bits.
  std::string value(std::size_t i, int width) const;
  std::string value(std::size_t i) const { return value(i, instruction_.width); }
  // What a contact reads: the same, but 0 where an index leads outside of the window.
  std::string read_bit(std::size_t i) const;
  std::string read_value(std::size_t i) const;
  // The variable of operand `i`; of several words the first.
  std::string place(std::size_t i) const;
  // Writes lines that store the low `width` bits of `value`, the name of an unsigned variable.
  void store(std::size_t i, int width, std::string_view value) const;
  // The same for any operand without an index.
  std::string value(const Operand& operand, int width) const;
  void store(const Operand& operand, int width, std::string_view value) const;

  bool indexed() const;
  // Where operands have an index: lines that compute the numbers i0, i1, ... they stand for.
  void declare_indices() const;
  // A condition that is true where operand `i`, with `words` words, is outside of its window.
  std::string outside(std::size_t i, int words) const;
  // The same of any operand of the instruction.
  std::string any_outside() const;

 private:
  std::string value_of(const Operand& operand, const std::vector<std::string>& words,
                       int width) const;
  void store_words(const std::vector<std::string>& words, std::string_view value) const;
  std::vector<std::string> places(std::size_t i, int width) const;
  std::vector<std::string> places(const Operand& operand, int width) const;
  int words_of_operand(std::size_t i) const;

  CUnit& unit_;
  const Instruction& instruction_;
};

}  // namespace rung
