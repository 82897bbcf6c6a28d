// SPDX-License-Identifier: Apache-2.0
// The reference: outputs on bits, and bits that shift.
#include "reference_story.hpp"

namespace rung {
namespace {

constexpr Story kCoils[] = {
    {"Outi", "LD X0, OUTI Y0", "| X0=1", "Y0=1 | Y0=0"},
    {"Pls", "LD X0, PLS M0", "X0=1 | | X0=0 | X0=1", "M0=1 | M0=0 | M0=0 | M0=1"},
    {"Plf", "LD X0, PLF M0", "X0=1 | | X0=0 |", "M0=0 | M0=0 | M0=1 | M0=0"},
    {"AltEveryScan", "LD X0, ALT M0", "X0=1 | | X0=0", "M0=1 | M0=0 |"},
    {"Altp", "LD X0, ALTP M0", "X0=1 | | X0=0 | X0=1", "M0=1 | | | M0=0"},
    {"Ff", "LD X0, FF M0", "X0=1 | | X0=0 | X0=1", "M0=1 | | | M0=0", Dialect::Q},
    // 3, bit 15 set: 8003; bit 0 is on already; without bit 1: 8001
    {"BitsOfAWord", "LD X0, OUT D0.F, SET D0.0, RST D0.1", "X0=1 D0=3 | X0=0",
     "D0=-32765 D0=-32765 D0=-32767 | D0=1"},
    {"TwoCoils", "LD X0, OUT Y0, LD X1, OUT Y0", "X0=1 | X1=1", "Y0=1 Y0=0 | Y0=1 Y0=1"},
};
INSTANTIATE_TEST_SUITE_P(Coils, ReferenceStory, testing::ValuesIn(kCoils), story_name);

constexpr Story kBitShifts[] = {
    {"Sft", "LD X0, SFTP M5", "X0=1 M4=1 |", "M4=0 M5=1 |", Dialect::Q},
    {"SftRow", "LD X0, SFTP M2, SFTP M1", "X0=1 M0=1 M1=1 | X0=0 | X0=1",
     "M1=0 M2=1 M0=0 M1=1 | | M1=0 M2=1 M0=0 M1=0", Dialect::Q},
    // 1011 in M3 M2 M1 M0 is 1, 0, 1, 1 from M0 up
    {"Sftl", "LD X0, SFTLP X10 M0 K4 K2", "X0=1 X11=1 M0=1 M2=1 M3=1 |", "M0=0 M1=1 M2=1 M3=0 |"},
    {"Sftr", "LD X0, SFTRP X10 M0 K4 K2", "X0=1 X11=1 M0=1 M2=1 M3=1 |", "M0=1 M1=1 M2=0 M3=1 |"},
    {"SftlEveryScan", "LD X0, SFTL X1 M0 K3 K1", "X0=1 X1=1 | X1=0 |",
     "M0=1 M1=0 M2=0 | M0=0 M1=1 M2=0 | M0=0 M1=0 M2=1"},
    {"Bsfl", "LD X0, BSFLP M0 K4, LD SM700, OUT Y0", "X0=1 M0=1 M3=1 | X0=0 | X0=1",
     "M0=0 M1=1 M2=0 M3=0 SM700=1 Y0=1 | Y0=1 | M0=0 M1=0 M2=1 M3=0 SM700=0 Y0=0", Dialect::Q},
    {"Bsfr", "LD X0, BSFRP M0 K4, LD SM700, OUT Y0", "X0=1 M0=1 M3=1 |",
     "M0=0 M1=0 M2=1 M3=0 SM700=1 Y0=1 | Y0=1", Dialect::Q},
    {"CarryOnlyIfNamed", "LD X0, BSFLP M0 K2", "X0=1 M1=1 |", "M0=0 M1=0 |", Dialect::Q},
};
INSTANTIATE_TEST_SUITE_P(BitShifts, ReferenceStory, testing::ValuesIn(kBitShifts), story_name);

}  // namespace
}  // namespace rung
