// SPDX-License-Identifier: Apache-2.0
// The reference: jumps, subroutines and loops.
#include "reference_story.hpp"

namespace rung {
namespace {

constexpr Story kJumps[] = {
    {"Cj", "LD X0, CJ P1, LD X1, OUT Y0, P1, LD X1, OUT Y1", "X1=1 | X0=1 X1=0 | X0=0",
     "Y0=1 Y1=1 | Y1=0 | Y0=0 Y1=0"},
    {"CjpOnce", "LD X0, CJP P1, LD X1, OUT Y0, P1, LD X1, OUT Y1", "X0=1 |", "Y1=0 | Y0=0 Y1=0"},
    // What passes while the timer is skipped is lost; then it goes on.
    {"TimersAreFrozen", "LD X0, CJ P1, LD X1, OUT T200 K9, P1, LD X1, OUT Y0",
     "X1=1 | | X0=1 | | X0=0", "Y0=1 | TN200=1 Y0=1 | Y0=1 | Y0=1 | TN200=2 Y0=1"},
    {"EdgesAreFrozen", "LD X0, CJ P1, LDP X1, OUT Y0, P1, LD X2, OUT Y1", "X0=1 | X1=1 | X0=0 |",
     "Y1=0 | Y1=0 | Y0=1 Y1=0 | Y0=0 Y1=0"},
    {"P63IsTheEnd", "LD X0, CJ P63, LD X1, OUT Y0", "X1=1 | X0=1 X1=0", "Y0=1 |"},
    {"Fend", "LD X0, OUT Y0, FEND, P1, LD X0, OUT Y1, SRET", "X0=1", "Y0=1"},
};
INSTANTIATE_TEST_SUITE_P(Jumps, ReferenceStory, testing::ValuesIn(kJumps), story_name);

constexpr Story kCalls[] = {
    {"Call", "LD X0, CALL P1, LD X1, OUT Y0, FEND, P1, LD X2, OUT Y1, SRET",
     "X1=1 X2=1 | X0=1 | X0=0 X2=0", "Y0=1 | Y1=1 Y0=1 | Y0=1"},
    {"TheCallerKeepsItsResult", "LD X0, CALL P1, OUT Y0, FEND, P1, LD X2, OUT Y1, SRET", "X0=1",
     "Y1=0 Y0=1"},
    {"TheCallerKeepsItsBranches",
     "LD X0, MPS, AND X1, CALL P1, MPP, OUT Y0, FEND, P1, LD X2, MPS, AND X3, OUT Y1, MPP, OUT Y2,"
     "SRET",
     "X0=1 X1=1 X2=1", "Y1=0 Y2=1 Y0=1"},
    {"Callp", "LD X0, CALLP P1, FEND, P1, LD M8000, INC D0, SRET", "X0=1 | | X0=0 | X0=1",
     "D0=1 | | | D0=2"},
    {"Nested",
     "LD X0, CALL P1, LD X0, OUT Y0, FEND, P1, LD X1, CALL P2, LD X1, OUT Y1, SRET, P2, LD X2,"
     "OUT Y2, SRET",
     "X0=1 X1=1", "Y2=0 Y1=1 Y0=1"},
    // The second call finds the edge used up.
    {"EdgesBelongToTheInstruction",
     "LD X0, CALL P1, CALL P1, FEND, P1, LDP X1, OUT Y0, LD X1, INCP D0, SRET", "X0=1 X1=1 |",
     "Y0=1 D0=1 Y0=0 | Y0=0 Y0=0"},
    {"ZonesOfItsOwn",
     "LD X0, MC N0 M100, LD X0, CALL P1, LD X1, OUT Y0, MCR N0, FEND, P1, LD X2, MC N0 M101,"
     "LD X1, OUT Y1, MCR N0, SRET",
     "X0=1 X1=1", "M100=1 M101=0 Y1=0 Y0=1"},
};
INSTANTIATE_TEST_SUITE_P(Calls, ReferenceStory, testing::ValuesIn(kCalls), story_name);

constexpr Story kLoops[] = {
    {"For", "FOR K3, LD X0, INC D0, NEXT, LD X0, OUT Y0", "X0=1 | X0=0",
     "D0=1 D0=2 D0=3 Y0=1 | Y0=0"},
    {"Nested", "FOR K2, LD X0, INC D0, FOR K2, LD X0, INC D1, NEXT, NEXT", "X0=1",
     "D0=1 D1=1 D1=2 D0=2 D1=3 D1=4"},
    {"EdgesBelongToTheInstruction", "FOR K3, LDP X0, INC D0, LD X0, INCP D1, NEXT", "X0=1 |",
     "D0=1 D1=1 |"},
    {"TicksAreUsedOnce", "FOR K3, LD X0, OUT T200 K9, NEXT", "X0=1 | |", "| TN200=1 | TN200=2"},
    {"JumpWithin", "FOR K2, LD X0, CJ P1, LD X0, INC D0, P1, LD M8000, INC D1, NEXT", "X0=1",
     "D1=1 D1=2"},
    {"CallWithin", "FOR K2, LD X0, CALL P1, NEXT, FEND, P1, FOR K2, LD X0, INC D0, NEXT, SRET",
     "X0=1", "D0=1 D0=2 D0=3 D0=4"},
};
INSTANTIATE_TEST_SUITE_P(Loops, ReferenceStory, testing::ValuesIn(kLoops), story_name);

}  // namespace
}  // namespace rung
