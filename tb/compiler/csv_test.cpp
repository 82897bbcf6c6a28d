// SPDX-License-Identifier: Apache-2.0
// Programs in CSV: the forms that the makers' tools write, the dialect of each, and what is
// refused.
#include "melsec/csv.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "melsec/csv_list.hpp"
#include "melsec/steps.hpp"
#include "refused.hpp"

namespace rung {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(RUNG_REPOSITORY) / "../shared/programs/melsec";

struct Form {
  const char* name;
  const char* file;
  const char* text;
  const char* dump;
};

class CsvForms : public testing::TestWithParam<Form> {};

TEST_P(CsvForms, GiveThisProgram) {
  const ParseResult result = parse(GetParam().text, std::nullopt, GetParam().file);
  EXPECT_EQ(result.messages, "");
  ASSERT_TRUE(result.program);
  EXPECT_EQ(dump(*result.program), GetParam().dump);
}

constexpr Form kForms[] = {
    {"GxWorks2", "a.csv",
     "\"MAIN\"\r\n\"PC\u60C5\u5831:\"\t\"FXCPU FX3U/FX3UC\"\r\n"
     "\"\u30B9\u30C6\u30C3\u30D7\"\t\"a\"\t\"b\"\t\"I/O\"\t\"\"\t\"PI\"\t\"c\"\r\n"
     "\"0\"\t\" * a line, with \"\"quotes\"\"\"\t\"\"\t\"\"\t\"\"\t\"\"\t\"\"\r\n"
     "\"18\"\t\"\"\t\"LD\"\t\"X010\"\t\"\"\t\"\"\t\"\"\r\n"
     "\"19\"\t\"\"\t\"OUT\"\t\"T0\"\t\"\"\t\"\"\t\"\"\r\n"
     "\"\"\t\"\"\t\"\"\t\"K50\"\t\"\"\t\"\"\t\"\"\r\n"
     "\"\"\t\"\"\t\"\"\t\"\"\t\"\"\t\"\"\t\"LD a note\"\r\n"
     "\"22\"\t\"\"\t\"P1\"\t\"\"\t\"\"\t\"\"\t\"\"\r\n"
     "\"23\"\t\"\"\t\"END\"\t\"\"\t\"\"\t\"\"\t\"\"\r\n",
     "fx\nLD X10 | OUTT TS0 50 100000us\nLABEL 1"},
    {"UnquotedOfQ", "a.csv",
     "MAIN\t\t\t\t\t\t\nPLC Information:\tQCPU (Q mode) Q03UDV\t\t\t\t\t\n"
     "Step No.\tLine Statement\tInstruction\tI/O(Device)\tBlank\tPI Statement\tNote\n"
     "0\t\tLD\tX1F\t\t\t\n1\t\tMOV\tH10\t\t\t\n\t\t\tD0\t\t\t\n3\t\tEND\t\t\t\t\n",
     "q\nLD X1F | MOV 16 D0"},
    {"GxWorks3", "a.csv",
     "\"prog\"\n\"Module Type Information:\"\t\"RCPU R16N\"\n"
     "\"Step No.\"\t\"Line Statement\"\t\"Instruction\"\t\"I/O "
     "(Device)\"\t\"Blank\"\t\"PI\"\t\"N\"\n"
     "\"0 [Title] Demo\"\t\"\"\t\"\"\t\"\"\t\"\"\t\"\"\t\"\"\n"
     "\"0\"\t\"\"\t\"LD\"\t\"XA\"\n\"1\"\t\"\"\t\"OUT\"\t\"Y1F\"\n\"2\"\t\"\"\t\"END\"\t\"\"\n",
     "q\nLD XA | OUT Y1F"},
    {"GxDeveloper", "a.csv",
     "0,,LD,X27,,,,,\n1,,OUT,T5,,,,,\n,,K100,,,,,,\n4,,MOV,K1,,,,,\n,,D0,,,,,,\n9,,END,,,,,,\n",
     "fx\nLD X27 | OUTT TS5 100 100000us | MOV 1 D0"},
    {"GxDeveloperUnderAnotherName", "-", "0,,LD,X27,,,,,\n1,,OUT,Y1,,,,,\n2,,END,,,,,,\n",
     "fx\nLD X27 | OUT Y1"},
    {"TitleThatIsANumber", "a.csv",
     "\"100\"\n\"PLC\"\t\"FXCPU FX2N\"\n\"S\"\t\"L\"\t\"I\"\t\"D\"\n\"0\"\t\"\"\t\"END\"\t\"\"\n",
     "fx"},
    {"CellOverTwoLines", "a.csv",
     "\"A\"\n\"PLC\"\t\"LCPU L26\"\n\"S\"\t\"L\"\t\"I\"\t\"D\"\n"
     "\"0\"\t\"two\nlines\"\t\"\"\t\"\"\n\"9\"\t\"\"\t\"LD\"\t\"X1\"\n\"9\"\t\"\"\t\"OUT\"\t\"Y1\""
     "\n"
     "\"10\"\t\"\"\t\"END\"\t\"\"\n",
     "q\nLD X1 | OUT Y1"},
    {"ListCalledCsv", "a.csv", "LD X0\nOUT Y0\nEND\n", "fx\nLD X0 | OUT Y0"},
    {"ListWithTabsAndCommas", "a.il", "0\tLD\tX0\t; a, b, c, d\n1\tOUT\tY0\n2\tEND\n",
     "fx\nLD X0 | OUT Y0"},
};

std::string form_name(const testing::TestParamInfo<Form>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Csv, CsvForms, testing::ValuesIn(kForms), form_name);

#define HEAD "\"A\"\n\"PLC\"\t\"FXCPU FX2N\"\n\"S\"\t\"L\"\t\"I\"\t\"D\"\n"
class RefusedCsv : public testing::TestWithParam<Refused> {};
TEST_P(RefusedCsv, SaysWhereWhatAndHowToMend) { expect_refused(GetParam()); }
INSTANTIATE_TEST_SUITE_P(
    Csv, RefusedCsv,
    testing::Values(
        Refused{"OperandAtTheCell",
                HEAD "\"0\"\t\"\"\t\"LD\"\t\"X8\"\n\"1\"\t\"\"\t\"MOV\"\t\"K1\"\n"
                     "\"\"\t\"\"\t\"\"\t\"X1\"\n\"6\"\t\"\"\t\"FOO\"\t\"X1\"\n"
                     "\"7\"\t\"\"\t\"END\"\n",
                std::nullopt,
                "t:4:13: error: LD X8: not an input: its numbers are octal (digits 0 to 7) in "
                "dialect fx\n"
                "    after X7 comes X10; for a list with hexadecimal X and Y use --dialect q\n"
                "t:6:10: error: MOV X1: an input, and inputs cannot be written\n"
                "    this operand is a target: name a D\n"
                "t:7:8: error: FOO is not an instruction\n"
                "    did you mean FOR?\n"},
        Refused{"OperandFirst", HEAD "\"\"\t\"\"\t\"\"\t\"X8\"\n\"1\"\t\"\"\t\"END\"\n",
                std::nullopt,
                "t:4:10: error: X8: an operand, and no instruction before it that takes it\n"
                "    each instruction has a row, and its further operands the rows after it\n"},
        Refused{"AfterEnd", HEAD "\"0\"\t\"\"\t\"END\"\n\"1\"\t\"\"\t\"LD\"\t\"X0\"\n",
                std::nullopt,
                "t:5:8: error: LD stands after END, where nothing is executed\n"
                "    remove what follows END, or END itself\n"},
        Refused{"NoEnd", HEAD "\"0\"\t\"\"\t\"LD\"\t\"X0\"\n\"1\"\t\"\"\t\"OUT\"\t\"Y0\"\n",
                std::nullopt,
                "t:5:1: error: the program has no END\n"
                "    put END after its last instruction; if it was cut off, export it again\n"},
        Refused{"NoInstruction", HEAD, std::nullopt,
                "t:1:1: error: there is no instruction in this file\n"
                "    a program has rows of step, line statement, instruction and operand\n"},
        Refused{"UnknownController",
                "\"A\"\n\"PLC\"\t\"S7-1200\"\n\"S\"\t\"L\"\t\"I\"\t\"D\"\n\"0\"\t\"\"\t\"END\"\n",
                std::nullopt,
                "t:2:7: error: S7-1200: not a controller whose programs are known here\n"
                "    the families are FX, Q, L and R; to read it as one of them use --dialect fx "
                "or --dialect q\n"},
        Refused{"OpenQuote", HEAD "\"0\"\t\"\"\t\"END\n", std::nullopt,
                "t:4:8: error: this quote is never closed\n"
                "    the file was cut off: copy or export it again\n"},
        Refused{"DeviceComments", "\"A\"\n\"Device Name\"\t\"Comment\"\n\"X0\"\t\"start\"\n",
                std::nullopt,
                "t:1:1: error: this is a file of device comments, not a program\n"
                "    give it with --comments beside the program\n"}),
    refused_name);
#undef HEAD

TEST(Csv, AGivenDialectOverridesTheController) {
  const char* const text =
      "\"A\"\n\"PLC\"\t\"S7-1200\"\n\"S\"\t\"L\"\t\"I\"\t\"D\"\n\"0\"\t\"\"\t\"LD\"\t\"X1F\"\n"
      "\"1\"\t\"\"\t\"OUT\"\t\"Y0\"\n\"2\"\t\"\"\t\"END\"\n";
  const ParseResult result = parse(text, Dialect::Q);
  EXPECT_EQ(result.messages, "");
  ASSERT_TRUE(result.program);
  EXPECT_EQ(dump(*result.program), "q\nLD X1F | OUT Y0");
}

TEST(Csv, CellsHaveTheirPlaces) {
  Diagnostics diagnostics;
  const auto source = decode_text("a,\" b \"\"c\"\"\",\n\n,\"x\ny\" ,z\n", "t", diagnostics);
  ASSERT_TRUE(source);
  const auto rows = read_csv(*source, diagnostics);
  ASSERT_EQ(rows.size(), 2U);
  ASSERT_EQ(rows[0].cells.size(), 3U);
  EXPECT_EQ(rows[0].cells[1].text, "b \"c\"");
  EXPECT_EQ(rows[0].cells[1].raw, " b \"c\"");
  EXPECT_EQ(rows[0].cells[1].position, (SourcePosition{1, 3}));
  ASSERT_EQ(rows[1].cells.size(), 3U);
  EXPECT_EQ(rows[1].cells[1].text, "x\ny");
  EXPECT_EQ(rows[1].cells[1].position, (SourcePosition{3, 2}));
  EXPECT_EQ(rows[1].cells[2].text, "z");
  EXPECT_EQ(rows[1].cells[2].position, (SourcePosition{4, 5}));
  EXPECT_EQ(rows[1].text(7), "");
}

// The step numbers of real exports are those that we count.
TEST(Steps, AreThoseOfTheFile) {
  if (!fs::exists(kFolder)) GTEST_SKIP() << "skipped: no corpus";
  for (const char* const file : {"gxw2_ladder_converter__MAIN.csv", "melsecai__practice_17.csv"}) {
    Diagnostics diagnostics;
    const auto source = read_text((kFolder / file).string(), diagnostics);
    ASSERT_TRUE(source);
    const CsvProgram csv = read_csv_program(*source, std::nullopt, diagnostics);
    const auto program = parse_csv(*source, std::nullopt, diagnostics);
    ASSERT_TRUE(program) << printed(diagnostics);
    EXPECT_EQ(step_numbers(*program, &csv), csv.steps) << file;
  }
}

// Line statements take steps of their own: from one to the next.
TEST(Steps, OfLineStatements) {
  EXPECT_EQ(text_steps(" * Sample ladder name : 01CmnPgm"), 18);
  EXPECT_EQ(text_steps(" * Version : Ver.1.00A"), 13);
  EXPECT_EQ(text_steps(" * "), 4);
  EXPECT_EQ(text_steps(""), 2);
  EXPECT_EQ(text_steps("\u3042\uFF71"), 4);  // two bytes and one in Shift-JIS
}

TEST(Steps, OfInstructions) {
  struct Row {
    const char* text;
    int fx;
    int q;
  };
  const Row rows[] = {
      {"LD X0", 1, 1},   {"LD M1536", 2, 1},     {"LD M3584", 3, 1},     {"LDP X0", 2, 2},
      {"LD X0Z0", 3, 1}, {"LD D0.1", 3, 1},      {"LD= D0 K1", 5, 3},    {"LDD= D0 K1", 9, 3},
      {"OUT Y0", 1, 1},  {"OUT M1536", 2, 1},    {"OUT T0 K5", 3, 4},    {"RST T0", 2, 1},
      {"RST D0", 3, 2},  {"INC D0", 3, 2},       {"DMOV D0 D2", 9, 2},   {"MOV D0 D1", 5, 2},
      {"PLS M0", 2, 2},  {"CMP K1 D0 M0", 7, 4}, {"BMOV D0 D9 K3", 7, 4}};
  for (const Row& row : rows) {
    for (const Dialect dialect : {Dialect::Fx, Dialect::Q}) {
      const bool contact = std::string_view(row.text).starts_with("LD");
      const Program program = good_program(contact ? fmt::format("{}\nOUT Y0\nEND", row.text)
                                                   : fmt::format("LD X0\n{}\nEND", row.text),
                                           dialect);
      ASSERT_EQ(program.instructions.size(), 2U) << row.text;
      EXPECT_EQ(program_steps(program.instructions[contact ? 0 : 1], dialect),
                dialect == Dialect::Fx ? row.fx : row.q)
          << row.text;
    }
  }
}

}  // namespace
}  // namespace rung
