// SPDX-License-Identifier: Apache-2.0
// The reference: edges, compare contacts and what changes a result.
#include "reference_story.hpp"

namespace rung {
namespace {

constexpr Story kEdges[] = {
    {"Ldp", "LDP X0, OUT Y0", "X0=1 | | X0=0 | X0=1", "Y0=1 | Y0=0 | Y0=0 | Y0=1"},
    {"Ldf", "LDF X0, OUT Y0", "X0=1 | X0=0 | | X0=1", "Y0=0 | Y0=1 | Y0=0 | Y0=0"},
    // X1 goes on while X0 is off: that edge is past when X0 comes.
    {"AndpSeesEdgesWithoutPower", "LD X0, ANDP X1, OUT Y0", "X1=1 | X0=1 | X1=0 | X1=1",
     "Y0=0 | Y0=0 | Y0=0 | Y0=1"},
    {"Andf", "LD X0, ANDF X1, OUT Y0", "X0=1 X1=1 | X1=0 |", "Y0=0 | Y0=1 | Y0=0"},
    {"Orp", "LD X0, ORP X1, OUT Y0", "X1=1 | | X0=1", "Y0=1 | Y0=0 | Y0=1"},
    {"Orf", "LD X0, ORF X1, OUT Y0", "X1=1 | X1=0 |", "Y0=0 | Y0=1 | Y0=0"},
    {"EachContactHasItsOwnMemory", "LDP X0, OUT Y0, LDP X0, OUT Y1", "X0=1 |",
     "Y0=1 Y1=1 | Y0=0 Y1=0"},
    {"OfARelayThatChangesTwice", "LD X0, OUT M0, LDP M0, OUT Y0, LDI X0, OUT M0", "X0=1 | |",
     "M0=1 Y0=1 M0=0 | M0=1 Y0=0 M0=0 | M0=1 Y0=0 M0=0"},
    {"FirstScan", "LDP M8002, OUT Y0, LDF M8002, OUT Y1", "| |",
     "Y0=1 Y1=0 | Y0=0 Y1=1 | Y0=0 Y1=0"},
};
INSTANTIATE_TEST_SUITE_P(Edges, ReferenceStory, testing::ValuesIn(kEdges), story_name);

constexpr Story kCompares[] = {
    {"Signed",
     "LD= D0 D1, OUT Y0, LD<> D0 D1, OUT Y1, LD< D0 D1, OUT Y2, LD> D0 D1, OUT Y3,"
     "LD<= D0 D1, OUT Y4, LD>= D0 D1, OUT Y5",
     "D0=-32768 D1=32767 | D1=-32768 | D0=-32767",
     "Y0=0 Y1=1 Y2=1 Y3=0 Y4=1 Y5=0 | Y0=1 Y1=0 Y2=0 Y3=0 Y4=1 Y5=1 |"
     "Y0=0 Y1=1 Y2=0 Y3=1 Y4=0 Y5=1"},
    // -65536 and 65536
    {"Signed32", "LDD< D0 D2, OUT Y0, LDD= D0 K-65536, OUT Y1", "D1=-1 | D1=1",
     "Y0=1 Y1=1 | Y0=0 Y1=0"},
    {"Corners32", "LDD< D0 D2, OUT Y0, LDD> D0 D2, OUT Y1", "D1=-32768 D2=-1 D3=32767",
     "Y0=1 Y1=0"},
    {"InSeriesAndParallel", "LD X0, AND= D0 K5, OR> D0 K6, OUT Y0",
     "X0=1 D0=5 | D0=6 | D0=7 | X0=0 D0=5", "Y0=1 | Y0=0 | Y0=1 | Y0=0"},
    {"OfDigits", "LD= K1X0 K10, OUT Y0", "X1=1 X3=1 | X0=1", "Y0=1 | Y0=0"},
    // K4 fills a word: its highest bit is the sign. K3 is positive.
    {"SignOfDigits", "LD< K4M0 K0, OUT Y0, LD< K3M4 K0, OUT Y1", "M15=1", "Y0=1 Y1=0"},
};
INSTANTIATE_TEST_SUITE_P(Compares, ReferenceStory, testing::ValuesIn(kCompares), story_name);

constexpr Story kResults[] = {
    {"Inv", "LD X0, AND X1, INV, OUT Y0", "X0=1 | X1=1", "Y0=1 | Y0=0"},
    {"Mep", "LD X0, AND X1, MEP, OUT Y0", "X0=1 X1=1 | | X1=0 | X1=1", "Y0=1 | Y0=0 | Y0=0 | Y0=1",
     Dialect::Q},
    {"Mef", "LD X0, AND X1, MEF, OUT Y0", "X0=1 X1=1 | | X1=0 | X1=1", "Y0=0 | Y0=0 | Y0=1 | Y0=0",
     Dialect::Q},
    {"BitsOfAWord", "LD D0.F, OUT Y0, LDI D0.0, OUT Y1, LD D0.3, OUT Y2", "D0=-32768 | D0=1 | D0=8",
     "Y0=1 Y1=1 Y2=0 | Y0=0 Y1=0 Y2=0 | Y0=0 Y1=1 Y2=1"},
};
INSTANTIATE_TEST_SUITE_P(Results, ReferenceStory, testing::ValuesIn(kResults), story_name);

// t = 0, 25, 50 ... ms: floor(2t/p) mod 2
constexpr Story kSpecials[] = {
    {"Fx", "LD M8000, OUT Y0, LD M8001, OUT Y1, LD M8002, OUT Y2, LD M8003, OUT Y3", "|",
     "Y0=1 Y1=0 Y2=1 Y3=0 | Y0=1 Y1=0 Y2=0 Y3=1"},
    {"Q", "LD SM400, OUT Y0, LD SM401, OUT Y1, LD SM402, OUT Y2, LD SM403, OUT Y3", "|",
     "Y0=1 Y1=0 Y2=1 Y3=0 | Y0=1 Y1=0 Y2=0 Y3=1", Dialect::Q},
    {"Clock100ms", "LD M8012, OUT Y0", "| | | | | |",
     "Y0=0 | Y0=0 | Y0=1 | Y0=1 | Y0=0 | Y0=0 | Y0=1", Dialect::Fx, 25000},
    {"Clocks", "LD M8011, OUT Y0, LD M8013, OUT Y1, LD M8014, OUT Y2", "| | | |",
     "Y0=0 Y1=0 Y2=0 | Y0=1 Y1=1 Y2=0 | Y0=0 Y1=0 Y2=1 | Y0=1 Y1=1 Y2=1 | Y0=0 Y1=0 Y2=0",
     Dialect::Fx, 15'505'000},
    {"ClocksOfQ",
     "LD SM409, OUT Y0, LD SM410, OUT Y1, LD SM411, OUT Y2, LD SM412, OUT Y3,"
     "LD SM413, OUT Y4",
     "| |", "Y0=0 Y1=0 Y2=0 Y3=0 Y4=0 | Y0=0 Y1=1 Y2=1 Y3=1 Y4=0 | Y0=0 Y1=0 Y2=1 Y3=0 Y4=1",
     Dialect::Q, 550'000},
    // What a program is given cannot hold what the controller drives.
    {"DrivenAgainEachScan", "LD M8002, OUT Y0", "| M8002=1", "Y0=1 | Y0=0"},
};
INSTANTIATE_TEST_SUITE_P(Specials, ReferenceStory, testing::ValuesIn(kSpecials), story_name);

}  // namespace
}  // namespace rung
