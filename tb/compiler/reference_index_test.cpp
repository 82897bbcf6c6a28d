// SPDX-License-Identifier: Apache-2.0
// The reference: index registers, in and out of their windows.
#include "reference_story.hpp"

namespace rung {
namespace {

constexpr Story kIndexed[] = {
    {"Words", "LD X0, MOV D20Z0 D0, MOV K7 D30V1", "X0=1 Z0=5 V1=-1 D25=11", "D0=11 D29=7"},
    // The window of D is D0, the lowest that is named, to D147: 127 beyond the highest indexed one.
    {"EndOfTheWindow", "LD X0, MOV D20Z0 D0, LD M8067, OUT Y0",
     "X0=1 Z0=127 D147=5 | Z0=-20 D0=6 | Z0=128 | Z0=0",
     "D0=5 Y0=0 | D0=6 Y0=0 | M8067=1 Y0=1 | D0=0 Y0=1"},
    {"BeforeTheFirst", "LD X0, MOV K1 D20Z0, LD M8067, OR M8068, OUT Y0", "X0=1 Z0=-1 | Z0=1",
     "M8067=1 M8068=1 Y0=1 | D21=1 Y0=1"},
    {"Extremes", "LD X0, MOV K1 D20Z0, LD M8067, OUT Y0", "X0=1 Z0=-32768 | Z0=32767",
     "M8067=1 Y0=1 | Y0=1"},
    {"NoErrorWithoutItsCondition", "LD X0, MOV K1 D20Z0, LD M8067, OUT Y0", "Z0=-1", "Y0=0"},
    // 32 bits: both words must lie within.
    {"Pairs", "LD X0, DMOV K65537 D20Z0, LD M8067, OUT Y0", "X0=1 Z0=126 | Z0=127",
     "D146=1 D147=1 Y0=0 | M8067=1 Y0=1"},
    {"Products", "LD X0, MUL K-1 K1 D20Z0, DIV K7 D20Z0 D0", "X0=1 Z0=1 ",
     "D21=-1 D22=-1 D0=-7 D1=0"},
    {"TwoIndexes", "LD X0, ADD D10Z0 D20Z1 D30Z2", "X0=1 Z0=1 Z1=2 Z2=3 D11=4 D22=5", "D33=9"},
    {"Contacts", "LD M10Z0, OUT Y0, LDI M10Z0, OUT Y1", "M12=1 Z0=2 | Z0=3",
     "Y0=1 Y1=0 | Y0=0 Y1=1"},
    {"ContactsOutsideReadZero", "LD X0, OR M10Z0, OUT Y0, LDI M10Z0, OUT Y1, LD M8067, OUT Y2",
     "Z0=-1 | Z0=128 | X0=1", "M8067=1 Y0=0 Y1=1 Y2=1 | Y0=0 Y1=1 Y2=1 | Y0=1 Y1=1 Y2=1"},
    // Though X0 is off: every contact is evaluated.
    {"ContactInSeriesSetsTheError", "LD X0, AND M10Z0, OUT Y0, LD M8067, OUT Y2", "Z0=-1",
     "M8067=1 Y0=0 Y2=1"},
    // 0 is compared: the contact may well be on. In 32 bits both words are 0 as soon as one is
    // outside.
    {"ComparesOutsideReadZero", "LD<> D10Z0 K5, OUT Y0, LD= D10Z0 K5, OUT Y1, LD M8067, OUT Y2",
     "D11=5 Z0=1 | Z0=128", "Y0=0 Y1=1 Y2=0 | M8067=1 Y0=1 Y1=0 Y2=1"},
    {"ComparesOfPairsOutside", "LDD= D10Z0 K0, OUT Y0, LD M8067, OUT Y1", "D137=5 Z0=126 | Z0=127",
     "Y0=0 Y1=0 | M8067=1 Y0=1 Y1=1"},
    {"Coils", "LD X0, OUT Y10Z0, SET M10Z1, RST M20Z1", "X0=1 Z0=1 Z1=2 | X0=0",
     "Y11=1 M12=1 M22=0 | Y11=0"},
    {"OutOutsideAlwaysSetsTheError", "LD X0, OUT Y10Z0, LD M8067, OUT M0", "Z0=-9", "M8067=1 M0=1"},
    // Y and X count in octal, their numbers do not: Y10 is the eighth.
    {"Octal", "LD X0, OUT Y7Z0", "X0=1 Z0=1", "Y10=1"},
    {"PulseOutside", "LD X0, INCP D20Z0, LD M8067, OUT Y0", "X0=1 Z0=-21 | Z0=0 | X0=0 | X0=1",
     "M8067=1 Y0=1 | Y0=1 | Y0=1 | D20=1 Y0=1"},
    {"OfQ", "LD X0, MOV D20Z19 D0, LD SM0, OUT Y0", "X0=1 Z19=4 D24=3 | Z19=128",
     "D0=3 Y0=0 | SM0=1 Y0=1", Dialect::Q},
};
INSTANTIATE_TEST_SUITE_P(Indexed, ReferenceStory, testing::ValuesIn(kIndexed), story_name);

}  // namespace
}  // namespace rung
