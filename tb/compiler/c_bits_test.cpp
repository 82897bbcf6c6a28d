// SPDX-License-Identifier: Apache-2.0
// The C back end: contacts, bits, timers, counters, zones and flow.
#include <gtest/gtest.h>

#include "c_story.hpp"

namespace rung {
namespace {

constexpr Dialect kQ = Dialect::Q;

constexpr CStory kContacts[] = {
    {"Plain", "LD X0, AND X1, ANI X2, OR X3, ORI X4, OUT Y0",
     "X4=1 | X0=1 X1=1 | X2=1 | X3=1 | X3=0 | X4=0", "Y0=0 | Y0=1 | Y0=0 | Y0=1 | Y0=0 | Y0=1"},
    {"Blocks", "LD X0, ORI X1, LD X2, ANI X3, ORB, LDI X4, OR X5, ANB, INV, OUT Y10",
     "| X4=1 | X5=1 | X0=0 X1=1 | X2=1 | X3=1", "Y10=0 | Y10=1 | Y10=0 | Y10=1 | Y10=0 | Y10=1"},
    {"Branches", "LD X0, MPS, AND X1, OUT Y0, MRD, ANI X1, OUT Y1, MPP, OUT Y2, AND X2, OUT Y3",
     "X0=1 | X1=1 X2=1 | X0=0", "Y0=0 Y1=1 Y2=1 Y3=0 | Y0=1 Y1=0 Y2=1 Y3=1 | Y0=0 Y2=0 Y3=0"},
    {"Edges", "LDP X0, ORF X1, OUT Y0, LD X2, ANDP X3, OUT Y1, LDF X0, OR X7, ANDF X4, OUT Y2",
     "X0=1 X1=1 | X1=0 X3=1 | X2=1 | X3=0 X4=1 X7=1 | X3=1 X4=0 |",
     "Y0=1 Y1=0 Y2=0 | Y0=1 Y1=0 | Y0=0 Y1=0 | Y1=0 Y2=0 | Y1=1 Y2=1 | Y1=0 Y2=0"},
    {"Compares",
     "LD> D0 K-1, AND<= D0 D1, OUT Y0, LD<> D0 D0, OR= D0 K32767, OUT Y1, LDD>= D2 K-2147483648,"
     "ANDD< D2 K100000, OUT Y2",
     "| D0=32767 | D1=32767 D2=0 D3=-32768 | D2=-31073 D3=1 | D2=-31072",
     "Y0=1 Y1=0 Y2=1 | Y0=0 Y1=1 | Y0=1 Y1=1 Y2=1 | Y2=1 | Y2=0"},
    {"PulseOfAResult", "LD X0, MEP, OUT Y0, LD X0, MEF, OUT Y1", "X0=1 | | X0=0 |",
     "Y0=1 Y1=0 | Y0=0 Y1=0 | Y0=0 Y1=1 | Y0=0 Y1=0", kQ},
    {"DoubleCoil", "LD X0, OUT M0, LD M0, OUT Y0, LD X1, OUT M0", "X0=1 | X0=0 X1=1",
     "Y0=1 M0=0 | Y0=0 M0=1"},
    {"WordBits", "LD D0.F, ANI D0.1, OUT D1.0, SET D1.F, LD X0, RST D1.F",
     "D0=-32768 D1=6 | D0=-32766 | D0=-32768 X0=1", "D1=-32761 | D1=-32762 | D1=7"},
    {"SpecialRelays", "LD M8000, OUT Y0, LD M8001, OUT Y1, LD M8002, OUT Y2, LD M8003, OUT Y3",
     "| |", "Y0=1 Y1=0 Y2=1 Y3=0 | Y0=1 Y1=0 Y2=0 Y3=1 | Y2=0 Y3=1"},
    {"SpecialRelaysOfQ", "LD SM400, ANI SM401, OUT Y0, LD SM402, OUT Y1, LD SM403, OUT YA", "| |",
     "Y0=1 Y1=1 YA=0 | Y0=1 Y1=0 YA=1 | Y1=0 YA=1", kQ},
    {"Clocks", "LD M8011, OUT Y0, LD M8012, OUT Y1", "| | | |",
     "Y0=0 Y1=0 | Y0=1 Y1=0 | Y0=0 Y1=1 | Y0=1 Y1=1 | Y0=0 Y1=0", Dialect::Fx, 25000},
};
TEST(CStories, Contacts) { expect_c_stories(kContacts); }

constexpr CStory kBits[] = {
    {"SetReset", "LD X0, SET M0, LD X1, RST M0, LD X2, RST D5", "X0=1 | X0=0 | X1=1 D5=7 | X2=1",
     "M0=1 | M0=1 | M0=0 D5=7 | D5=0"},
    {"Pulses", "LD X0, PLS M0, PLF M1", "| X0=1 | | X0=0 |",
     "M0=0 M1=0 | M0=1 M1=0 | M0=0 M1=0 | M0=0 M1=1 | M1=0"},
    {"Alternate", "LD X0, ALT M0, ALTP M1", "X0=1 | | X0=0 | X0=1",
     "M0=1 M1=1 | M0=0 M1=1 | M0=0 M1=1 | M0=1 M1=0"},
    {"FlipFlopOfQ", "LD X0, FF M1", "X0=1 | | X0=0 | X0=1", "M1=1 | M1=1 | M1=1 | M1=0", kQ},
    {"ShiftOne", "LD X0, SFT M1", "M0=1 | X0=1 | M0=1 |",
     "M0=1 M1=0 | M0=0 M1=1 | M0=0 M1=1 | M1=0", kQ},
    {"ShiftBits", "LD X0, SFTLP X10 M0 K4 K2, LD X1, SFTRP X10 M0 K4 K1",
     "X10=1 X0=1 | X0=0 | X10=0 X11=1 X0=1 | X10=1 X1=1",
     "M0=1 M1=0 M2=0 M3=0 | M0=1 | M0=0 M1=1 M2=1 M3=0 | M0=1 M1=1 M2=0 M3=1"},
    {"ShiftBitsOntoThemselves", "LD X0, SFTL M1 M0 K4 K2", "X0=1 M1=1 M3=1", "M0=1 M1=0 M2=0 M3=1"},
    {"ShiftByOneOfQ", "LD X0, BSFLP M0 K3, LD X1, BSFRP M0 K3, LD SM700, OUT Y0",
     "M0=1 M2=1 X0=1 | X0=0 X1=1 | X1=0 | X1=1",
     "M0=0 M1=1 M2=0 Y0=1 | M0=1 M1=0 M2=0 Y0=0 | M0=1 | M0=0 Y0=1", kQ},
};
TEST(CStories, Bits) { expect_c_stories(kBits); }

constexpr CStory kTimers[] = {
    {"Timer", "LD X0, OUT T0 K2, LD T0, OUT Y0", "X0=1 | | | | X0=0",
     "TN0=0 Y0=0 | TN0=0 Y0=0 | TN0=1 Y0=0 | TN0=2 Y0=1 | TN0=0 Y0=0", Dialect::Fx, 70000},
    {"MillisecondsRetentive", "LD X0, OUT T246 K20, LD X1, RST T246",
     "X0=1 | | X0=0 | X0=1 | | X1=1 |",
     "TN246=0 | TN246=7 | TN246=7 | TN246=7 | TN246=15 | TN246=0 TS246=0 | TN246=0", Dialect::Fx,
     7300},
    {"TwiceInAScan", "LD X0, OUT T200 K9, LD X0, OUT T200 K9", "X0=1 | | |",
     "TN200=0 | TN200=1 | TN200=2 | TN200=3"},
    {"ZeroAndRaisedPreset", "LD X0, OUT T200 D0, OUT T201 D1", "X0=1 D1=2 | | | D1=9 | X0=0",
     "TS200=1 TS201=0 | TS201=0 TN201=1 | TS201=1 TN201=2 | TS201=1 TN201=2 | TS201=0 TN201=0"},
    {"HighSpeedOfQ", "LD X0, OUTH T0 K3, OUT ST1 K3", "X0=1 | | | X0=0",
     "TN0=0 | TN0=3 TS0=1 | TN0=3 STN1=1 | TN0=0 STN1=1 STS1=0", kQ, 50000},
    {"Counter", "LD X0, OUT C0 K2, LD X1, RST C0", "X0=1 | | X0=0 | X0=1 | X0=0 | X0=1 | X1=1",
     "CN0=1 CS0=0 | CN0=1 | CN0=1 | CN0=2 CS0=1 | CS0=1 | CN0=2 CS0=1 | CN0=0 CS0=0"},
    {"HeldByItsReset", "LD X1, RST C0, LD X0, OUT C0 K5", "X1=1 | X0=1 | X0=0 X1=0 | X0=1",
     "CN0=0 | CN0=0 | CN0=0 | CN0=1"},
    {"UpAndDown", "LD X1, OUT M8201, LD X0, OUT C201 K-1",
     "X0=1 X1=1 | X0=0 | X0=1 | X0=0 X1=0 | X0=1 | X0=0 | X0=1",
     "CN201=-1 CN201:h=-1 CS201=0 | CS201=0 | CN201=-2 CS201=0 | CS201=0 | CN201=-1 CS201=1 |"
     "CS201=1 | CN201=0 CN201:h=0 CS201=1"},
    {"Ring", "LD X0, OUT C200 K5", "CN200=-1 CN200:h=32767 X0=1", "CN200=0 CN200:h=-32768"},
    {"ResetRanges",
     "LD X0, ZRST C0 C1, ZRST T3 T4, ZRST C199 C198, ZRST C200 C201, ZRST M5 M7, ZRST D4 D3",
     "CN0=5 CS1=1 TN4=3 TS3=1 CN199=1 CN200=2 CN200:h=3 M5=1 M6=1 M7=1 D4=4 | X0=1",
     "CN0=5 CS1=1 M6=1 | CN0=0 CS1=0 TN4=0 TS3=0 CN199=0 CN200=0 CN200:h=0 M5=0 M6=0 M7=0 D4=0"},
};
TEST(CStories, TimersAndCounters) { expect_c_stories(kTimers); }

constexpr CStory kZones[] = {
    {"Masters",
     "LD X0, MC N0 M100, LD X1, OUT Y0, SET M1, MC N1 M101, LD X2, OUT Y1, INV, OUT Y2, MCR N1,"
     "LD X2, OUT Y3, MCR N0, LD X2, OUT Y4",
     "X1=1 X2=1 | X0=1 | X1=0 X2=0 | X0=0",
     "Y0=0 M1=0 Y1=0 Y3=0 Y4=1 | Y0=1 M1=1 M101=1 Y1=1 Y2=0 Y3=1 | Y0=0 M101=0 Y1=0 Y2=0 Y3=0 |"
     "M100=0 Y2=0"},
    {"CoilsWithoutPower", "LD X0, MC N0 M100, LD X1, OUTI Y0, OUT T200 K9, PLS M0, INCP D0, MCR N0",
     "X1=1 | X0=1 | | X0=0 | X0=1",
     "Y0=0 M0=0 | Y0=0 M0=1 D0=1 | TN200=1 M0=0 | TN200=0 | M0=1 D0=2"},
    {"Steps",
     "LD M8002, SET S0, STL S0, OUT Y0, LD X0, SET S20, STL S20, OUT Y1, LD X1, SET S0, RET, LD X2,"
     "OUT Y2",
     "| X0=1 X2=1 | X0=0 | X1=1 | X1=0",
     "S0=1 Y0=1 Y1=0 | S0=1 S20=1 Y0=1 Y1=1 Y2=1 | S0=0 S20=1 Y0=0 Y1=1 | S0=1 S20=1 |"
     "S0=1 S20=0 Y0=1 Y1=0"},
    {"StepsByOut", "STL S20, LD X0, OUT S21, STL S21, OUT Y0, RET", "S20=1 | X0=1 | |",
     "S21=0 | S20=1 S21=1 Y0=1 | S20=0 S21=1 Y0=1 | S21=1 Y0=1"},
    {"Join", "STL S20, STL S21, LD X0, SET S22, STL S22, OUT Y0, RET", "S20=1 X0=1 | S21=1 |",
     "S22=0 | S20=1 S21=1 S22=1 Y0=1 | S20=0 S21=0 S22=1"},
    {"InactiveIsSkipped", "STL S20, OUT Y0, OUT T200 K9, LDP X0, SET M0, RET",
     "S20=1 | S20=0 | Y0=1 X0=1 | S20=1", "Y0=1 TN200=0 | Y0=0 TN200=0 | Y0=1 M0=0 | Y0=1 M0=1"},
};
TEST(CStories, Zones) { expect_c_stories(kZones); }

constexpr CStory kFlow[] = {
    {"Jump", "LD X0, CJ P1, LD X1, OUT Y0, LDP X1, INC D0, P1, LD X1, OUT Y1",
     "X1=1 | X0=1 X1=0 | X1=1 | X0=0", "Y0=1 D0=1 Y1=1 | Y0=1 Y1=0 | Y0=1 Y1=1 D0=1 | Y0=1 D0=1"},
    {"JumpToTheEnd", "LD X0, CJ P63, LD X1, OUT Y0", "X1=1 | X0=1 X1=0", "Y0=1 | Y0=1"},
    {"Subroutine", "LD X0, CALL P1, LD X1, CALL P1, FEND, P1, LDP X2, INC D0, LD X2, INCP D1, SRET",
     "X0=1 X1=1 X2=1 | | X2=0 | X0=0 X2=1", "D0=1 D1=1 | D0=1 | D0=1 | D0=2 D1=2"},
    {"SubroutineWithinASubroutine",
     "LD X0, CALL P1, FEND, P1, LD X1, CALL P2, INC D0, SRET, P2, LD X1, INC D1, SRET",
     "X0=1 | X1=1 | X0=0", "D0=0 D1=0 | D0=1 D1=1 | D0=1 D1=1"},
    {"TwoEntries",
     "LD X0, CALL P1, LD X1, CALL P2, FEND, P1, LD X2, INC D0, P2, LD X2, INC D1, SRET",
     "X0=1 X1=1 X2=1 | X0=0", "D0=1 D1=2 | D0=1 D1=3"},
    {"Loops", "FOR K3, LD X0, INC D0, FOR K2, LD X0, INC D1, LDP X0, INC D2, NEXT, NEXT",
     "X0=1 | X0=0 |", "D0=3 D1=6 D2=1 | D0=3 | D1=6"},
};
TEST(CStories, Flow) { expect_c_stories(kFlow); }

}  // namespace
}  // namespace rung
