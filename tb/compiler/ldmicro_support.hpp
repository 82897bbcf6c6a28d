// SPDX-License-Identifier: Apache-2.0
// What the tests of LDmicro's front end and writer use.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "backends/ld_writer.hpp"
#include "ldmicro/ldmicro.hpp"
#include "support.hpp"

namespace rung {

// Decodes and parses the bytes of a file.
inline ParseResult parse_ld(std::string_view bytes, const std::string& file = "t.ld") {
  Diagnostics diagnostics;
  ParseResult result;
  if (const auto source = decode_ldmicro(bytes, file, diagnostics)) {
    result.program = parse_ldmicro(*source, diagnostics);
  }
  result.messages = printed(diagnostics);
  return result;
}

// A file of one rung with these lines, the first of which is line 4.
inline std::string ld_file(std::string_view elements, std::string_view header = "LDmicro0.1") {
  std::string text = fmt::format("{}\nPROGRAM\nRUNG\n{}", header, elements);
  return text + "\nEND\n";
}

// One line a rung: `RUNG | AND X0 | TON D0 4 50000us | ...`; numbers as they are, P.. as ports.
inline std::string dump_ld(const Program& program) {
  static constexpr std::string_view kNames[] = {
      "RUNG",   "COMMENT", "PARALLEL", "BRANCH", "JOIN", "SHORT", "OPEN", "OSR",   "OSF",
      "MASTER", "TON",     "TOF",      "RTO",    "RES",  "CTU",   "CTD",  "CTC",   "SHIFT",
      "LOOKUP", "LINEAR",  "ADC",      "PWM",    "KEEP", "SEND",  "RECV", "STRING"};
  static constexpr std::string_view kRelations[] = {"=", "<>", "<", ">", "<=", ">="};
  const auto name = [&](const Instruction& instruction) -> std::string {
    switch (instruction.op) {
      case Op::And:
        return "AND";
      case Op::Ani:
        return "ANI";
      case Op::AndCompare:
        return "AND" + std::string(kRelations[static_cast<std::size_t>(instruction.relation)]);
      case Op::Out:
        return "OUT";
      case Op::Outi:
        return "OUTI";
      case Op::Set:
        return "SET";
      case Op::Rst:
        return "RST";
      case Op::Mov:
        return "MOV";
      case Op::Add:
        return "ADD";
      case Op::Sub:
        return "SUB";
      case Op::Mul:
        return "MUL";
      case Op::Div:
        return "DIV";
      default:
        return std::string(
            kNames[static_cast<std::size_t>(instruction.op) - static_cast<std::size_t>(Op::Rung)]);
    }
  };
  std::string text;
  for (const Network& network : program.networks) {
    if (!text.empty()) text += '\n';
    for (std::size_t i = network.first; i < network.first + network.count; ++i) {
      const Instruction& instruction = program.instructions[i];
      if (i != network.first) text += " | ";
      text += name(instruction);
      for (const Operand& operand : instruction.operands)
        text += " " + dump(operand, Dialect::Ldmicro);
      if (instruction.base_us != 0) text += fmt::format(" {}us", instruction.base_us);
      if (!instruction.table.empty())
        text += fmt::format(" [{}]", fmt::join(instruction.table, " "));
      if (!instruction.note.empty()) text += " \"" + instruction.note + "\"";
    }
  }
  return text;
}

// The program that a file must give.
inline Program good_ld(std::string_view bytes) {
  ParseResult result = parse_ld(bytes);
  EXPECT_TRUE(result.program) << result.messages << bytes;
  return result.program ? std::move(*result.program) : Program{};
}

// Equal in everything but places and texts.
inline void expect_same(const Program& left, const Program& right) {
  EXPECT_EQ(dump_ld(left), dump_ld(right));
  EXPECT_EQ(left.names, right.names);
  ASSERT_TRUE(left.ldmicro && right.ldmicro);
  EXPECT_EQ(left.ldmicro->micro, right.ldmicro->micro);
  EXPECT_EQ(left.ldmicro->cycle_us, right.ldmicro->cycle_us);
  EXPECT_EQ(left.ldmicro->crystal_hz, right.ldmicro->crystal_hz);
  EXPECT_EQ(left.ldmicro->baud, right.ldmicro->baud);
  EXPECT_EQ(left.ldmicro->compiled, right.ldmicro->compiled);
  EXPECT_EQ(left.ldmicro->pins, right.ldmicro->pins);
}

// Writes the program, which must be possible, reads it again and expects the same.
inline std::string expect_ld_round_trip(const Program& program) {
  Diagnostics diagnostics;
  const auto text = to_ld(program, diagnostics);
  EXPECT_TRUE(text) << printed(diagnostics);
  if (!text) return {};
  const ParseResult again = parse_ld(*text);
  EXPECT_TRUE(again.program) << again.messages << *text;
  if (again.program) expect_same(program, *again.program);
  return *text;
}

// A file that uses every element, with comments, and every kind of line that a header has.
inline constexpr std::string_view kEveryElement =
    "LDmicro0.1\n"
    "MICRO=Atmel AVR ATmega128 64-TQFP\n"
    "CYCLE=10000\n"
    "CRYSTAL=4000000\n"
    "BAUD=2400\n"
    "COMPILED=C:\\out\\every.hex\n"
    "\n"
    "IO LIST\n"
    "    Xstart at 2\n"
    "    Ylamp at 3\n"
    "    Alevel at 61\n"
    "END\n"
    "\n"
    "PROGRAM\n"
    "RUNG\n"
    "    COMMENT One of each.\\r\\nBack\\\\slash.\n"
    "END\n"
    "RUNG\n"
    "END\n"
    "RUNG\n"
    "    CONTACTS Xstart 0\n"
    "    CONTACTS Rstop 1\n"
    "    PARALLEL\n"
    "        SERIES\n"
    "            OSR\n"
    "            PARALLEL\n"
    "                SHORT\n"
    "                OPEN\n"
    "            END\n"
    "        END\n"
    "        OSF\n"
    "        SERIES\n"
    "        END\n"
    "    END\n"
    "    COIL Ylamp 0 0 0\n"
    "    COIL Rstop 1 0 0\n"
    "    COIL Rstop 0 1 0\n"
    "    COIL Rstop 0 0 1\n"
    "END\n"
    "RUNG\n"
    "    TON Ton 50000\n"
    "    TOF Toff 20000\n"
    "    RTO Trto 100000\n"
    "    RES Trto\n"
    "    CTU Cup 5\n"
    "    CTD Cup -5\n"
    "    CTC Cring 7\n"
    "    MASTER_RELAY\n"
    "END\n"
    "RUNG\n"
    "    EQU Cup 1\n"
    "    NEQ Cup 2\n"
    "    GRT Cup Cring\n"
    "    GEQ 4 Cup\n"
    "    LES Cup 32767\n"
    "    LEQ -32768 Cup\n"
    "    MOVE a 97\n"
    "    ADD b a 1\n"
    "    SUB b a b\n"
    "    MUL b 3 b\n"
    "    DIV b b -2\n"
    "END\n"
    "RUNG\n"
    "    SHIFT_REGISTER stage 3\n"
    "    LOOK_UP_TABLE d a 3 1 72 105 33\n"
    "    PIECEWISE_LINEAR d b 3 -10 5 0 0 20 100\n"
    "    READ_ADC Alevel\n"
    "    SET_PWM d 1000\n"
    "    PERSIST kept\n"
    "    UART_SEND a\n"
    "    UART_RECV b\n"
    "    FORMATTED_STRING d 8 118 61 92 45 51 92 114 65\n"
    "    FORMATTED_STRING (none) 2 72 105\n"
    "END\n";

}  // namespace rung
