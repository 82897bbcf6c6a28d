// SPDX-License-Identifier: Apache-2.0
// The reference: arithmetic, its flags and errors; rotates; decimal numbers.
#include "reference_story.hpp"

namespace rung {
namespace {

constexpr Story kFlags[] = {
    {"OfAdd", "LD X0, ADD D0 D1 D2, LD M8020, OUT Y0, LD M8021, OUT Y1, LD M8022, OUT Y2",
     "X0=1 D0=32767 D1=1 | D0=-32768 D1=-1 | D0=5 D1=-5 | D0=-32768 D1=-32768 | X0=0 | X0=1 D0=1",
     "D2=-32768 M8022=1 Y0=0 Y1=0 Y2=1 | D2=32767 M8021=1 M8022=0 Y0=0 Y1=1 Y2=0 |"
     "D2=0 M8020=1 M8021=0 Y0=1 Y1=0 Y2=0 | D2=0 M8021=1 Y0=1 Y1=1 Y2=0 | Y0=1 Y1=1 Y2=0 |"
     "D2=-32767 M8020=0 M8021=0 Y0=0 Y1=0 Y2=0"},
    {"OfSub", "LD X0, SUB D0 D1 D2, LD M8020, OUT Y0, LD M8021, OUT Y1, LD M8022, OUT Y2",
     "X0=1 D0=-32768 D1=1 | D0=32767 D1=-1 | D1=32767",
     "D2=32767 M8021=1 Y0=0 Y1=1 Y2=0 | D2=-32768 M8021=0 M8022=1 Y0=0 Y1=0 Y2=1 |"
     "D2=0 M8020=1 M8022=0 Y0=1 Y1=0 Y2=0"},
    {"Wide", "LD X0, DSUB D0 K1 D2, LD M8020, OUT Y0, LD M8021, OUT Y1, LD M8022, OUT Y2",
     "X0=1 D1=-32768 | D0=1 D1=0",
     "D2=-1 D3=32767 M8021=1 Y0=0 Y1=1 Y2=0 |"
     "D2=0 D3=0 M8020=1 M8021=0 Y0=1 Y1=0 Y2=0"},
    {"WideAdd", "LD X0, DADD D0 K1 D2, LD M8022, OUT Y2", "X0=1 D0=-1 D1=32767 | D1=-1",
     "D2=0 D3=-32768 M8022=1 Y2=1 | D2=0 D3=0 M8022=0 Y2=0"},
    {"NoneOfQ", "LD X0, + K32767 K1 D0, LD SM700, OUT Y0", "X0=1", "D0=-32768 Y0=0", Dialect::Q},
    {"NoneOfIncAndDec", "LD X0, INC D0, DEC D1, LD M8022, OR M8021, OUT Y0",
     "X0=1 D0=32767 D1=-32768", "D0=-32768 D1=32767 Y0=0"},
};
INSTANTIATE_TEST_SUITE_P(Flags, ReferenceStory, testing::ValuesIn(kFlags), story_name);

constexpr Story kArithmetic[] = {
    {"IncEveryScan", "LD X0, INC D0, INCP D1", "X0=1 | | X0=0", "D0=1 D1=1 | D0=2 |"},
    {"Wide", "LD X0, DINC D0, DDEC D2, DNEG D4", "X0=1 D0=-1 D5=-32768",
     "D0=0 D1=1 D2=-1 D3=-1 D4=0 D5=-32768"},
    {"Neg", "LD X0, NEG D0, NEG D1, DNEG D2", "X0=1 D0=-32768 D1=5 D2=1",
     "D0=-32768 D1=-5 D2=-1 D3=-1"},
    // 2^62; 2^31 x -1 = -2^31 in 64 bits; 65536 x 65537 = 2^32 + 65536
    {"Dmul",
     "LD X0, DMUL K-2147483648 K-2147483648 D0, DMUL K-2147483648 K1 D4, DMUL K65536 K65537 D8",
     "X0=1", "D0=0 D1=0 D2=0 D3=16384 D4=0 D5=-32768 D6=-1 D7=-1 D8=0 D9=1 D10=1 D11=0"},
    {"Ddiv", "LD X0, DDIV K-7 K2 D0, DDIV K7 K-2 D4, DDIV K-2147483648 K-1 D8", "X0=1",
     "D0=-3 D1=-1 D2=-1 D3=-1 D4=-3 D5=-1 D6=1 D7=0 D8=0 D9=-32768 D10=0 D11=0"},
    {"DdivByAPairWhoseLowWordIsZero", "LD X0, DDIV D0 D2 D4", "X0=1 D0=5 D1=3 D3=1",
     "D4=3 D5=0 D6=5 D7=0"},
    {"ErrorOfDivStays", "LD X0, DIV K1 D9 D0, LD M8067, OUT Y0, LD X1, RST M8067",
     "X0=1 | X0=0 | X1=1 | X1=0", "M8067=1 Y0=1 | Y0=1 | Y0=1 M8067=0 | Y0=0"},
    {"BothRelaysOfAnFx", "LD X0, DDIVP K1 K0 D0, LD M8067, OR M8068, OUT Y0", "X0=1",
     "M8067=1 M8068=1 Y0=1"},
    {"BothRelaysOfAQ", "LD X0, / K1 K0 D0, LD SM0, OR SM56, OUT Y0", "X0=1", "SM0=1 SM56=1 Y0=1",
     Dialect::Q},
};
INSTANTIATE_TEST_SUITE_P(Arithmetic, ReferenceStory, testing::ValuesIn(kArithmetic), story_name);

constexpr Story kRotates[] = {
    // E001 becomes 000F; of 1 1 1 the last 1 is carry.
    {"Rol", "LD X0, ROLP D0 K3, LD M8022, OUT Y0", "X0=1 D0=-8191 |", "D0=15 M8022=1 Y0=1 | Y0=1"},
    {"Ror", "LD X0, RORP D0 K1, LD M8022, OUT Y0", "X0=1 D0=2 | X0=0 | X0=1",
     "D0=1 Y0=0 | Y0=0 | D0=-32768 M8022=1 Y0=1"},
    // 4000 and carry 1: 8001 and 0, then 0002 and 1
    {"Rcl", "LD X0, RCLP D0 K2, LD M8022, OUT Y0", "X0=1 D0=16384 M8022=1", "D0=2 Y0=1"},
    {"Rcr", "LD X0, RCRP D0 K1, LD M8022, OUT Y0", "X0=1 D0=1 | X0=0 | X0=1",
     "D0=0 M8022=1 Y0=1 | Y0=1 | D0=-32768 M8022=0 Y0=0"},
    {"RclNamesCarryItself", "LD X0, RCLP D0 K1", "X0=1 D0=-32768", "D0=0 M8022=1"},
    {"Drol", "LD X0, DROLP D0 K1, DRORP D2 K1, LD M8022, OUT Y0", "X0=1 D1=-32768 D2=1",
     "D0=1 D1=0 M8022=1 D2=0 D3=-32768 Y0=1"},
    {"Drcr", "LD X0, DRCRP D0 K1, DRCLP D2 K1", "X0=1 D0=3 D3=-32768",
     "D0=1 D1=0 M8022=1 D2=1 D3=0"},
    {"WholeTurn", "LD X0, ROLP D0 K16, LD M8022, OUT Y0", "X0=1 D0=1", "D0=1 M8022=1 Y0=1"},
    // 1001: of 0 0 0 1 the last left last.
    {"Sfl", "LD X0, SFLP D0 K4, LD SM700, OUT Y0", "X0=1 D0=4097", "D0=16 SM700=1 Y0=1",
     Dialect::Q},
    {"Sfr", "LD X0, SFRP D0 K1, LD SM700, OUT Y0", "X0=1 D0=-1", "D0=32767 SM700=1 Y0=1",
     Dialect::Q},
    {"SflByNothing", "LD X0, SFLP D0 K0, LD SM700, OUT Y0", "X0=1 D0=-1 SM700=1",
     "D0=-1 SM700=0 Y0=0", Dialect::Q},
    {"RolByNothing", "LD X0, ROLP D0 K0, LD SM700, OUT Y0", "X0=1 D0=-1 SM700=1", "Y0=1",
     Dialect::Q},
};
INSTANTIATE_TEST_SUITE_P(Rotates, ReferenceStory, testing::ValuesIn(kRotates), story_name);

constexpr Story kDecimal[] = {
    {"Bcd", "LD X0, BCD D0 D1, LD M8067, OUT Y0", "X0=1 D0=9999 | D0=10000 | D0=-1",
     "D1=-26215 Y0=0 | M8067=1 Y0=1 | Y0=1"},
    {"BcdDigits", "LD X0, BCDP K1234 D1", "X0=1", "D1=4660"},
    {"Dbcd", "LD X0, DBCDP K99999999 D0, DBCDP K12345678 D2, DBCDP K100000000 D4", "X0=1",
     "D0=-26215 D1=-26215 D2=22136 D3=4660"},
    {"Bin", "LD X0, BIN D0 D1, LD M8067, OUT Y0", "X0=1 D0=-26215 | D0=10 | D0=-24576",
     "D1=9999 Y0=0 | M8067=1 Y0=1 | Y0=1"},
    {"BinOfDigits", "LD X7, BIN K2X0 D1", "X7=1 X0=1", "D1=81"},
    {"Dbin", "LD X0, DBINP D0 D2, DBINP D4 D6", "X0=1 D0=22136 D1=4660 D5=-24576",
     "D2=24910 D3=188"},
};
INSTANTIATE_TEST_SUITE_P(Decimal, ReferenceStory, testing::ValuesIn(kDecimal), story_name);

// What the processor calls its error flag: a division by zero, and nothing else.
TEST(ReferenceError, IsADivisionByZeroOfThisScan) {
  const Program program = story_program("LD X0, BCD K-1 D0, LD X1, DDIV K5 K0 D2", Dialect::Fx);
  Reference reference(program);
  preset(reference, "X0=1", Dialect::Fx);
  reference.run_scan();
  EXPECT_FALSE(reference.error());
  preset(reference, "X1=1", Dialect::Fx);
  reference.run_scan();
  EXPECT_TRUE(reference.error());
  preset(reference, "X1=0", Dialect::Fx);
  reference.run_scan();
  EXPECT_FALSE(reference.error());
}

}  // namespace
}  // namespace rung
