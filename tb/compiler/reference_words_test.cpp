// SPDX-License-Identifier: Apache-2.0
// The reference: words that move, combine, shift and are compared; digit groups.
#include "reference_story.hpp"

namespace rung {
namespace {

constexpr Story kMoves[] = {
    {"Dmov", "LD X0, DMOV K-2 D0, DMOV D0 D2, DMOV H12348000 D4", "X0=1",
     "D0=-2 D1=-1 D2=-2 D3=-1 D4=-32768 D5=4660"},
    {"MovpOnce", "LD X0, MOVP D0 D1", "X0=1 D0=5 | D0=6 | X0=0 | X0=1", "D1=5 | | | D1=6"},
    {"Cml", "LD X0, CML K0 D0, CML K1X0 D1, DCML K1 D2", "X0=1", "D0=-1 D1=-2 D2=-2 D3=-1"},
    {"Xch", "LD X0, XCHP D0 D1, DXCHP D2 D4", "X0=1 D0=1 D1=2 D2=3 D3=4 D4=5 D5=6 |",
     "D0=2 D1=1 D2=5 D3=6 D4=3 D5=4 |"},
    // Both pairs are read, then D0 and D1 are written before D1 and D2.
    {"XchOfOverlappingPairs", "LD X0, DXCHP D1 D0", "X0=1 D0=1 D1=2 D2=3", "D0=2 D1=3 D1=1 D2=2"},
    // 5 and AB: the group takes the lower digit.
    {"XchOfDigits", "LD X0, XCHP K1M0 D0", "X0=1 M0=1 M2=1 D0=171", "M0=1 M1=1 M2=0 M3=1 D0=5"},
    // 1234 5678
    {"Swap", "LD X0, SWAPP D0, DSWAPP D2", "X0=1 D0=4660 D2=4660 D3=22136 |",
     "D0=13330 D2=13330 D3=30806 |"},
    {"BmovUpwardsOverlapping", "LD X0, BMOVP D0 D1 K3", "X0=1 D0=1 D1=2 D2=3", "D1=1 D2=2 D3=3"},
    {"BmovDownwardsOverlapping", "LD X0, BMOVP D1 D0 K3", "X0=1 D1=2 D2=3 D3=4", "D0=2 D1=3 D2=4"},
    {"BmovOfDigits", "LD X7, BMOVP K1X0 K1Y0 K2", "X7=1 X0=1",
     "Y0=1 Y1=0 Y2=0 Y3=0 Y4=0 Y5=0 Y6=0 Y7=1"},
    {"Fmov", "LD X0, FMOVP K-1 D0 K3, DFMOVP K65536 D4 K2", "X0=1",
     "D0=-1 D1=-1 D2=-1 D4=0 D5=1 D6=0 D7=1"},
};
INSTANTIATE_TEST_SUITE_P(Moves, ReferenceStory, testing::ValuesIn(kMoves), story_name);

constexpr Story kDigits[] = {
    // 0001 0101 = 21; its lower digit 5
    {"SourceAndTarget", "LD X0, MOV K2X0 D0, MOV K2X0 K1M0", "X0=1 X2=1 X4=1",
     "D0=21 M0=1 M1=0 M2=1 M3=0"},
    {"SourceIsExtendedByZeros", "LD X0, MOV K3M0 D0, DMOV K4M0 D2", "X0=1 M11=1 M15=1",
     "D0=2048 D2=-30720 D3=0"},
    {"FourGroupsAreAWord", "LD X0, MOV K4M0 D0, DMOV K8M0 D2", "X0=1 M0=1 M15=1 M31=1",
     "D0=-32767 D2=-32767 D3=-32768"},
    {"IncWithinTheGroup", "LD X0, INC K1Y0", "X0=1 Y0=1 Y1=1 Y2=1 Y3=1", "Y0=0 Y1=0 Y2=0 Y3=0"},
};
INSTANTIATE_TEST_SUITE_P(Digits, ReferenceStory, testing::ValuesIn(kDigits), story_name);

// 0F0F and 00FF
constexpr Story kLogic[] = {
    {"Fx", "LD X0, WAND D0 D1 D2, WOR D0 D1 D3, WXOR D0 D1 D4", "X0=1 D0=3855 D1=255",
     "D2=15 D3=4095 D4=4080"},
    {"Q", "LD X0, WAND D0 D1 D2, WOR D0 D1 D3, WXOR D0 D1 D4, WXNR D0 D1 D5", "X0=1 D0=3855 D1=255",
     "D2=15 D3=4095 D4=4080 D5=-4081", Dialect::Q},
    {"Wide", "LD X0, DWAND D0 D2 D4, DWOR D0 D2 D6, DWXOR D0 D2 D8",
     "X0=1 D0=3855 D1=-1 D2=255 D3=1", "D4=15 D5=1 D6=4095 D7=-1 D8=4080 D9=-2"},
};
INSTANTIATE_TEST_SUITE_P(Logic, ReferenceStory, testing::ValuesIn(kLogic), story_name);

constexpr Story kWordShifts[] = {
    {"Wsfl", "LD X0, WSFLP D10 D0 K3 K1", "X0=1 D10=9 D0=1 D1=2 D2=3", "D0=9 D1=1 D2=2"},
    {"Wsfr", "LD X0, WSFRP D10 D0 K3 K2", "X0=1 D10=8 D11=9 D0=1 D1=2 D2=3", "D0=3 D1=8 D2=9"},
    {"Dsfl", "LD X0, DSFLP D0 K3", "X0=1 D0=1 D1=2 D2=3", "D0=0 D1=1 D2=2", Dialect::Q},
    {"Dsfr", "LD X0, DSFRP D0 K3", "X0=1 D0=1 D1=2 D2=3", "D0=2 D1=3 D2=0", Dialect::Q},
};
INSTANTIATE_TEST_SUITE_P(WordShifts, ReferenceStory, testing::ValuesIn(kWordShifts), story_name);

constexpr Story kComparisons[] = {
    {"Cmp", "LD X0, CMP D0 D1 M0", "X0=1 D0=2 D1=-3 | D0=-3 | D0=-32768 | X0=0 D0=5",
     "M0=1 M1=0 M2=0 | M0=0 M1=1 M2=0 | M0=0 M1=0 M2=1 |"},
    {"Dcmp", "LD X0, DCMP D0 K65536 M0", "X0=1 D0=-1 | D0=0 D1=1 | D1=-1",
     "M0=0 M1=0 M2=1 | M0=0 M1=1 M2=0 | M0=0 M1=0 M2=1"},
    {"Zcp", "LD X0, ZCP K-5 K5 D0 M0", "X0=1 D0=-6 | D0=-5 | D0=5 | D0=6",
     "M0=1 M1=0 M2=0 | M0=0 M1=1 M2=0 | M0=0 M1=1 M2=0 | M0=0 M1=0 M2=1"},
    // Below the low bound and above the high one, as the bounds are the wrong way round.
    {"ZcpBoundsReversed", "LD X0, ZCP K5 K-5 D0 M0", "X0=1", "M0=1 M1=0 M2=1"},
    {"Zrst", "LD X0, ZRST M0 M2, ZRST D5 D6, ZRST D9 D8", "X0=1 D5=7",
     "M0=0 M1=0 M2=0 D5=0 D6=0 D9=0"},
    {"ZrstOfTimersAndCounters", "LD X0, ZRST T0 T1, ZRST C199 C199, ZRST C200 C201",
     "X0=1 TN0=5 TS1=1 CN199=3 CS199=1 CN200:h=1 CN201=4",
     "TN0=0 TS1=0 CN199=0 CS199=0 CN200:h=0 CN201=0"},
};
INSTANTIATE_TEST_SUITE_P(Comparisons, ReferenceStory, testing::ValuesIn(kComparisons), story_name);

}  // namespace
}  // namespace rung
