// SPDX-License-Identifier: Apache-2.0
// The reference on LDmicro programs: timers, which count scans of 10 ms, and counters.
#include "reference_ldmicro_story.hpp"

namespace rung {
namespace {

constexpr LdStory kTimers[] = {
    // 40 ms are 4 scans: on in the fourth.
    {"Ton", "CONTACTS Xa 0, TON T 40000, COIL Yo 0 0 0", "Xa=1 | | | | | Xa=0",
     "T=1 Yo=0 | T=2 Yo=0 | T=3 Yo=0 | Yo=1 | Yo=1 | T=0 Yo=0"},
    {"TonRoundsDown", "CONTACTS Xa 0, TON T 29999, COIL Yo 0 0 0", "Xa=1 | |",
     "T=1 Yo=0 | Yo=1 | Yo=1"},
    {"TonBeyond", "CONTACTS Xa 0, TON T 40000, COIL Yo 0 0 0", "Xa=1 T=99 | T=2 | | Xa=0",
     "Yo=1 | T=3 Yo=0 | Yo=1 | T=0 Yo=0"},
    {"TonStartsAnew", "CONTACTS Xa 0, TON T 40000, COIL Yo 0 0 0", "Xa=1 | | Xa=0 | Xa=1 |",
     "T=1 Yo=0 | T=2 Yo=0 | T=0 Yo=0 | T=1 Yo=0 | T=2 Yo=0"},
    {"Tof", "CONTACTS Xa 0, TOF T 40000, COIL Yo 0 0 0", "| Xa=1 | Xa=0 | | | |",
     "T=3 Yo=0 | T=0 Yo=1 | T=1 Yo=1 | T=2 Yo=1 | T=3 Yo=1 | Yo=0 | Yo=0"},
    {"TofOnAtTheStart", "CONTACTS Xa 0, TOF T 30000, COIL Yo 0 0 0", "Xa=1 | Xa=0 | |",
     "Yo=1 | T=1 Yo=1 | T=2 Yo=1 | Yo=0"},
    {"TofNegative", "CONTACTS Xa 0, TOF T 30000, COIL Yo 0 0 0", "| T=-1 |",
     "T=2 Yo=0 | T=0 Yo=1 | T=1 Yo=1"},
    {"Rto", "CONTACTS Xa 0, RTO T 30000, COIL Yo 0 0 0; CONTACTS Xr 0, RES T",
     "Xa=1 | Xa=0 | Xa=1 | Xa=0 | Xr=1 | Xr=0",
     "T=1 Yo=0 | Yo=0 | T=2 Yo=0 | Yo=1 | Yo=1 T=0 | Yo=0"},
    {"ResLeavesTheCondition", "CONTACTS Xa 0, RES v, COIL Yo 0 0 0", "v=4 | Xa=1 |",
     "Yo=0 | v=0 Yo=1 | Yo=1"},
};
INSTANTIATE_TEST_SUITE_P(Timers, LdReferenceStory, testing::ValuesIn(kTimers), ld_story_name);

constexpr LdStory kCounters[] = {
    {"Ctu", "CONTACTS Xa 0, CTU C 2, COIL Yo 0 0 0", "Xa=1 | | Xa=0 | Xa=1 | Xa=0 | Xa=1",
     "C=1 Yo=0 | Yo=0 | Yo=0 | C=2 Yo=1 | Yo=1 | C=3 Yo=1"},
    {"CtuWraps", "CONTACTS Xa 0, CTU C 2, COIL Yo 0 0 0", "C=32767 | Xa=1", "Yo=1 | C=-32768 Yo=0"},
    {"Ctd", "CONTACTS Xa 0, CTD C 0, COIL Yo 0 0 0", "| Xa=1 | Xa=0 C=-32768 | Xa=1",
     "Yo=1 | C=-1 Yo=0 | Yo=0 | C=32767 Yo=1"},
    {"Ctc", "CONTACTS Xa 0, CTC C 2, COIL Yo 0 0 0", "Xa=1 | Xa=0 | Xa=1 | Xa=0 | Xa=1 | Xa=0",
     "C=1 Yo=1 | Yo=0 | C=2 Yo=1 | Yo=0 | C=0 Yo=1 | Yo=0"},
    {"CtcOnlyAtAnEdge", "CONTACTS Xa 0, CTC C 2, COIL Yo 0 0 0",
     "C=9 | Xa=1 | C=9 | Xa=0 C=-4 | Xa=1", "Yo=0 | C=0 Yo=1 | Yo=1 | Yo=0 | C=-3 Yo=1"},
    // 32767 + 1 is below everything: it never counts.
    {"CtcToTheEnd", "CONTACTS Xa 0, CTC C 32767, COIL Yo 0 0 0", "Xa=1 | C=5 Xa=0 | Xa=1",
     "Yo=1 | Yo=0 | C=0 Yo=1"},
};
INSTANTIATE_TEST_SUITE_P(Counters, LdReferenceStory, testing::ValuesIn(kCounters), ld_story_name);

}  // namespace
}  // namespace rung
