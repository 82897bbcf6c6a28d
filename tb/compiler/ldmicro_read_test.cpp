// SPDX-License-Identifier: Apache-2.0
// LDmicro files that are read: what becomes of each line.
#include <gtest/gtest.h>

#include "ldmicro_support.hpp"
#include "rungs/names.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

struct Element {
  const char* name;
  const char* lines;
  const char* dump;  // of the rung without RUNG
  const char* header = "LDmicro0.1";
};

class LdmicroElements : public testing::TestWithParam<Element> {};

TEST_P(LdmicroElements, BecomeInstructions) {
  const ParseResult result = parse_ld(ld_file(GetParam().lines, GetParam().header));
  ASSERT_TRUE(result.program) << result.messages;
  EXPECT_EQ(result.messages.find("is read as"), std::string::npos) << result.messages;
  EXPECT_EQ(dump_ld(*result.program), std::string("RUNG | ") + GetParam().dump);
}

constexpr Element kElements[] = {
    {"Contacts", "CONTACTS Xa 0\nCONTACTS Xb 1\nCONTACTS Yq 0\nCONTACTS Rr 1\nCONTACTS Xa 1",
     "AND X0 | ANI X1 | AND Y0 | ANI M0 | ANI X0"},
    {"NamesOfOtherLetters", "CONTACTS x 0\nCONTACTS _1 0\nCONTACTS T 0",
     "AND M0 | AND M1 | AND M2"},
    {"Coils", "COIL Y1 0 0 0\nCOIL Y1 1 0 0\nCOIL Y1 0 1 0\nCOIL R1 0 0 1",
     "OUT Y0 | OUTI Y0 | SET Y0 | RST M0"},
    {"CoilsOfSeveralMarks", "COIL Y1 1 1 1\nCOIL Y1 0 1 1\nCOIL Y1 1 0 1",
     "OUTI Y0 | SET Y0 | OUTI Y0"},
    {"Plain", "SHORT\nOPEN\nOSR\nOSF\nMASTER_RELAY", "SHORT | OPEN | OSR | OSF | MASTER"},
    {"Timers", "TON T 50000\nTOF U 29999\nRTO V 20000",
     "TON D0 4 50000us | TOF D1 1 29999us | RTO D2 1 20000us"},
    {"LongestTimer", "TON T 327689999", "TON D0 32767 327689999us"},
    {"TimersOfAnotherCycle", "TON T 50000", "TON D0 49 50000us", "LDmicro0.1\nCYCLE=1000"},
    {"Counters", "CTU C 5\nCTD C -32768\nCTC D 32767\nRES C",
     "CTU D0 5 | CTD D0 -32768 | CTC D1 32767 | RES D0"},
    {"Move", "MOVE d s\nMOVE d -5\nMOVE d 'x'\nMOVE d '''",
     "MOV D1 D0 | MOV -5 D0 | MOV 120 D0 | MOV 39 D0"},
    {"Arithmetic", "ADD d a b\nSUB d 1 a\nMUL d d d\nDIV d a -3",
     "ADD D1 D2 D0 | SUB 1 D1 D0 | MUL D0 D0 D0 | DIV D1 -3 D0"},
    {"Compares", "EQU a 1\nNEQ a b\nGRT 1 a\nGEQ a a\nLES 1 2\nLEQ a -1",
     "AND= D0 1 | AND<> D0 D1 | AND> 1 D0 | AND>= D0 D0 | AND< 1 2 | AND<= D0 -1"},
    {"ShiftRegister", "SHIFT_REGISTER s 3\nMOVE s1 s\nSHIFT_REGISTER q 1",
     "SHIFT D0 D1 D2 | MOV D3 D1 | SHIFT D4"},
    {"LookUpTable",
     "LOOK_UP_TABLE d i 3 0 -1 32767 5\nLOOK_UP_TABLE d d 1 1 65\nLOOK_UP_TABLE d i 0 0",
     "LOOKUP D0 D1 0 [-1 32767 5] | LOOKUP D0 D0 1 [65] | LOOKUP D0 D1 0"},
    {"PiecewiseLinear", "PIECEWISE_LINEAR d i 2 -10 7 10 -6\nPIECEWISE_LINEAR d i 1 5 5",
     "LINEAR D0 D1 [-10 7 10 -6] | LINEAR D0 D1 [5 5]"},
    {"LargestSlopes", "PIECEWISE_LINEAR d i 3 0 0 1 32766 2 0", "LINEAR D0 D1 [0 0 1 32766 2 0]"},
    {"Peripherals",
     "READ_ADC Aa\nREAD_ADC Ab\nREAD_ADC Aa\nSET_PWM p 100000\nUART_SEND c\nUART_RECV c",
     "ADC D0 0 | ADC D1 1 | ADC D0 0 | PWM D2 100000 | SEND D3 | RECV D3"},
    {"Persist", "PERSIST a\nPERSIST b\nPERSIST a", "KEEP D0 0 | KEEP D1 1 | KEEP D0 2"},
    {"Strings",
     "FORMATTED_STRING (none) 2 72 105\nFORMATTED_STRING v 3 92 45 53\nFORMATTED_STRING (none) 0",
     "STRING [72 105] | STRING D0 [92 45 53] | STRING"},
    {"Comments", "COMMENT a  b\\r\\nc\\\\d\\qe \nCOMMENT\nCOMMENT ",
     "COMMENT \"a  b\nc\\dqe \" | COMMENT | COMMENT"},
    {"Parallel",
     "PARALLEL\nOSR\nSERIES\nOPEN\nSHORT\nEND\nSERIES\nEND\nSERIES\nPARALLEL\nOSF\nEND\nEND\nEND\nO"
     "SR",
     "PARALLEL | OSR | BRANCH | OPEN | SHORT | BRANCH | BRANCH | PARALLEL | OSF | JOIN | JOIN | "
     "OSR"},
    {"SeriesInSeries", "SERIES\nOSR\nSERIES\nOSF\nEND\nEND\nOPEN", "OSR | OSF | OPEN"},
    {"BitAndVariable", "CONTACTS Xa 0\nMOVE Xa 1\nCOIL v 0 0 0\nEQU v 1",
     "AND X0 | MOV 1 D0 | OUT M0 | AND= D1 1"},
    // 0.2, and what LDmicro 5 adds to lines of either format without another meaning.
    {"NeutralTails",
     "CONTACTS Xa 0 0\nCOIL R 0 0 0 0\nTON T 50000 0\nTOF U 50000 -1\nCTU C 3 0 /\nCTC D 3 0\n"
     "READ_ADC A 0\nSET_PWM p 1000 Pout 0-100%\nSET_PWM p 1000 Pout\nUART_SEND c 1 0\nUART_RECV c "
     "1\n"
     "LOOK_UP_TABLE d i 1 0 5 name\nPIECEWISE_LINEAR d i 1 0 5 name",
     "AND X0 | OUT M0 | TON D0 4 50000us | TOF D1 4 50000us | CTU D2 3 | CTC D3 3 | ADC D4 0 | "
     "PWM D5 1000 | PWM D5 1000 | SEND D6 | RECV D6 | LOOKUP D7 D8 0 [5] | LINEAR D7 D8 [0 5]"},
    {"StringAsText",
     "FORMATTED_STRING v a\\x20b\\3\\\\\nFORMATTED_STRING (none) 2 72 105\nFORMATTED_STRING (none)",
     "STRING D0 [97 92 120 50 48 98 92 51 92 92] | STRING [72 105] | STRING", "LDmicro0.2"},
};

INSTANTIATE_TEST_SUITE_P(All, LdmicroElements, testing::ValuesIn(kElements),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(LdmicroFile, EveryElement) {
  const ParseResult result = parse_ld(kEveryElement);
  ASSERT_TRUE(result.program) << result.messages;
  const Program& program = *result.program;
  EXPECT_EQ(program.dialect, Dialect::Ldmicro);
  EXPECT_EQ(program.file, "t.ld");
  EXPECT_EQ(program.networks.size(), 6U);
  EXPECT_EQ(count(program).instructions, 39);
  EXPECT_EQ(count(program).contacts, 8);
  EXPECT_EQ(program.instructions[1].note, "One of each.\nBack\\slash.");
  ASSERT_TRUE(program.ldmicro);
  EXPECT_EQ(program.ldmicro->micro, "Atmel AVR ATmega128 64-TQFP");
  EXPECT_EQ(program.ldmicro->cycle_us, 10000);
  EXPECT_EQ(program.ldmicro->crystal_hz, 4000000);
  EXPECT_EQ(program.ldmicro->baud, 2400);
  EXPECT_EQ(program.ldmicro->compiled, "C:\\out\\every.hex");
  EXPECT_EQ(program.ldmicro->cycle_position, (SourcePosition{3, 1}));
  EXPECT_EQ(program.ldmicro->baud_position, (SourcePosition{5, 1}));
  const std::vector<LdmicroSettings::Pin> pins = {{"Xstart", 2}, {"Ylamp", 3}, {"Alevel", 61}};
  EXPECT_EQ(program.ldmicro->pins, pins);
}

TEST(LdmicroFile, PlacesAndTexts) {
  const Program program = good_ld("LDmicro0.1\nPROGRAM\nRUNG\n\tTON\t T   50000 \nEND\n");
  ASSERT_EQ(program.instructions.size(), 2U);
  EXPECT_EQ(program.instructions[0].position, (SourcePosition{3, 1}));
  EXPECT_EQ(program.instructions[1].position, (SourcePosition{4, 2}));
  EXPECT_EQ(program.instructions[1].text, "TON T 50000");
}

// A name that is a bit and a variable has two names in traces; a channel has its variable's.
TEST(LdmicroFile, Names) {
  const Program program = good_ld(
      ld_file("CONTACTS Xa 0\nCOIL both 0 0 0\nMOVE both v\nREAD_ADC Alevel\nREAD_ADC both"));
  EXPECT_EQ(device_name({DeviceKind::X, 0}, program), "Xa");
  EXPECT_EQ(device_name({DeviceKind::M, 0}, program), "both");
  EXPECT_EQ(device_name({DeviceKind::D, 0}, program), "both:w");
  EXPECT_EQ(device_name({DeviceKind::D, 1}, program), "v");
  EXPECT_EQ(device_name(port::at(port::adc, 0), program), "Alevel");
  EXPECT_EQ(device_name(port::at(port::adc, 1), program), "both:w");
  EXPECT_EQ(program.names.size(), 7U);
  EXPECT_EQ(DeviceNames(program).device("Alevel"), (Device{DeviceKind::D, 2}));
  EXPECT_EQ(DeviceNames(program).channel("Alevel"), port::at(port::adc, 0));
}

// What LDmicro 2.3 refuses for blanks alone, and what LDmicro 5 writes around rungs.
TEST(LdmicroFile, BlanksCommentsAndNumbers) {
  const Program plain = good_ld(kEveryElement);
  std::string airy;
  std::size_t rung = 0;
  for (const char c : kEveryElement) {
    if (c == '\n' && airy.ends_with("\nRUNG")) airy += fmt::format(" {}", ++rung);
    if (c == '\n' && airy.find("Back") == std::string::npos) airy += " \t";
    airy += c == '\n' ? "\r\n \r\n; said aside\r\n" : std::string(1, c);
  }
  EXPECT_EQ(dump_ld(good_ld(airy)).substr(0, 30), dump_ld(plain).substr(0, 30));
  const Program read = good_ld(airy);
  expect_same(read, plain);
  EXPECT_EQ(rung, 6U);
}

TEST(LdmicroFile, Header02) {
  const ParseResult result = parse_ld(
      "LDmicro\n"
      "MICRO=Arduino\n"
      "CYCLE=20000 us at Timer1, YPlcCycleDuty:0, ConfigurationWord(s):0x0\n"
      "CRYSTAL=16000000 Hz\n"
      "BAUD=9600 Hz, RATE=9615 Hz, SPEED=960 Hz\n"
      "COMPILER=GNU\n"
      "\n"
      "PULL-UP LIST\n"
      "  PA: 0x0\n"
      "END\n"
      "VAR LIST\n"
      "  2 bytes count\n"
      "  1 bytes other [Now not used !!!]\n"
      "  level signed 16 bit variable\n"
      "END\n"
      "IO LIST\n"
      "  Xa at 5 0 0\n"
      "  Pout at 0\n"
      "END\n"
      "PROGRAM\n"
      "RUNG 1\n"
      "  CONTACTS Xa 0 0\n"
      "  MOVE count level\n"
      "  MOVE level 5\n"
      "END\n");
  ASSERT_TRUE(result.program) << result.messages;
  EXPECT_EQ(result.messages, "");
  EXPECT_EQ(result.program->ldmicro->cycle_us, 20000);
  EXPECT_EQ(result.program->ldmicro->baud, 9600);
  const std::vector<LdmicroSettings::Pin> pins = {{"Xa", 5}, {"Pout", 0}};
  EXPECT_EQ(result.program->ldmicro->pins, pins);
}

struct Warned {
  const char* name;
  std::string text;
  const char* messages;
};

class LdmicroWarnings : public testing::TestWithParam<Warned> {};

TEST_P(LdmicroWarnings, SayWhatIsOdd) {
  const ParseResult result = parse_ld(GetParam().text);
  EXPECT_TRUE(result.program);
  EXPECT_EQ(result.messages, GetParam().messages);
}

const Warned kWarned[] = {
    {"Hexadecimal", ld_file("MOVE v 0xffff\nEQU v 0x10"),
     "t.ld:4:8: warning: 0xffff is read as 0, as LDmicro 2.3 does\n"
     "    if its 16 bits are meant, write -1\n"
     "t.ld:5:7: warning: 0x10 is read as 0, as LDmicro 2.3 does\n"
     "    if its 16 bits are meant, write 16\n"},
    {"Blank", ld_file("MOVE v ' '"),
     "t.ld:4:8: warning: ' is read as 0, as LDmicro 2.3 does with ' '\n"
     "    write 32 for a blank\n"},
    {"Prefix", ld_file("MOVE v 12ab\nMOVE v -\nMOVE v 'ab'\nMOVE v 'c"),
     "t.ld:4:8: warning: 12ab is read as 12, as LDmicro 2.3 does\n"
     "t.ld:5:8: warning: - is read as 0, as LDmicro 2.3 does\n"
     "t.ld:6:8: warning: 'ab' is read as 'a'\n"
     "t.ld:7:8: warning: 'c is read as 'c'\n"},
    {"CodeBelowABlank", ld_file("FORMATTED_STRING (none) 2 10 -61"),
     "t.ld:4:27: warning: the code 10 is read as an X, as LDmicro 2.3 does\n"
     "    use an escape: 92 120 and the codes of two hexadecimal digits\n"
     "t.ld:4:30: warning: the code -61 is read as an X, as LDmicro 2.3 does\n"
     "    use an escape: 92 120 and the codes of two hexadecimal digits\n"},
    {"NeverAssigned", ld_file("CONTACTS Xa 0\nCONTACTS Rb 0\nCONTACTS Rb 1\nADD d a b\nEQU a d"),
     "t.ld:5:1: warning: CONTACTS Rb 0: nothing in the program gives Rb a value, so that it is "
     "always 0\n    give it a coil, or another name if it is an input (X)\n"
     "t.ld:7:1: warning: ADD d a b: nothing in the program gives a a value, so that it is always "
     "0\n    assign to it, with MOVE for instance\n"
     "t.ld:7:1: warning: ADD d a b: nothing in the program gives b a value, so that it is always "
     "0\n    assign to it, with MOVE for instance\n"},
    {"TimerTwice", ld_file("TON T 50000\nTOF T 50000\nCTU C 1\nCTD C 1"),
     "t.ld:5:1: warning: TOF T 50000: T counts in line 4 already, and the two disturb each other\n"
     "    give each timer a variable of its own\n"},
    {"RtoWithoutReset", ld_file("RTO T 50000\nRTO U 50000\nRES U"),
     "t.ld:4:1: warning: RTO T 50000: nothing resets T, so that it stays on once it is\n"
     "    put RES T where it is to begin again\n"},
    {"CommentBesideOthers", ld_file("OSR\nCOMMENT a"),
     "t.ld:5:1: warning: COMMENT beside other elements: here it does nothing, but LDmicro 2.3 "
     "stops compiling with an internal error\n    give it a rung of its own\n"},
    {"Header",
     "LDmicro0.7\nFROB=1\nCYCLE=1000 us at Timer0, YPlcCycleDuty:1\nCRYSTAL=0\nVAR "
     "LIST\nwhat\nEND\n"
     "IO LIST\nXa at PB5\nXb at 4\nYc at 4 1 17\nEND\nPROGRAM\nRUNG\nEND\n",
     "t.ld:1:1: warning: the format 0.7 is not known; it is read as 0.2\n"
     "t.ld:2:1: warning: FROB=1: not known before PROGRAM; ignored\n"
     "t.ld:3:1: warning: YPlcCycleDuty:1 is not followed: no output shows the scan's duration\n"
     "t.ld:4:1: warning: CRYSTAL=0: taken as 4000000\n"
     "t.ld:6:1: warning: what: no line of a VAR LIST; ignored\n"
     "t.ld:9:7: warning: pin PB5: a pin with a name, taken as one that is not assigned\n"
     "t.ld:11:7: warning: pin 4 is assigned to Xb already\n"
     "    give one of the two another pin, or 0\n"
     "t.ld:11:9: warning: 1: an address on a bus is not followed\n"},
    {"NoFirstLine", "CYCLE=10000\nPROGRAM\nRUNG\nEND\n", ""},
    {"CountersOf02", ld_file("OSR\nCTU C 5", "LDmicro0.2"),
     "t.ld:5:1: warning: CTU C 5: timers and counters do what LDmicro 2.3 does, whose manual is "
     "followed; in a file of 0.2 LDmicro 5 lets timers wait one scan longer, and its counters stop "
     "at their limits\n"},
};

INSTANTIATE_TEST_SUITE_P(All, LdmicroWarnings, testing::ValuesIn(kWarned),
                         [](const auto& info) { return std::string(info.param.name); });

// --- encodings ---

std::string note_of(std::string_view bytes) {
  const ParseResult result = parse_ld(ld_file("COMMENT " + std::string(bytes)));
  return result.program ? result.program->instructions[1].note : result.messages;
}

TEST(LdmicroEncoding, CodePagesAndUnicode) {
  EXPECT_EQ(note_of("\xE8\xA1\xA8"), "\u8868");                         // UTF-8
  EXPECT_EQ(note_of("\x93\xFA\x96\x7B"), "\u65E5\u672C");               // code page 932
  EXPECT_EQ(note_of("Stra\xDF\x65, \x80 5"), "Stra\u00DFe, \u20AC 5");  // 1252
  EXPECT_EQ(note_of("\xFF\xFF\x81"),
            "t.ld:4:9: error: the byte 0xFF is valid neither in UTF-8 nor "
            "in Shift-JIS\n    save it as UTF-8, or as UTF-16 with a byte "
            "order mark\n");
}

// The second byte of U+8868 in code page 932 is a backslash, which is escaped like any other.
TEST(LdmicroEncoding, BackslashAsSecondByte) {
  EXPECT_EQ(note_of("\x95\\\\n"), "\u8868n");
  EXPECT_EQ(note_of("\x95\\\\\\n\x95\\\\"), "\u8868\n\u8868");
  EXPECT_EQ(note_of("\x95\\\\\\\\\r"), "\u8868\\");
}

}  // namespace
}  // namespace rung
