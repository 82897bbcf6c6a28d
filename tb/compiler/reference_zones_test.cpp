// SPDX-License-Identifier: Apache-2.0
// The reference: the zones of MC and STL.
#include "reference_story.hpp"

namespace rung {
namespace {

constexpr Story kMasters[] = {
    {"Zone", "LD X0, MC N0 M100, LD X1, OUT Y0, SET M1, MCR N0, LD X1, OUT Y1",
     "X1=1 | X0=1 | X0=0", "M100=0 Y0=0 Y1=1 | M100=1 Y0=1 M1=1 Y1=1 | M100=0 Y0=0 Y1=1"},
    {"Nested",
     "LD X0, MC N0 M100, LD X1, MC N1 M101, LD X2, OUT Y0, MCR N1, LD X2, OUT Y1, MCR N0, LD X2,"
     "OUT Y2",
     "X0=1 X2=1 | X1=1 | X0=0",
     "M100=1 M101=0 Y0=0 Y1=1 Y2=1 | M100=1 M101=1 Y0=1 Y1=1 Y2=1 |"
     "M100=0 M101=0 Y0=0 Y1=0 Y2=1"},
    {"NothingIsExecutedWithoutPower",
     "LD X0, MC N0 M100, LD X1, MOV K1 D0, RST M5, INC D1, ADD D0 K0 D3, MCR N0", "X1=1 | X0=1",
     "M100=0 | M100=1 D0=1 M5=0 D1=1 D3=1"},
    {"InvertedCoilAndInv", "LD X0, MC N0 M100, LD X1, OUTI Y0, INV, OUT Y1, MCR N0", "| X0=1",
     "M100=0 Y0=0 Y1=0 | M100=1 Y0=1 Y1=1"},
    {"PulsesSeePower", "LD X0, MC N0 M100, LD X1, PLS M0, INCP D0, MCR N0",
     "X0=1 X1=1 | | X0=0 | X0=1",
     "M100=1 M0=1 D0=1 | M100=1 M0=0 | M100=0 M0=0 | M100=1 M0=1 D0=2"},
    {"FallingPulsesSeePower", "LD X0, MC N0 M100, LD X1, PLF M0, MCR N0", "X0=1 X1=1 | X0=0 |",
     "M100=1 M0=0 | M100=0 M0=1 | M100=0 M0=0"},
    {"ContactsDoNot", "LD X0, MC N0 M100, LDP X1, SET M1, MCR N0", "X1=1 | X0=1",
     "M100=0 | M100=1"},
    {"MepSeesPower", "LD X0, MC N0 M100, LD X1, MEP, OUT Y0, MCR N0", "X1=1 | X0=1 |",
     "M100=0 Y0=0 | M100=1 Y0=1 | M100=1 Y0=0", Dialect::Q},
    {"Timers", "LD X0, MC N0 M100, LD X1, OUT T200 K9, OUT T246 K900, MCR N0", "X0=1 X1=1 | | X0=0",
     "M100=1 | M100=1 TN200=1 TN246=10 | M100=0 TN200=0"},
    // The counter sees its coil go off and on again.
    {"Counters", "LD X0, MC N0 M100, LD X1, OUT C0 K9, MCR N0", "X0=1 X1=1 | X0=0 | X0=1",
     "M100=1 CN0=1 | M100=0 | M100=1 CN0=2"},
    {"ResetHoldsNoLonger", "LD X0, MC N0 M100, LD X1, RST C0, MCR N0, LD X2, OUT C0 K9",
     "X0=1 X1=1 X2=1 | X2=0 X0=0 | X2=1", "M100=1 | M100=0 | M100=0 CN0=1"},
    {"BranchesBehindMc", "LD X0, MC N0 M100, LD X1, MPS, AND X2, OUT Y0, MPP, OUT Y1, MCR N0",
     "X0=1 X1=1 | X0=0", "M100=1 Y0=0 Y1=1 | M100=0 Y0=0 Y1=0"},
};
INSTANTIATE_TEST_SUITE_P(Masters, ReferenceStory, testing::ValuesIn(kMasters), story_name);

constexpr Story kSteps[] = {
    // Both states are on for one scan; then the zone of the one that was left runs without power.
    {"Transitions",
     "LD M8002, SET S0, STL S0, OUT Y0, LD X0, SET S20, STL S20, OUT Y1, LD X1, SET S0, RET",
     "| X0=1 | X0=0 | | X1=1 | X1=0",
     "S0=1 Y0=1 | Y0=1 S20=1 Y1=1 | S0=0 Y0=0 Y1=1 | Y1=1 | Y1=1 S0=1 | Y0=1 S20=0 Y1=0"},
    {"Join", "STL S20, STL S21, LD X0, SET S22, STL S22, OUT Y0, RET", "S20=1 X0=1 | S21=1 | |",
     "| S22=1 Y0=1 | S20=0 S21=0 Y0=1 | Y0=1"},
    {"Fork", "STL S20, LD X0, SET S21, SET S22, STL S21, OUT Y1, STL S22, OUT Y2, RET",
     "S20=1 X0=1 | |", "S21=1 S22=1 Y1=1 Y2=1 | S20=0 Y1=1 Y2=1 | Y1=1 Y2=1"},
    // S20 has a zone of its own and is one of two in the join.
    {"ZoneAndJoinOfTheSameState",
     "STL S20, OUT Y0, STL S21, OUT Y1, STL S20, STL S21, LD X0, SET S22, STL S22, OUT Y2, RET",
     "S20=1 S21=1 | X0=1 | |",
     "Y0=1 Y1=1 | Y0=1 Y1=1 S22=1 Y2=1 | S20=0 Y0=0 S21=0 Y1=0 Y2=1 | Y2=1"},
    {"TransitionByOut", "STL S20, LD X0, OUT S21, STL S21, OUT Y0, RET", "S20=1 | X0=1 | |",
     "| S21=1 Y0=1 | S20=0 Y0=1 | Y0=1"},
    {"ResetOfAState", "STL S20, OUT Y0, RET, LD X0, RST S20", "S20=1 | X0=1 | X0=0 |",
     "Y0=1 | Y0=1 S20=0 | Y0=0 |"},
    {"StateOutsideOfZonesIsARelay", "LD X0, OUT S5, LD S5, OUT Y0", "X0=1 | X0=0",
     "S5=1 Y0=1 | S5=0 Y0=0"},
    {"TimerOfAState", "STL S20, OUT T200 K9, LD X0, SET S21, RET",
     "S20=1 | | X0=1 | X0=0 | S20=1 |", "| TN200=1 | TN200=2 S21=1 | S20=0 TN200=0 | | TN200=1"},
    // Without power nothing but coils: no SET, no MOV; edges are kept.
    {"PassWithoutPower", "STL S20, SET M0, MOVP K1 D0, PLS M1, RET, LD X0, RST S20",
     "S20=1 | X0=1 | X0=0 S20=0 | S20=1",
     "M0=1 D0=1 M1=1 | M0=1 M1=0 S20=0 | M1=0 | M0=1 D0=1 M1=1"},
    // X1 went on while the state was off and its contacts were skipped.
    {"EdgesOfAnInactiveState", "STL S20, LDP X1, OUT Y0, RET", "X1=1 | S20=1 |", "| Y0=1 | Y0=0"},
    {"PowerReturnsBehindRet", "STL S20, OUT Y0, RET, LD X0, OUT Y1", "X0=1", "Y1=1"},
};
INSTANTIATE_TEST_SUITE_P(Steps, ReferenceStory, testing::ValuesIn(kSteps), story_name);

}  // namespace
}  // namespace rung
