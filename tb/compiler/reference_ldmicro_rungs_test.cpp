// SPDX-License-Identifier: Apache-2.0
// The reference on LDmicro programs: contacts, coils, branches, edges, the master relay.
#include "reference_ldmicro_story.hpp"

namespace rung {
namespace {

constexpr LdStory kCoils[] = {
    {"Contact", "CONTACTS Xa 0, COIL Yo 0 0 0", "Xa=1 | Xa=0", "Yo=1 | Yo=0"},
    {"Negated", "CONTACTS Xa 1, COIL Yo 1 0 0", "Xa=1 | Xa=0", "Yo=1 | Yo=0"},
    {"SetReset", "CONTACTS Xa 0, COIL Yo 0 1 0; CONTACTS Xb 0, COIL Yo 0 0 1",
     "Xa=1 | Xa=0 | Xb=1 | Xb=0", "Yo=1 | | Yo=0 |"},
    {"NegatedBeforeSet", "CONTACTS Xa 0, COIL Yo 1 1 1", "Xa=1 | Xa=0", "Yo=0 | Yo=1"},
    {"SetBeforeReset", "CONTACTS Xa 0, COIL Yo 0 1 1", "Xa=1 | Xa=0", "Yo=1 |"},
    {"CoilLeavesTheCondition", "CONTACTS Xa 0, COIL Ra 1 0 0, CONTACTS Ra 1, COIL Yo 0 0 0",
     "Xa=1 | Xa=0", "Ra=0 Yo=1 | Ra=1 Yo=0"},
    {"ShortAndOpen", "SHORT, COIL Ya 0 0 0, OPEN, COIL Yb 0 0 0", "|", "Ya=1 Yb=0 | Ya=1 Yb=0"},
    {"CommentDoesNothing", "COMMENT one; COIL Yo 0 0 0", "|", "Yo=1 | Yo=1"},
    {"ARungBeginsAnew", "OPEN; COIL Yo 0 0 0", "|", "Yo=1 | Yo=1"},
    // One name that is both: the bit follows Xa, the variable counts.
    {"BitAndVariable", "CONTACTS Xa 0, COIL n 0 0 0; CONTACTS n 0, ADD n n 1", "Xa=1 | n=7 | Xa=0",
     "n=1 n:w=1 | n=1 n:w=8 | n=0"},
};
INSTANTIATE_TEST_SUITE_P(Coils, LdReferenceStory, testing::ValuesIn(kCoils), ld_story_name);

constexpr LdStory kBranches[] = {
    {"EitherBranch", "PARALLEL, CONTACTS Xa 0, CONTACTS Xb 0, END, COIL Yo 0 0 0",
     "Xb=1 | Xb=0 | Xa=1", "Yo=1 | Yo=0 | Yo=1"},
    {"ConditionGoesIntoAll",
     "CONTACTS Xa 0, PARALLEL, COIL Y1 0 0 0, COIL Y2 1 0 0, END, COIL Y3 0 0 0", "Xa=1 | Xa=0",
     "Y1=1 Y2=0 Y3=1 | Y1=0 Y2=1 Y3=0"},
    {"LowerSeesUpper",
     "PARALLEL, SERIES, CONTACTS Xa 0, COIL Ra 0 0 0, OPEN, END, CONTACTS Ra 0, END, COIL Yo 0 0 0",
     "Xa=1 | Xa=0", "Ra=1 Yo=1 | Ra=0 Yo=0"},
    {"UpperDoesNotSeeLower",
     "PARALLEL, CONTACTS Ra 0, SERIES, CONTACTS Xa 0, COIL Ra 0 0 0, OPEN, END, END, COIL Yo 0 0 0",
     "Xa=1 | Xa=0 |", "Ra=1 Yo=0 | Ra=0 Yo=1 | Ra=0 Yo=0"},
    {"Nested",
     "PARALLEL, SERIES, CONTACTS Xa 0, PARALLEL, CONTACTS Xb 0, CONTACTS Xc 0, END, END, "
     "CONTACTS Xd 0, END, COIL Yo 0 0 0",
     "Xa=1 | Xc=1 | Xa=0 | Xd=1 | Xd=0 Xa=1 Xb=1 Xc=0", "Yo=0 | Yo=1 | Yo=0 | Yo=1 | Yo=1"},
    {"ExecutedWithoutCondition", "OPEN, PARALLEL, TON T 40000, TOF U 40000, END, COIL Yo 0 0 0",
     "T=2 | U=1", "T=0 U=3 Yo=0 | U=2 Yo=1"},
};
INSTANTIATE_TEST_SUITE_P(Branches, LdReferenceStory, testing::ValuesIn(kBranches), ld_story_name);

constexpr LdStory kEdges[] = {
    {"Osr", "CONTACTS Xa 0, OSR, COIL Yo 0 0 0", "Xa=1 | | Xa=0 | Xa=1",
     "Yo=1 | Yo=0 | Yo=0 | Yo=1"},
    {"Osf", "CONTACTS Xa 0, OSF, COIL Yo 0 0 0", "Xa=1 | | Xa=0 |", "Yo=0 | Yo=0 | Yo=1 | Yo=0"},
    // The second one's condition is the pulse of the first one.
    {"OneMemoryEach", "CONTACTS Xa 0, OSR, OSF, COIL Yo 0 0 0", "Xa=1 | | ", "Yo=0 | Yo=1 | Yo=0"},
};
INSTANTIATE_TEST_SUITE_P(Edges, LdReferenceStory, testing::ValuesIn(kEdges), ld_story_name);

constexpr LdStory kMasterRelay[] = {
    {"OnAndOff",
     "CONTACTS Xa 0, MASTER_RELAY; COIL Y1 0 0 0; CONTACTS Xb 0, MASTER_RELAY; COIL Y2 0 0 0",
     "| Xa=1 | Xb=1", "Y1=0 Y2=1 | Y1=1 Y2=0 | Y1=1 Y2=1"},
    {"OnWhenAScanBegins", "COIL Y0 0 0 0; OPEN, MASTER_RELAY; COIL Y1 0 0 0", "|",
     "Y0=1 Y1=0 | Y0=1 Y1=0"},
    {"LeavesTheCondition", "CONTACTS Xa 0, MASTER_RELAY, COIL Y0 0 0 0; COIL Y1 0 0 0", "| Xa=1",
     "Y0=0 Y1=0 | Y0=1 Y1=1"},
    // It counts for the rungs behind, not for the one in which it stands.
    {"BehindItsRung", "PARALLEL, SERIES, OPEN, MASTER_RELAY, END, SHORT, END, COIL Y0 0 0 0", "|",
     "Y0=1 | Y0=1"},
};
INSTANTIATE_TEST_SUITE_P(MasterRelay, LdReferenceStory, testing::ValuesIn(kMasterRelay),
                         ld_story_name);

}  // namespace
}  // namespace rung
