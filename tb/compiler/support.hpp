// SPDX-License-Identifier: Apache-2.0
// What several of the compiler's tests use.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "melsec/list.hpp"
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
    result.program = parse_list(*source, dialect, diagnostics);
  }
  result.messages = printed(diagnostics);
  return result;
}

// Parses a program that must be good; an empty one, which fails the tests, if it is not.
inline Program good_program(std::string_view text, std::optional<Dialect> dialect = std::nullopt) {
  ParseResult result = parse(text, dialect);
  return result.program ? *result.program : Program{};
}

// One line a network, for comparison: `LD X0 | ADD D0 K1 -> D0 wide two | ...`.
inline std::string dump(const Program& program) {
  static constexpr std::string_view kNames[] = {"NOP", "LD",  "LDI", "AND", "ANI", "OR",  "ORI",
                                                "ANB", "ORB", "MPS", "MRD", "MPP", "OUT", "SET",
                                                "RST", "MOV", "ADD", "SUB", "MUL", "DIV"};
  std::string text(dialect_name(program.dialect));
  for (const Network& network : program.networks) {
    text += '\n';
    for (std::size_t i = network.first; i < network.first + network.count; ++i) {
      const Instruction& instruction = program.instructions[i];
      if (i != network.first) text += " | ";
      text += kNames[static_cast<std::size_t>(instruction.op)];
      const std::string device = device_name(instruction.device, program.dialect);
      const auto source = [&](const WordSource& word) {
        return word.constant ? fmt::format("{}", word.value)
                             : device_name(word.device, program.dialect);
      };
      if (is_contact(instruction.op) || (instruction.op >= Op::Out && instruction.op <= Op::Rst)) {
        text += " " + device;
      } else if (instruction.op == Op::Mov) {
        text += fmt::format(" {} -> {}", source(instruction.sources[0]), device);
      } else if (instruction.op > Op::Mov) {
        text += fmt::format(" {} {} -> {}", source(instruction.sources[0]),
                            source(instruction.sources[1]), device);
      }
      if (instruction.double_width) text += " wide";
      if (instruction.two_operand) text += " two";
    }
  }
  return text;
}

}  // namespace rung
