// SPDX-License-Identifier: Apache-2.0
// The C back end: words.
#include <gtest/gtest.h>

#include "c_story.hpp"

namespace rung {
namespace {

constexpr Dialect kQ = Dialect::Q;

constexpr CStory kMoves[] = {
    {"Moves", "LD X0, MOV K-5 D0, MOV D0 D1, CML D0 D2, DMOV K100000 D4, DCML D4 D6, XCH D0 D9",
     "D9=3 X0=1", "D0=3 D1=-5 D2=4 D4=-31072 D5=1 D6=31071 D7=-2 D9=-5"},
    {"Digits", "LD X0, MOV K2X0 D0, MOV D1 K1Y4, DMOV K8M0 D2, DMOV D4 K5M40, MOV K4X0 D6",
     "X0=1 X7=1 X17=1 D1=-6 M31=1 M0=1 D4=-1 D5=-1",
     "D0=129 Y4=0 Y5=1 Y6=0 Y7=1 D2=1 D3=-32768 M40=1 M59=1 D6=-32639"},
    {"Swap", "LD X0, SWAP D0, DSWAP D2", "X0=1 D0=258 D2=258 D3=-2", "D0=513 D2=513 D3=-257"},
    {"SwapPulsed", "LD X0, SWAPP D0", "X0=1 D0=-256 |", "D0=255 | D0=255", kQ},
    {"OverlappingExchange", "LD X0, DXCHP D0 D1", "X0=1 D0=1 D1=2 D2=3", "D0=2 D1=1 D2=2"},
    {"Blocks", "LD X0, BMOV D0 D2 K4, FMOV K-7 D10 K3, BMOV K1X10 K1Y0 K2, FMOV K3 K1M0 K2",
     "D0=1 D1=2 D2=3 D3=4 X10=1 X15=1 X0=1",
     "D2=1 D3=2 D4=3 D5=4 D10=-7 D12=-7 Y0=1 Y1=0 Y4=0 Y5=1 M0=1 M1=1 M2=0 M4=1 M5=1"},
    {"BlocksDownwards", "LD X0, BMOVP D1 D0 K3, DFMOVP K65537 D10 K2", "D1=1 D2=2 D3=3 X0=1",
     "D0=1 D1=2 D2=3 D3=3 D10=1 D11=1 D12=1 D13=1"},
    {"WordsShift", "LD X0, WSFLP D20 D0 K3 K1, LD X1, WSFRP D20 D0 K3 K2",
     "D0=1 D1=2 D2=3 D20=9 D21=8 X0=1 | X1=1", "D0=9 D1=1 D2=2 | D0=2 D1=9 D2=8"},
    {"WordsShiftOfQ", "LD X0, DSFLP D0 K3, LD X1, DSFRP D0 K3", "D0=1 D1=2 D2=3 X0=1 | X1=1",
     "D0=0 D1=1 D2=2 | D0=1 D1=2 D2=0", kQ},
};
TEST(CStories, Moves) { expect_c_stories(kMoves); }

constexpr CStory kArithmetic[] = {
    {"Wraps", "LD X0, ADD D0 K1 D1, SUB D2 K1 D3, INC D0, DEC D2, NEG D4, DNEG D6",
     "X0=1 D0=32767 D2=-32768 D4=-32768 D6=0 D7=-32768",
     "D1=-32768 D3=32767 D0=-32768 D2=32767 D4=-32768 D6=0 D7=-32768"},
    {"Flags", "LD X0, ADD D0 D1 D2, LD M8020, OUT Y0, LD M8021, OUT Y1, LD M8022, OUT Y2",
     "X0=1 D0=32767 D1=1 | D0=-32768 D1=-1 | D1=-32768 | D0=5 D1=-5 | X0=0 D0=1 | X0=1",
     "Y0=0 Y1=0 Y2=1 | Y0=0 Y1=1 Y2=0 | D2=0 Y0=1 Y1=1 Y2=0 | Y0=1 Y1=0 Y2=0 | Y0=1 | Y0=0"},
    {"FlagsOf32Bits", "LD X0, DSUB D0 D2 D4, LD M8020, OUT Y0, LD M8021, OUT Y1, LD M8022, OUT Y2",
     "X0=1 D1=-32768 D2=1 | D0=-1 D1=32767 D2=-1 D3=-1 | D0=0 D1=0 D2=0 D3=0",
     "D4=-1 D5=32767 Y0=0 Y1=1 Y2=0 | D4=0 D5=-32768 Y1=0 Y2=1 | Y0=1 Y1=0 Y2=0"},
    {"Products", "LD X0, MUL D0 D1 D2, DMUL D4 D6 D8",
     "X0=1 D0=-32768 D1=-32768 D4=0 D5=-32768 D6=-1 D7=-1 | D0=-1 D1=3",
     "D2=0 D3=16384 D8=0 D9=-32768 D10=0 D11=0 | D2=-3 D3=-1"},
    {"Quotients", "LD X0, DIV D0 D1 D2, DDIV D4 D6 D8",
     "X0=1 D0=-7 D1=2 D4=0 D5=-32768 D6=-1 D7=-1 | D0=7 D1=-2 D6=-2 | D0=-32768 D1=-1",
     "D2=-3 D3=-1 D8=0 D9=-32768 D10=0 D11=0 | D2=-3 D3=1 D8=0 D9=16384 | D2=-32768 D3=0"},
    {"ByZero", "LD X0, DIV D0 D1 D2, LD M8067, OUT Y0, LD X1, RST M8067",
     "X0=1 D0=5 D2=9 | D1=1 | X1=1 |", "D2=9 Y0=1 | D2=5 Y0=1 | Y0=1 M8067=0 | Y0=0"},
    {"ByZeroOfQ", "LD X0, / D0 D1 D2, D/ D0 D4 D6, LD SM0, OUT Y0, LD SM56, OUT Y1",
     "D1=1 | D0=5 X0=1", "Y0=0 | D2=5 D3=0 Y0=1 Y1=1", kQ},
    {"PaperHasNoHighWords", "LD X0, MUL D0 D1 D2, DIV D0 D1 D4", "X0=1 D0=300 D1=300",
     "D2=24464 D3=0 D4=1 D5=0", Dialect::Paper},
    {"Logic", "LD X0, WAND D0 D1 D2, WOR D0 D1 D3, WXOR D0 D1 D4, DWXOR D0 K-1 D5",
     "X0=1 D0=12 D1=10", "D2=8 D3=14 D4=6 D5=-13 D6=-11"},
    {"LogicOfQ", "LD X0, WXNR D0 D1 D2, WORP K1 D3", "X0=1 D0=12 D1=10 D3=4", "D2=-7 D3=5", kQ},
    {"Pulses", "LD X0, INCP D0, DINCP D2, ADDP D4 K2 D4", "X0=1 D2=-1 | | X0=0 | X0=1",
     "D0=1 D2=0 D3=1 D4=2 | D0=1 D4=2 | D0=1 | D0=2 D2=1 D4=4"},
    {"Decimal", "LD X0, BCD D0 D1, BIN D2 D3, DBCD D4 D6, DBIN D6 D8, LD M8067, OUT Y0",
     "X0=1 D0=1234 D2=4660 D4=-7937 D5=1525 | D0=9999 | D0=10000 | M8067=0 D0=0 D2=10 |"
     "M8067=0 D2=0 D4=-7936",
     "D1=4660 D3=1234 D6=-26215 D7=-26215 D8=-7937 D9=1525 Y0=0 | D1=-26215 Y0=0 | D1=-26215 Y0=1 |"
     "D3=1234 Y0=1 | D3=0 D6=-26215 Y0=1"},
    {"Comparisons", "LD X0, CMP D0 D1 M0, ZCP K-5 K5 D0 M10, DCMP D2 K70000 M20",
     "X0=1 D0=-6 D1=3 | D0=3 | D0=6 D2=4464 D3=1",
     "M0=0 M1=0 M2=1 M10=1 M11=0 M12=0 M22=1 | M1=1 M2=0 M10=0 M11=1 | M0=1 M12=1 M21=1"},
};
TEST(CStories, Arithmetic) { expect_c_stories(kArithmetic); }

constexpr CStory kRotates[] = {
    {"Rotates", "LD X0, ROL D0 K1, ROR D1 K4, LD M8022, OUT Y0", "X0=1 D0=-32768 D1=8 | D1=1",
     "D0=1 D1=-32768 Y0=1 | D0=2 D1=4096 Y0=0"},
    {"RotatesThroughCarry", "LD X0, RCLP D0 K1, LD X1, RCRP D2 K2", "X0=1 D0=-32768 | X1=1 D2=3",
     "D0=0 M8022=1 | D2=-16384 M8022=1"},
    {"RotatesOf32Bits", "LD X0, DROL D0 K1, DRCR D2 K1", "X0=1 D0=-32768 D1=-32768 D2=2",
     "D0=1 D1=1 D2=1 D3=-32768 M8022=0"},
    {"ShiftsOfQ", "LD X0, SFL D0 K4, LD SM700, OUT Y0, LD X0, SFR D1 K15, LD SM700, OUT Y1",
     "X0=1 D0=4097 D1=-16384", "D0=16 Y0=1 D1=1 Y1=1", kQ},
    {"ShiftByNothing", "LD X0, SFR D0 K0, LD SM700, OUT Y0", "SM700=1 D0=3 | X0=1",
     "Y0=1 | D0=3 Y0=0", kQ},
};
TEST(CStories, Rotates) { expect_c_stories(kRotates); }

constexpr CStory kIndices[] = {
    {"Indexed", "LD X0, MOV D20Z1 D0, MOV K7 D21V0, DADD D30Z1 K1 D40Z1, LD M8067, OUT Y0",
     "X0=1 Z1=2 D22=5 D32=-1 V0=-1 | Z1=-20 D0=3 | Z1=200 M8067=0",
     "D0=5 D20=7 D42=0 D43=1 Y0=0 | D0=3 D10=0 D20=1 Y0=0 | Y0=1"},
    {"IndexedContacts", "LD M0Z0, OUT Y0, LDI M0Z0, OUT Y1, LD M8068, OUT Y2",
     "M1=1 Z0=1 | Z0=-1 | Z0=127", "Y0=1 Y1=0 Y2=0 | Y0=0 Y1=1 Y2=1 | Y0=0 Y1=1"},
    {"IndexedOutputs", "LD X0, OUT Y10Z0, SET M0Z0, LD X1, RST M0Z0, LD M8067, OUT M50",
     "X0=1 Z0=2 | X0=0 Z0=300 | M8067=0 Z0=2 X1=1", "Y12=1 M2=1 M50=0 | Y12=1 M50=1 | Y12=0 M2=0"},
    {"IndexedCompare", "LD= D0Z0 K0, OUT Y0, LDD> D10Z0 K0, OUT Y1", "D5=1 Z0=5 D16=1 | Z0=500",
     "Y0=0 Y1=1 | Y0=1 Y1=0"},
    {"IndexIsItsOwnTarget", "LD X0, MOV D0Z0 Z0", "X0=1 Z0=3 D3=7", "Z0=7"},
};
TEST(CStories, Indices) { expect_c_stories(kIndices); }

}  // namespace
}  // namespace rung
