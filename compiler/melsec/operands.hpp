// SPDX-License-Identifier: Apache-2.0
// Operands of list instructions: devices and constants, with what is wrong about them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "melsec/lexer.hpp"
#include "rungs/program.hpp"

namespace rung {

// True for what has the form of a device or constant, of whatever kind: a known letter and a digit.
bool looks_like_operand(std::string_view upper);

// Reads the operands of one instruction in turn and reports what is wrong with each at its place.
class OperandReader {
 public:
  // `instruction` is the mnemonic, for the messages.
  OperandReader(const std::string& file, Dialect dialect, std::string instruction,
                Diagnostics& diagnostics);

  // A bit device to be read.
  std::optional<Device> contact(const ListWord& word);
  // A bit device to be written: Y or M.
  std::optional<Device> coil(const ListWord& word);
  // What RST takes: as coil(), or a word device.
  std::optional<Device> coil_or_word(const ListWord& word);
  // A constant (K -32768 to 32767, H 0 to FFFF) or a word device.
  std::optional<WordSource> source(const ListWord& word);
  // A word device to be written, and with `double_width` the next one too.
  std::optional<Device> target(const ListWord& word, bool double_width);

 private:
  std::optional<Device> device(const ListWord& word);
  std::optional<WordSource> constant(const ListWord& word);
  bool is_constant(const ListWord& word) const;
  void explain(const ListWord& word, Device parsed, bool digit);
  void error(const ListWord& word, const std::string& what, std::string mend = {});

  const std::string& file_;
  Dialect dialect_;
  std::string instruction_;
  Diagnostics& diagnostics_;
};

}  // namespace rung
