// SPDX-License-Identifier: Apache-2.0
// The reference on LDmicro programs: variables, comparisons, tables and shift registers.
#include "reference_ldmicro_story.hpp"

namespace rung {
namespace {

constexpr const char* kSixRelations =
    "EQU a b, COIL Y1 0 0 0; NEQ a b, COIL Y2 0 0 0; GRT a b, COIL Y3 0 0 0;"
    "GEQ a b, COIL Y4 0 0 0; LES a b, COIL Y5 0 0 0; LEQ a b, COIL Y6 0 0 0";

constexpr LdStory kCompares[] = {
    {"SignedNumbers", kSixRelations, "a=-3 b=2 | a=2 | a=3",
     "Y1=0 Y2=1 Y3=0 Y4=0 Y5=1 Y6=1 | Y1=1 Y2=0 Y3=0 Y4=1 Y5=0 Y6=1 |"
     "Y1=0 Y2=1 Y3=1 Y4=1 Y5=0 Y6=0"},
    {"OnlyWithTheCondition", "CONTACTS Xa 0, EQU a 5, COIL Yo 0 0 0", "a=5 | Xa=1", "Yo=0 | Yo=1"},
};
INSTANTIATE_TEST_SUITE_P(Compares, LdReferenceStory, testing::ValuesIn(kCompares), ld_story_name);

constexpr LdStory kArithmetic[] = {
    {"Move", "CONTACTS Xa 0, MOVE v -7, COIL Yo 0 0 0", "Xa=1 | | Xa=0 v=3",
     "v=-7 Yo=1 | v=-7 Yo=1 | Yo=0"},
    {"MoveVariable", "MOVE v w", "w=9 |", "v=9 | v=9"},
    {"AddWraps", "ADD v a 1", "a=32767 | a=-1", "v=-32768 | v=0"},
    {"SubWraps", "SUB v a b", "a=-32768 b=1 | a=3", "v=32767 | v=2"},
    {"MulWraps", "MUL v a b", "a=300 b=300 | a=-2 b=7", "v=24464 | v=-14"},
    {"DivRoundsTowardsZero", "DIV v a b", "a=-7 b=2 | a=7 b=-2 | a=-32768 b=-1",
     "v=-3 | v=-3 | v=-32768"},
    {"DivByZero", "CONTACTS Xa 0, DIV v a b, COIL Yo 0 0 0", "v=8 a=7 | Xa=1 | b=7",
     "Yo=0 | Yo=1 ERROR | v=1 Yo=1"},
    {"SourceIsTarget", "ADD v v v", "v=3 |", "v=6 | v=12"},
};
INSTANTIATE_TEST_SUITE_P(Arithmetic, LdReferenceStory, testing::ValuesIn(kArithmetic),
                         ld_story_name);

constexpr LdStory kShiftRegisters[] = {
    {"WhenTheConditionGoesOn", "CONTACTS Xa 0, SHIFT_REGISTER r 3, COIL Yo 0 0 0",
     "r0=5 r1=1 r2=2 | Xa=1 | | Xa=0 r0=6 | Xa=1",
     "Yo=0 | r2=1 r1=5 Yo=1 | Yo=1 | Yo=0 | r2=5 r1=6 Yo=1"},
    {"OneStage", "CONTACTS Xa 0, SHIFT_REGISTER r 1, COIL Yo 0 0 0", "Xa=1 r0=4 |", "Yo=1 | Yo=1"},
};
INSTANTIATE_TEST_SUITE_P(ShiftRegisters, LdReferenceStory, testing::ValuesIn(kShiftRegisters),
                         ld_story_name);

constexpr LdStory kTables[] = {
    {"LookUp", "CONTACTS Xa 0, LOOK_UP_TABLE d i 3 0 10 20 -30, COIL Yo 0 0 0",
     "| Xa=1 | i=2 | i=3 | i=-1 | i=1", "Yo=0 | d=10 Yo=1 | d=-30 Yo=1 | Yo=1 | Yo=1 | d=20 Yo=1"},
    {"LookUpIndexIsTarget", "LOOK_UP_TABLE i i 3 0 1 2 7", "| i=1 | i=2", "i=7 | i=7 | i=7"},
    {"LookUpBackwards", "LOOK_UP_TABLE i i 3 0 9 0 1", "i=1 | i=2", "i=0 | i=1"},
    // (0,0) (10,100) (20,50): up by 10 each, then down by 5 each
    {"Segments", "PIECEWISE_LINEAR d i 3 0 0 10 100 20 50",
     "i=5 | i=10 | i=13 | i=20 | i=21 | i=-1 | i=0", "d=50 | d=100 | d=85 | d=50 | | d=-10 | d=0"},
    {"SegmentsRoundTowardsZero", "PIECEWISE_LINEAR d i 2 0 0 3 10", "i=1 | i=2 | i=-1",
     "d=3 | d=6 | d=-3"},
    // -200 * 300 is 5536 in 16 bits
    {"ProductWraps", "PIECEWISE_LINEAR d i 2 0 0 100 300", "i=-200", "d=55"},
    // The upper segment makes 20 of it, which the lower one does not hold.
    {"SegmentsIndexIsTarget", "PIECEWISE_LINEAR i i 3 0 0 10 20 30 25", "i=8 | i=4", "i=20 | i=19"},
    // 32767 + 1 is below everything.
    {"LastPointAtTheEnd", "PIECEWISE_LINEAR d i 2 32000 5 32767 5", "i=32500", ""},
    {"OnePoint", "PIECEWISE_LINEAR d i 1 0 7", "i=0", ""},
    {"OnlyWithTheCondition", "CONTACTS Xa 0, PIECEWISE_LINEAR d i 2 0 0 10 20, COIL Yo 0 0 0",
     "i=4 | Xa=1", "Yo=0 | d=8 Yo=1"},
};
INSTANTIATE_TEST_SUITE_P(Tables, LdReferenceStory, testing::ValuesIn(kTables), ld_story_name);

}  // namespace
}  // namespace rung
