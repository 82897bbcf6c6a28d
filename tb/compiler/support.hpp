// SPDX-License-Identifier: Apache-2.0
// What several of the compiler's tests use.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "melsec/melsec.hpp"
#include "rungs/program.hpp"
#include "source/text_file.hpp"

namespace rung {

// The diagnostics as they are printed.
inline std::string printed(const Diagnostics& diagnostics) {
  std::ostringstream out;
  diagnostics.print(out);
  return out.str();
}

struct ParseResult {
  std::optional<Program> program;
  std::string messages;
};

// Decodes and parses `text` as if it came from `file`.
inline ParseResult parse(std::string_view text, std::optional<Dialect> dialect = std::nullopt,
                         const std::string& file = "t") {
  Diagnostics diagnostics;
  ParseResult result;
  if (const auto source = decode_text(text, file, diagnostics)) {
    result.program = parse_melsec(*source, dialect, diagnostics);
  }
  result.messages = printed(diagnostics);
  return result;
}

// Parses a program that must be good; an empty one, which fails the tests, if it is not.
inline Program good_program(std::string_view text, std::optional<Dialect> dialect = std::nullopt) {
  ParseResult result = parse(text, dialect);
  return result.program ? *result.program : Program{};
}

// An operand, for comparison: a timer's contact is TS0, its value TN0.
inline std::string dump(const Operand& operand, Dialect dialect) {
  switch (operand.kind) {
    case Operand::Kind::Constant:
    case Operand::Kind::Number:
      return fmt::format("{}", operand.value);
    case Operand::Kind::Digits:
      return fmt::format("{}x{}", operand.digits, device_name(operand.device, dialect));
    case Operand::Kind::WordBit:
      return fmt::format("{}.{}", device_name(operand.device, dialect), operand.bit);
    case Operand::Kind::Device:
      break;
  }
  std::string text = device_name(operand.device, dialect);
  if (operand.index) text += "[" + device_name(*operand.index, dialect) + "]";
  return text;
}

// One line a network, for comparison: `LD X0 | DADDP D0 1 D0 wide two | ...`.
inline std::string dump(const Program& program) {
  static constexpr std::string_view kNames[] = {
      "NOP",  "LABEL", "LD",   "LDI",  "AND",  "ANI",  "OR",   "ORI",  "LDP",  "LDF",  "ANDP",
      "ANDF", "ORP",   "ORF",  "LD?",  "AND?", "OR?",  "ANB",  "ORB",  "INV",  "MEP",  "MEF",
      "MPS",  "MRD",   "MPP",  "MC",   "MCR",  "STL",  "RET",  "OUT",  "OUTI", "OUTT", "OUTC",
      "SET",  "RST",   "PLS",  "PLF",  "ALT",  "SFT",  "SFTL", "SFTR", "BSFL", "BSFR", "MOV",
      "CML",  "BCD",   "BIN",  "XCH",  "SWAP", "BMOV", "FMOV", "ADD",  "SUB",  "MUL",  "DIV",
      "WAND", "WOR",   "WXOR", "WXNR", "INC",  "DEC",  "NEG",  "ROL",  "ROR",  "RCL",  "RCR",
      "SFL",  "SFR",   "WSFL", "WSFR", "DSFL", "DSFR", "CMP",  "ZCP",  "ZRST", "CJ",   "CALL",
      "SRET", "FEND",  "FOR",  "NEXT"};
  static_assert(std::size(kNames) == static_cast<std::size_t>(Op::Next) + 1);
  static constexpr std::string_view kRelations[] = {"=", "<>", "<", ">", "<=", ">="};
  std::string text(dialect_name(program.dialect));
  for (const Network& network : program.networks) {
    text += '\n';
    for (std::size_t i = network.first; i < network.first + network.count; ++i) {
      const Instruction& instruction = program.instructions[i];
      if (i != network.first) text += " | ";
      if (instruction.width == 32) text += 'D';
      text += kNames[static_cast<std::size_t>(instruction.op)];
      if (text.back() == '?') {
        text.pop_back();
        text += kRelations[static_cast<std::size_t>(instruction.relation)];
      }
      if (instruction.pulse) text += 'P';
      for (const Operand& operand : instruction.operands) {
        text += " " + dump(operand, program.dialect);
      }
      if (instruction.op == Op::OutT) text += fmt::format(" {}us", instruction.base_us);
      if (instruction.destination != 0) text += fmt::format(" ->{}", instruction.destination);
      if (instruction.double_width) text += " wide";
      if (instruction.two_operand) text += " two";
    }
  }
  return text;
}

}  // namespace rung
