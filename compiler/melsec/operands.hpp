// SPDX-License-Identifier: Apache-2.0
// Operands of list instructions: what the words say, and what is wrong about them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "melsec/instructions.hpp"
#include "melsec/lexer.hpp"
#include "rungs/program.hpp"

namespace rung {

// True for what has the form of an operand of some dialect: a known letter and a digit, mostly.
bool looks_like_operand(std::string_view upper);
// The timer or counter that `upper` names (its contact), or nothing.
std::optional<Device> timer_or_counter(std::string_view upper, Dialect dialect);
// As people write it: T0, whether a timer's contact or its value is meant.
std::string source_name(Device device, Dialect dialect);
// What a message calls a device of `kind`: "a relay".
std::string_view kind_name(DeviceKind kind);

// Reads the operands of one instruction in turn and reports what is wrong with each at its place.
class OperandReader {
 public:
  // `instruction` is the mnemonic, for the messages.
  OperandReader(const std::string& file, Dialect dialect, std::string instruction,
                Diagnostics& diagnostics);

  // The operand that `word` is, if it may stand in this role of an instruction of this width.
  std::optional<Operand> read(const ListWord& word, Role role, int width);

  // Reports that `word` is no operand, or one that is refused in all roles.
  void refuse(const ListWord& word);
  void error(const ListWord& word, const std::string& what, std::string mend = {});

 private:
  // Whatever operand `word` is, in any role.
  std::optional<Operand> parse(const ListWord& word, int width);
  std::optional<Device> device(const ListWord& word, std::string_view name);
  std::optional<Operand> constant(const ListWord& word, int width);
  std::optional<Operand> digits(const ListWord& word);
  std::optional<Operand> word_bit(const ListWord& word, std::size_t dot);
  std::optional<Operand> indexed(const ListWord& word, std::size_t at);
  std::optional<Operand> number(const ListWord& word, int most);
  void explain(const ListWord& word, std::string_view name, DeviceKind kind, bool digit);

  bool fits(const ListWord& word, const Operand& operand, Role role, int width);
  bool fits_bit(const ListWord& word, const Operand& operand, Role role);
  bool fits_word(const ListWord& word, Operand& operand, Role role, int width);
  bool fits_index(const ListWord& word, const Operand& operand, Role role);

  const std::string& file_;
  Dialect dialect_;
  std::string instruction_;
  Diagnostics& diagnostics_;
};

}  // namespace rung
