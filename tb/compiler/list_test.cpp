// SPDX-License-Identifier: Apache-2.0
// Plain lists that are accepted: what Program each form gives.
#include <gtest/gtest.h>

#include "melsec/paper.hpp"
#include "support.hpp"

namespace rung {
namespace {

struct Accepted {
  const char* name;
  const char* text;
  const char* dump;
};

class AcceptedList : public testing::TestWithParam<Accepted> {};

TEST_P(AcceptedList, GivesThisProgram) {
  const ParseResult result = parse(GetParam().text);
  EXPECT_EQ(result.messages, "");
  ASSERT_TRUE(result.program);
  EXPECT_EQ(dump(*result.program), GetParam().dump);
}

constexpr Accepted kForms[] = {
    {"Figure2OfThePaper", "LD\tX0\nOR\tM0\nANI\tX1\nOUT\tM0\nLD\tM0\nADD\tK1 D0\nEND\t\n",
     "paper\nLD X0 | OR M0 | ANI X1 | OUT M0\nLD M0 | ADD D0 1 D0 two"},
    {"StepNumbers", "0 LD X000\n1 OR X001\n2 OUT Y017\n3 END\n", "fx\nLD X0 | OR X1 | OUT Y17"},
    {"StepNumbersOnOneLine", "0 LD X0 1 OUT Y0 2 END", "fx\nLD X0 | OUT Y0"},
    {"StepNumberAfterThreeOperandForm", "LD X0 ADD K1 D0 7 LD X1 OUT Y0 END",
     "paper\nLD X0 | ADD D0 1 D0 two\nLD X1 | OUT Y0"},
    {"SeveralOnALine", "LD X0 OR M0 ANI X1 OUT M0 END", "fx\nLD X0 | OR M0 | ANI X1 | OUT M0"},
    {"Slashes", "LD X0 / OR M0 / OUT M0 /\n/ END", "fx\nLD X0 | OR M0 | OUT M0"},
    {"SlashesWithoutBlanks", "LD X0/OR M0/OUT M0/END", "fx\nLD X0 | OR M0 | OUT M0"},
    {"Division", "LD X0 / / K2 D0 / / D0 D1 D2\nEND",
     "q\nLD X0 | DIV D0 2 D0 wide two | DIV D0 D1 D2 wide"},
    {"Comments",
     "; one\n# two\n// three\n(* four\nLD X7 *) LD X0 ; five\n(* a *)OUT(* b *)Y0 // six\nEND # "
     "seven\n(* eight *)",
     "fx\nLD X0 | OUT Y0"},
    {"CommentsAfterEnd", "LD X0\nOUT Y0\nEND\n\n; that was all\n(* really *)\n",
     "fx\nLD X0 | OUT Y0"},
    {"LineEndsOfDos", "LD X0\r\nOUT Y0\r\nEND\r\n", "fx\nLD X0 | OUT Y0"},
    {"LineEndsOfOldMacs", "LD X0\rOUT Y0\rEND\r", "fx\nLD X0 | OUT Y0"},
    {"NoFinalNewline", "LD X0\nOUT Y0\nEND", "fx\nLD X0 | OUT Y0"},
    {"LowerCase", "ld x0\nmov k-5 d1\nmov h0fF d2\nend", "fx\nLD X0 | MOV -5 D1 | MOV 255 D2"},
    {"ByteOrderMark", "\xEF\xBB\xBFLD X0\nOUT Y0\nEND\n", "fx\nLD X0 | OUT Y0"},
    {"Padding", "LD X00000000000000000000007\nOUT M0010\nEND", "fx\nLD X7 | OUT M10"},
    {"FullWidthBlank", "LD\u3000X0\nOUT\u00A0Y0\nEND", "fx\nLD X0 | OUT Y0"},
    {"OnlyEnd", "END\n", "fx"},
    {"OnlyNops", "NOP\nNOP\nEND\n", "fx\nNOP | NOP"},
};

constexpr Accepted kDialects[] = {
    {"PlainIsFx", "LD X10\nADD D0 K1 D1\nMUL D0 D1 D2\nEND",
     "fx\nLD X10 | ADD D0 1 D1 | MUL D0 D1 D2 wide"},
    {"MvIsPaper", "LD X10\nMV K1 D0\nMUL D0 D1 D2\nDIV D0 D1 D2\nEND",
     "paper\nLD X10 | MOV 1 D0 | MUL D0 D1 D2 | DIV D0 D1 D2"},
    {"TwoOperandsArePaper", "LD X0\nSUB K1 D0\nMOV D0 D1\nEND",
     "paper\nLD X0 | SUB D0 1 D0 two | MOV D0 D1"},
    {"OperatorsAreQ", "LD X1F\n+ K1 D0\n- D0 K1 D1\n* D0 D1 D2\nEND",
     "q\nLD X1F | ADD D0 1 D0 two | SUB D0 1 D1 | MUL D0 D1 D2 wide"},
    {"LastDevicesOfFx", "LD X377\nOUT Y377\nOUT M7679\nMOV K0 D7999\nMUL D0 D0 D7998\nEND",
     "fx\nLD X377 | OUT Y377 | OUT M7679 | MOV 0 D7999 | MUL D0 D0 D7998 wide"},
    {"LastDevicesOfQ", "LD X1FFF\nOUT Y1FFF\nOUT M8191\n+ K0 D12287\n* D0 D0 D12286\nEND",
     "q\nLD X1FFF | OUT Y1FFF | OUT M8191 | ADD D12287 0 D12287 two | MUL D0 D0 D12286 wide"},
    {"HexadecimalWithLeadingLetter", "LD XA\n+ K0 D0\nEND", "q\nLD XA | ADD D0 0 D0 two"},
    {"Constants",
     "LD X0\nMOV K-32768 D0\nMOV K32767 D1\nMOV HFFFF D2\nMOV H8000 D3\nMOV H00001 "
     "D4\nEND",
     "fx\nLD X0 | MOV -32768 D0 | MOV 32767 D1 | MOV -1 D2 | MOV -32768 D3 | MOV 1 "
     "D4"},
    {"ResetOfAWord", "LD X0\nRST D5\nRST M5\nRST Y5\nEND", "fx\nLD X0 | RST D5 | RST M5 | RST Y5"},
};

constexpr Accepted kInstructions[] = {
    {"Contacts",
     "LDP X0\nANDF Y1\nORP M8013\nAND T5\nORI C200\nANI S3\nINV\nMEP\nMEF\nOUT M8200\nEND",
     "fx\nLDP X0 | ANDF Y1 | ORP M8013 | AND TS5 | ORI CS200 | ANI S3 | INV | MEP | MEF | OUT "
     "M8200"},
    {"Compares",
     "LD= D0 K5\nAND<> T0 C5\nOR<= K4X0 H0F\nLDD>= D0 C200\nANB\nORD< K-70000 K8M0\nANDD> D2 "
     "D4\nOUT Y0\nEND",
     "fx\nLD= D0 5 | AND<> TN0 CN5 | OR<= 4xX0 15 | DLD>= D0 CN200 | ANB | DOR< -70000 8xM0 | "
     "DAND> "
     "D2 D4 | OUT Y0"},
    {"TimersAndCounters",
     "LD X0\nOUT T0 K50\nOUT T200 D5\nOUT T249 K1\nOUT T250 K1\nOUT T256 K0\nOUT C0 K5\nOUT C234 "
     "K-70000\nRST T0\nRST C200\nRST D5\nEND",
     "fx\nLD X0 | OUTT TS0 50 100000us | OUTT TS200 D5 10000us | OUTT TS249 1 1000us | OUTT TS250 "
     "1 "
     "100000us | OUTT TS256 0 1000us | OUTC CS0 5 | DOUTC CS234 -70000 | RST TS0 | RST CS200 | RST "
     "D5"},
    {"TimersOfQ",
     "LD SM400\n+ K1 D0\nOUT T2047 K5\nOUTH T1 K5\nOUT ST2 D1\nOUTH ST3 K5\nOUT C1023 K5\nRST "
     "ST2\nEND",
     "q\nLD SM400 | ADD D0 1 D0 two | OUTT TS2047 5 100000us | OUTT TS1 5 10000us | OUTT STS2 D1 "
     "100000us | OUTT STS3 5 10000us | OUTC CS1023 5 | RST STS2"},
    {"Bits",
     "LD X0\nPLS M0\nPLF Y1\nALT M2\nALTP M3\nFF M4\nOUTI Y5\nSET D0.F\nSFTLP X0 M0 K16 "
     "K4\nSFTR M20 M0 K8 K8\nEND",
     "fx\nLD X0 | PLS M0 | PLF Y1 | ALT M2 | ALTP M3 | ALTP M4 | OUTI Y5 | SET D0.15 | SFTLP X0 M0 "
     "16 4 | SFTR M20 M0 8 8"},
    {"ShiftsOfQ", "LD X0\n- K1 D0\nSFT M5\nBSFLP M0 K9\nBSFR B1F K2\nDSFL D0 K5\nDSFRP W1A K2\nEND",
     "q\nLD X0 | SUB D0 1 D0 two | SFT M5 | BSFLP M0 9 | BSFR B1F 2 | DSFL D0 5 | DSFRP W1A 2"},
    {"Words",
     "LD X0\nDMOVP K70000 D0\nCML K2X0 D1\nBCD D0 K4Y0\nBINP K4X0 V\nXCH D0 D1\nDSWAP D0\nBMOV "
     "K1X0 D0 K4\nDFMOV K-1 D0 K512\nINCP D0\nDDEC D0\nNEG Z3\nEND",
     "fx\nLD X0 | DMOVP 70000 D0 | CML 2xX0 D1 | BCD D0 4xY0 | BINP 4xX0 V0 | XCH D0 D1 | DSWAP D0 "
     "| "
     "BMOV 1xX0 D0 4 | DFMOV -1 D0 512 | INCP D0 | DDEC D0 | NEG Z3"},
    {"Arithmetic",
     "LD X0\nDADDP D0 K1 D2\nDMUL D0 D2 D4\nDDIVP D0 D2 D4\nWAND D0 H0FF D1\nDOR D0 D2 D4\nWXORP "
     "D0 D1 K1M0\nEND",
     "fx\nLD X0 | DADDP D0 1 D2 | DMUL D0 D2 D4 wide | DDIVP D0 D2 D4 wide | WAND D0 255 D1 | DWOR "
     "D0 D2 D4 | WXORP D0 D1 1xM0"},
    {"ArithmeticOfQ",
     "LD X0\nD+ K70000 D0\nD-P D0 D2 D4\n* K2 D0\nD/ D0 D2 D4\nWAND D0 D1\nDXNRP D0 D2\nWXNR D0 "
     "D1 D2\nEND",
     "q\nLD X0 | DADD D0 70000 D0 two | DSUBP D0 D2 D4 | MUL D0 2 D0 wide two | DDIV D0 D2 D4 wide "
     "| "
     "WAND D1 D0 D1 two | DWXNRP D2 D0 D2 two | WXNR D0 D1 D2"},
    {"RotatesAndRanges",
     "LD X0\nROL D0 K16\nDRORP D0 K0\nRCL D0 K1\nRCRP K4M0 K2\nSFL D0 K15\nSFRP D0 K0\nWSFL D0 D10 "
     "K5 K5\nCMP K1 D0 M0\nDZCPP K1 K9 C200 Y0\nZRST T0 T9\nZRSTP S0 S9\nEND",
     "fx\nLD X0 | ROL D0 16 | DRORP D0 0 | RCL D0 1 | RCRP 4xM0 2 | SFL D0 15 | SFRP D0 0 | WSFL "
     "D0 "
     "D10 5 5 | CMP 1 D0 M0 | DZCPP 1 9 CN200 Y0 | ZRST TS0 TS9 | ZRSTP S0 S9"},
    {"Indexes", "LD X0Z0\nANI M10V7\nOUT Y0Z1\nRST D5Z2\nMOV D20V D30Z3\nDADD D0Z0 R5Z1 D2V1\nEND",
     "fx\nLD X0[Z0] | ANI M10[V7] | OUT Y0[Z1] | RST D5[Z2] | MOV D20[V0] D30[Z3] | DADD D0[Z0] "
     "R5[Z1] D2[V1]"},
    {"BitsOfWordsOfQ", "LD D0.A\nANI W1F.0\nLDP SW1.F\nORB\nMOV K1F0 D0\n+ K1 D0\nEND",
     "q\nLD D0.10 | ANI W1F.0 | LDP SW1.15 | ORB | MOV 1xF0 D0 | ADD D0 1 D0 two"},
};

constexpr Accepted kFlow[] = {
    {"Labels", "0 P0\n1 LD X0\n2 CJ P1\n5 LD X1 OUT Y1 P1\nLD X2 CJ P63 LD X3 OUT Y3 END",
     "fx\nLABEL 0\nLD X0 | CJ 1 ->5\nLD X1 | OUT Y1\nLABEL 1\nLD X2 | CJ 63 ->10\nLD X3 | OUT Y3"},
    {"Subroutines",
     "LD X0\nCALLP P2\nFEND\nP2\nLD X1\nCALL P3\nSRET\nP3\nLD X2\nOUT Y2\nSRET\nLD X3\nOUT "
     "Y3\nEND",
     "fx\nLD X0 | CALLP 2 ->3\nFEND\nLABEL 2\nLD X1 | CALL 3 ->7\nSRET\nLABEL 3\nLD X2 | OUT "
     "Y2\nSRET\nLD X3 | OUT Y3"},
    {"RetOfQEndsASubroutine", "LD X0\n+ K1 D0\nCALL P0\nFEND\nP0\nLD X1\nOUT Y1\nRET\nEND",
     "q\nLD X0 | ADD D0 1 D0 two | CALL 0 ->4\nFEND\nLABEL 0\nLD X1 | OUT Y1\nSRET"},
    {"Loops", "NOP\nFOR K3\nFOR K2\nLD X0\nINC D0\nNEXT\nNOP\nNEXT\nEND",
     "fx\nNOP\nFOR 3 ->7\nFOR 2 ->5\nLD X0 | INC D0\nNEXT ->2\nNOP\nNEXT ->1"},
    {"Zones",
     "LD X0\nMC N0 M0\nLD X1\nOUT Y1\nLD X2\nMC N1 M1\nLD X3\nOUT Y3\nMCR N1\nLD X4\nMC N1 M2\nLD "
     "X5\nOUT Y5\nMCR N0\nEND",
     "fx\nLD X0 | MC 0 M0\nLD X1 | OUT Y1\nLD X2 | MC 1 M1\nLD X3 | OUT Y3\nMCR 1\nLD X4 | MC 1 "
     "M2\nLD X5 | OUT Y5\nMCR 0"},
    {"States",
     "LD M8002\nSET S0\nSTL S0\nOUT Y0\nOUT Y1\nLD X0\nSET S20\nSTL S20\nSTL S21\nLD X1\nOUT "
     "S0\nRET\nLD X2\nOUT Y2\nEND",
     "fx\nLD M8002 | SET S0\nSTL S0 | OUT Y0 | OUT Y1\nLD X0 | SET S20\nSTL S20\nSTL S21\nLD X1 | "
     "OUT "
     "S0\nRET\nLD X2 | OUT Y2"},
};

constexpr Accepted kNetworks[] = {
    {"LeadingNopsBelongToTheNext", "NOP\nLD X0\nOUT Y0\nNOP\nNOP\nLD X1\nOUT Y1\nNOP\nEND",
     "fx\nNOP | LD X0 | OUT Y0\nNOP | NOP | LD X1 | OUT Y1 | NOP"},
    {"ContinuesAfterAnOutput", "LD X0\nOUT Y0\nAND X1\nOUT Y1\nLD X2\nOUT Y2\nEND",
     "fx\nLD X0 | OUT Y0 | AND X1 | OUT Y1\nLD X2 | OUT Y2"},
    {"NopInAContinuation", "LD X0\nOUT Y0\nNOP\nAND X1\nOUT Y1\nEND",
     "fx\nLD X0 | OUT Y0 | NOP | AND X1 | OUT Y1"},
    {"BlockBehindABranch",
     "LD X0\nMPS\nAND X1\nOUT Y0\nMRD\nLD X2\nOR X3\nANB\nOUT Y1\nMPP\nOUT Y2\nLD X4\nOUT Y3\nEND",
     "fx\nLD X0 | MPS | AND X1 | OUT Y0 | MRD | LD X2 | OR X3 | ANB | OUT Y1 | MPP | OUT Y2\n"
     "LD X4 | OUT Y3"},
    {"BlockAfterAnOutputWithinABranch",
     "LD X0\nMPS\nOUT Y0\nLD X1\nLDI X2\nORB\nANB\nOUT Y1\nMPP\nOUT Y2\nEND",
     "fx\nLD X0 | MPS | OUT Y0 | LD X1 | LDI X2 | ORB | ANB | OUT Y1 | MPP | OUT Y2"},
    {"BlocksJoinedAtTheEnd", "LD X0\nLD X1\nLD X2\nANB\nORB\nOUT Y0\nEND",
     "fx\nLD X0 | LD X1 | LD X2 | ANB | ORB | OUT Y0"},
    {"EightBlocks",
     "LD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nANB\nANB\nANB\nANB\nANB\nANB\nANB\n"
     "OUT Y0\nEND",
     "fx\nLD X0 | LD X0 | LD X0 | LD X0 | LD X0 | LD X0 | LD X0 | LD X0 | ANB | ANB | ANB | ANB | "
     "ANB | ANB | ANB | OUT Y0"},
};

std::string parameter_name(const testing::TestParamInfo<Accepted>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Forms, AcceptedList, testing::ValuesIn(kForms), parameter_name);
INSTANTIATE_TEST_SUITE_P(Dialects, AcceptedList, testing::ValuesIn(kDialects), parameter_name);
INSTANTIATE_TEST_SUITE_P(Instructions, AcceptedList, testing::ValuesIn(kInstructions),
                         parameter_name);
INSTANTIATE_TEST_SUITE_P(Flow, AcceptedList, testing::ValuesIn(kFlow), parameter_name);
INSTANTIATE_TEST_SUITE_P(Networks, AcceptedList, testing::ValuesIn(kNetworks), parameter_name);

TEST(List, LadderDriveNeedsNoEnd) {
  for (const char* file : {"a.esc", "A.ESC"}) {
    const ParseResult result = parse("NOP\nLD X0\nOUT Y0\n", std::nullopt, file);
    EXPECT_EQ(result.messages, "");
    ASSERT_TRUE(result.program);
    EXPECT_EQ(dump(*result.program), "fx\nNOP | LD X0 | OUT Y0");
  }
}

TEST(List, GivenDialectDecides) {
  const ParseResult result = parse("LD X10\nOUT Y0\nEND", Dialect::Q);
  ASSERT_TRUE(result.program);
  EXPECT_EQ(dump(*result.program), "q\nLD X10 | OUT Y0");
  EXPECT_EQ(result.program->instructions[0].operand(0).device.number, 0x10U);
}

TEST(List, Utf16) {
  std::string bytes = "\xFF\xFE";
  for (const char c : std::string("LD X0\r\nOUT Y0 ; ")) bytes += {c, '\0'};
  bytes += "\x42\x30";                          // a letter of the basic plane
  bytes += std::string("\x3D\xD8\x00\xDE", 4);  // a surrogate pair
  for (const char c : std::string("\r\nEND")) bytes += {c, '\0'};
  const ParseResult result = parse(bytes);
  EXPECT_EQ(result.messages, "");
  ASSERT_TRUE(result.program);
  EXPECT_EQ(dump(*result.program), "fx\nLD X0 | OUT Y0");
}

TEST(List, PositionsAndTextAreThoseOfTheSource) {
  const Program program = good_program("\xE3\x81\x82/ ; \xE3\x81\x82\nEND", Dialect::Fx);
  EXPECT_TRUE(program.instructions.empty());
  const Program kept = good_program("(*\xE3\x81\x82*)  ld   x000  mov  k1\td0\nend");
  ASSERT_EQ(kept.instructions.size(), 2U);
  EXPECT_EQ(kept.instructions[0].position, (SourcePosition{1, 8}));
  EXPECT_EQ(kept.instructions[0].text, "ld x000");
  EXPECT_EQ(kept.instructions[1].position, (SourcePosition{1, 19}));
  EXPECT_EQ(kept.instructions[1].text, "mov k1 d0");
}

TEST(List, CountsOfInterfaces) {
  // Runs: LD AND OR = 3; LD = 1, cut by the next LD; LD ANI = 2; after ANB: AND = 1; after OUT: 1.
  const Program program = good_program(
      "LD X0\nAND X1\nOR X2\nOUT Y0\nNOP\nLD X3\nLD X4\nANI X5\nANB\nAND X6\nOUT Y1\nAND X7\n"
      "SET M0\nEND");
  const ProgramCounts counts = count(program);
  EXPECT_EQ(counts.networks, 2);
  EXPECT_EQ(counts.instructions, 13);
  EXPECT_EQ(counts.contacts, 8);
  EXPECT_EQ(counts.run_lengths, (std::vector<int>{3, 1, 2, 1, 1}));
}

TEST(List, NamedDevices) {
  const Program program = good_program(
      "LD X3\nOUT Y1\nOUT M2\nMUL D5 K3 D0\nMOV D9 D8\nRST D20\nRST M1\nMOV K1 D7\nEND");
  std::string names;
  for (const Device device : named_devices(program)) {
    names += device_name(device, program.dialect) + " ";
  }
  EXPECT_EQ(names, "X3 Y1 M1 M2 D0 D1 D5 D7 D8 D9 D20 ");
}

TEST(List, PaperRefusesWhatTable4Lacks) {
  const auto messages = [](const Program& program) {
    Diagnostics diagnostics;
    const bool good = check_paper(program, diagnostics);
    EXPECT_EQ(good, !diagnostics.has_errors());
    return printed(diagnostics);
  };
  EXPECT_EQ(messages(good_program("NOP\nLD X0\nLDI X1\nORB\nMV K1 D0\nOUT Y0\nEND")),
            "t:4:1: error: ORB: not among the paper's instructions (its Table 4)\n"
            "    compile without --paper, or write it with LD, AND, OR and OUT\n");
  EXPECT_EQ(messages(good_program("LD X0\nAND X1\nANI X1\nOR X1\nORI X1\nOUT Y0\nADD K1 D0\n"
                                  "SUB D0 K1 D2\nMUL K1 D0\nDIV K1 D0\nMV D0 D1\nEND")),
            "");
  const char* const refused[] = {"SET M0", "RST M0", "RST D0"};
  for (const char* const each : refused) {
    const std::string text = fmt::format("LD X0\n  {}\nMV K1 D0\nEND", each);
    EXPECT_EQ(messages(good_program(text)).substr(0, 15), "t:2:3: error: " + std::string(each, 1));
  }
  const std::string branches = messages(good_program(
      "LD X0\nLD X1\nANB\nMPS\nOUT Y0\nMRD\nOUT Y1\nMPP\nOUT Y2\nEND", Dialect::Paper));
  for (const char* const each :
       {"t:3:1: error: ANB", "t:4:1: error: MPS", "t:6:1: error: MRD", "t:8:1: error: MPP"}) {
    EXPECT_NE(branches.find(each), std::string::npos) << branches;
  }
  EXPECT_EQ(messages(good_program("LD X0\nMUL K1 D0 D1\nEND", Dialect::Fx)),
            "t:2:1: error: MUL: writes two words, the paper's writes one\n"
            "    use --dialect paper\n");
}

}  // namespace
}  // namespace rung
