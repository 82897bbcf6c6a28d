// SPDX-License-Identifier: Apache-2.0
// `rung translate --to il`: every instruction, in every form and dialect, reads back as it was.
#include <gtest/gtest.h>

#include <filesystem>

#include "backends/list_writer.hpp"
#include "melsec/instructions.hpp"
#include "support.hpp"

namespace rung {
namespace {

namespace fs = std::filesystem;

void expect_round_trip(const Program& program) {
  const std::string list = to_list(program);
  const ParseResult again = parse(list, program.dialect);
  ASSERT_TRUE(again.program) << again.messages << list;
  EXPECT_EQ(dump(*again.program), dump(program));
  EXPECT_EQ(to_list(*again.program), list);
}

// An operand for a role, as different as the role allows.
std::string example(Role role, Op op, int width, Dialect dialect) {
  const bool wide = width == 32;
  switch (role) {
    case Role::Contact:
      return dialect == Dialect::Paper ? "X7" : "X17Z1";
    case Role::Edge:
      return dialect == Dialect::Fx ? "D20.F" : "Y7";
    case Role::Coil:
      return dialect == Dialect::Paper ? "M5" : "M5Z0";
    case Role::Reset:
      return dialect == Dialect::Paper ? "D5" : "C5";
    case Role::Bit:
      return "M7";
    case Role::SourceBits:
      return "X0";
    case Role::TargetBits:
      return "M100";
    case Role::State:
      return "S20";
    case Role::Timer:
      return dialect == Dialect::Q ? "ST3" : "T250";
    case Role::Counter:
      return "C200";
    case Role::Preset:
      return op == Op::OutC ? "K5" : "D5";
    case Role::Source:
      return wide ? "K-70000" : dialect == Dialect::Paper ? "K4X0" : "D9Z1";
    case Role::Target:
      return wide ? "K8M0" : "D11";
    case Role::WordTarget:
      return "D30";
    case Role::SourceBlock:
      return "K2X0";
    case Role::TargetBlock:
      return "D40";
    case Role::SourceWords:
      return "D50";
    case Role::TargetWords:
      return "D60";
    case Role::Count:
      return "K3";
    case Role::Repeats:
      return "K2";
    case Role::First:
      return dialect == Dialect::Paper ? "D0" : "T0";
    case Role::Last:
      return dialect == Dialect::Paper ? "D5" : "T5";
    case Role::Pointer:
      return "P5";
    case Role::Level:
      return "N0";
    case Role::None:
      break;
  }
  return {};
}

// What has to stand around an instruction to make a program of it.
std::string program_with(const std::string& instruction, Op op) {
  const std::string result = "LD M0\n";
  const std::string end = "\nEND";
  switch (op) {
    case Op::Anb:
    case Op::Orb:
      return "LD M0\nLD M1\n" + instruction + "\nOUT Y0" + end;
    case Op::Mps:
    case Op::Mrd:
    case Op::Mpp:
      return "LD M0\nMPS\nOUT Y0\nMRD\nOUT Y1\nMPP\nOUT Y2" + end;
    case Op::Mc:
      return result + instruction + "\nMCR N0" + end;
    case Op::Mcr:
      return result + "MC N0 M3\n" + instruction + end;
    case Op::Stl:
    case Op::Ret:
      return "STL S20\nOUT Y0\nSTL S21\nLD X0\nSET S20\nRET" + end;
    case Op::Cj:
      return result + instruction + "\nLD X0\nOUT Y0\nP5" + end;
    case Op::Call:
    case Op::Fend:
      return result + "CALL P5\n" + (op == Op::Call ? "LD X0\n" + instruction + "\n" : "") +
             "FEND\nP5\nLD X0\nOUT Y0\nSRET" + end;
    case Op::Sret:
      return result + "CALL P5\nFEND\nP5\nLD X0\nOUT Y0\n" + instruction + end;
    case Op::For:
    case Op::Next:
      return "FOR K2\nLD X0\nOUT Y0\nNEXT" + end;
    case Op::Nop:
      return instruction + end;
    default:
      break;
  }
  if (is_load(op)) return instruction + "\nOUT Y0" + end;
  if (is_output(op)) return result + instruction + end;
  return result + instruction + "\nOUT Y0" + end;
}

TEST(RoundTrip, OfEveryForm) {
  int forms = 0;
  for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q}) {
    for (const std::string_view name : instruction_names()) {
      for (const InstructionForm& form : find_instruction(name)) {
        const SourceInstruction& row = *form.row;
        if ((row.dialects & dialect_bit(dialect)) == 0) continue;
        const OperandCount count = operand_count(row, dialect);
        for (int given = count.least; given <= count.most; ++given) {
          std::string instruction(name);
          for (int i = count.most - given; i < count.most; ++i) {
            const Role role = row.roles[static_cast<std::size_t>(i)];
            // The target of two operands is a source too.
            instruction += " " + example(role, row.op, form.width, dialect);
          }
          const ParseResult result = parse(program_with(instruction, row.op), dialect);
          ASSERT_TRUE(result.program) << instruction << "\n" << result.messages;
          const auto& code = result.program->instructions;
          EXPECT_TRUE(std::any_of(code.begin(), code.end(), [&](const Instruction& each) {
            return each.op == row.op && each.pulse == form.pulse;
          })) << instruction;
          expect_round_trip(*result.program);
          ++forms;
        }
      }
    }
  }
  EXPECT_GT(forms, 400);
}

TEST(RoundTrip, OfOperands) {
  for (const char* const text :
       {"LD T5\nAND C200\nOR S3\nMOV T5 C7\nDMOV C200 D0\nOUT C200 K-70000\nRST C200\nEND",
        "LD D0.A\nOUT D7.0\nMOV K1X0 K4Y10\nMOV D0V3 D1Z7\nMOV K-1 D0\nMOV V Z\nEND",
        "LD M8000\nOUT M8200\nZRST C200 C234\nEND"}) {
    expect_round_trip(good_program(text, Dialect::Fx));
  }
  for (const char* const text :
       {"LD SM400\nOUTH T5 K10\nOUTH ST5 D0\nOUT ST5 W1F\nMOV ST5 D0\nLD W1F.3\nOUT B1A\nEND",
        "LD X1F\nOR L5\nOUT F7\nMOV K4B10 W1A\nMOV D0Z19 SW7\nSET SM700\nEND"}) {
    expect_round_trip(good_program(text, Dialect::Q));
  }
}

TEST(RoundTrip, OfRealPrograms) {
  const fs::path folder = fs::path(RUNG_REPOSITORY) / "../shared/programs/melsec";
  if (!fs::exists(folder)) GTEST_SKIP() << "skipped: no corpus";
  int programs = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    Diagnostics diagnostics;
    const auto source = read_text(entry.path().string(), diagnostics);
    ASSERT_TRUE(source) << entry.path();
    const auto program = parse_melsec(*source, std::nullopt, diagnostics);
    EXPECT_EQ(program.has_value(), !diagnostics.has_errors()) << entry.path();
    if (!program) continue;
    expect_round_trip(*program);
    ++programs;
  }
  EXPECT_GE(programs, 26);
}

}  // namespace
}  // namespace rung
