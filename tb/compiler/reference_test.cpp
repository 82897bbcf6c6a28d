// SPDX-License-Identifier: Apache-2.0
// The reference interpreter against results worked out by hand.
#include "reference/reference.hpp"

#include <gtest/gtest.h>

#include "reference/run.hpp"
#include "rungs/devices.hpp"
#include "support.hpp"

namespace rung {
namespace {

Device device(std::string_view name, Dialect dialect = Dialect::Fx) {
  return *parse_device_name(name, dialect);
}

// The writes of the scan, as "M0=1 D0=7".
std::string writes(const Reference& reference, const Program& program) {
  std::string text;
  for (const ReferenceWrite& write : reference.writes()) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ",
                        device_name(write.device, program.dialect), write.value);
  }
  return text;
}

// One row: devices before the scan, the program, the writes it makes.
struct Scan {
  const char* name;
  const char* before;  // "X0=1 D0=7"
  const char* text;    // without END
  const char* writes;
  bool error = false;
};

class ReferenceScan : public testing::TestWithParam<Scan> {};

TEST_P(ReferenceScan, Writes) {
  const Program program = good_program(std::string(GetParam().text) + "\nEND");
  ASSERT_FALSE(program.instructions.empty());
  Reference reference(program);
  std::istringstream before(GetParam().before);
  for (std::string token; before >> token;) {
    const std::size_t equals = token.find('=');
    reference.set(device(token.substr(0, equals), program.dialect),
                  static_cast<std::int16_t>(std::stoi(token.substr(equals + 1))));
  }
  reference.run_scan();
  EXPECT_EQ(writes(reference, program), GetParam().writes);
  EXPECT_EQ(reference.error(), GetParam().error);
}

constexpr Scan kContacts[] = {
    {"Ld0", "", "LD X0\nOUT Y0", "Y0=0"},
    {"Ld1", "X0=1", "LD X0\nOUT Y0", "Y0=1"},
    {"Ldi0", "", "LDI X0\nOUT Y0", "Y0=1"},
    {"Ldi1", "X0=1", "LDI X0\nOUT Y0", "Y0=0"},
    {"And", "X0=1 X1=1", "LD X0\nAND X1\nOUT Y0\nLD X0\nAND X2\nOUT Y1", "Y0=1 Y1=0"},
    {"Ani", "X0=1 X1=1", "LD X0\nANI X1\nOUT Y0\nLD X0\nANI X2\nOUT Y1", "Y0=0 Y1=1"},
    {"Or", "X1=1", "LD X0\nOR X1\nOUT Y0\nLD X0\nOR X2\nOUT Y1", "Y0=1 Y1=0"},
    {"Ori", "X1=1", "LD X0\nORI X1\nOUT Y0\nLD X0\nORI X2\nOUT Y1", "Y0=0 Y1=1"},
    {"NotPrecedenceButOrder", "X2=1", "LD X0\nAND X1\nOR X2\nANI X2\nOR X0\nORI X0\nOUT Y0",
     "Y0=1"},
    {"AnOutputIsSeenAtOnce", "X0=1", "LD X0\nOUT M0\nLD M0\nOUT Y0\nLDI X0\nOUT M0\nLD M0\nOUT Y1",
     "M0=1 Y0=1 M0=0 Y1=0"},
    {"ContinuesAfterAnOutput", "X0=1 X1=1", "LD X0\nOUT Y0\nAND X1\nOUT Y1\nANI X1\nOUT Y2",
     "Y0=1 Y1=1 Y2=0"},
    {"NopKeepsTheResult", "X0=1", "LD X0\nNOP\nOUT Y0", "Y0=1"},
};

constexpr Scan kBlocks[] = {
    // (X0 or X1) and (X2 or X3)
    {"Anb", "X1=1 X2=1", "LD X0\nOR X1\nLD X2\nOR X3\nANB\nOUT Y0", "Y0=1"},
    {"AnbFalse", "X1=1", "LD X0\nOR X1\nLD X2\nOR X3\nANB\nOUT Y0", "Y0=0"},
    // (X0 and X1) or (X2 and X3)
    {"Orb", "X2=1 X3=1", "LD X0\nAND X1\nLD X2\nAND X3\nORB\nOUT Y0", "Y0=1"},
    {"OrbFalse", "X1=1 X2=1", "LD X0\nAND X1\nLD X2\nAND X3\nORB\nOUT Y0", "Y0=0"},
    // X0 or (X1 and X2): the newest blocks are joined first
    {"NewestFirst", "X0=1", "LD X0\nLD X1\nLD X2\nANB\nORB\nOUT Y0", "Y0=1"},
    {"NewestFirstOther", "X0=1", "LD X0\nLD X1\nLD X2\nORB\nANB\nOUT Y0", "Y0=0"},
    // X0 into three branches with X1, X2 and without
    {"Branches", "X0=1 X2=1",
     "LD X0\nMPS\nAND X1\nOUT Y0\nMRD\nAND X2\nOUT Y1\nMPP\nOUT Y2\nLD X1\nOUT Y3",
     "Y0=0 Y1=1 Y2=1 Y3=0"},
    {"BranchesWithinBranches", "X0=1 X1=1 X3=1",
     "LD X0\nMPS\nAND X1\nMPS\nAND X2\nOUT Y0\nMPP\nAND X3\nOUT Y1\nMPP\nANI X1\nOUT Y2",
     "Y0=0 Y1=1 Y2=0"},
    {"BlockBehindABranch", "X0=1 X2=1", "LD X0\nMPS\nLD X1\nOR X2\nANB\nOUT Y0\nMPP\nOUT Y1",
     "Y0=1 Y1=1"},
    // X0 stays of the branch, though an output with another result lies between
    {"BranchAfterSet", "X0=1", "LD X0\nMPS\nANI X0\nSET Y0\nMPP\nSET Y1", "Y1=1"},
};

constexpr Scan kCoils[] = {
    {"SetWhenOn", "X0=1", "LD X0\nSET M0\nRST M1", "M0=1 M1=0"},
    {"SetWhenOff", "M1=1", "LD X0\nSET M0\nRST M1\nLD M1\nOUT Y0", "Y0=1"},
    {"ResetOfAWord", "X0=1 D3=77", "LD X0\nRST D3", "D3=0"},
    {"ResetOfAWordOff", "D3=77", "LD X0\nRST D3\nLDI X0\nMOV D3 D4", "D4=77"},
};

constexpr Scan kWords[] = {
    {"Mov", "X0=1 D0=-5", "LD X0\nMOV D0 D1\nMOV K-32768 D2\nMOV H8001 D3",
     "D1=-5 D2=-32768 D3=-32767"},
    {"NotExecuted", "D0=3",
     "LD X0\nMOV D0 D1\nADD D0 D0 D0\nSUB D0 D0 D0\nMUL D0 D0 D0\nDIV D0 K0 D0", ""},
    {"AddWraps", "X0=1 D0=32767", "LD X0\nADD D0 K1 D1\nADD K-1 D1 D1", "D1=-32768 D1=32767"},
    {"SubWraps", "X0=1 D0=-32768", "LD X0\nSUB D0 K1 D1\nSUB K0 D0 D2", "D1=32767 D2=-32768"},
    {"SubOrder", "X0=1", "LD X0\nSUB K10 K3 D0", "D0=7"},
    // 300 * 300 = 90000 = 1 * 65536 + 24464
    {"MulTwoWords", "X0=1 D0=300", "LD X0\nMUL D0 D0 D2", "D2=24464 D3=1"},
    {"MulNegative", "X0=1", "LD X0\nMUL K-1 K1 D2", "D2=-1 D3=-1"},
    // 2^30 = 16384 * 65536
    {"MulLargest", "X0=1", "LD X0\nMUL K-32768 K-32768 D2", "D2=0 D3=16384"},
    // -32768 * 32767 = -1073709056 = -16384 * 65536 + 32768
    {"MulSmallest", "X0=1", "LD X0\nMUL K-32768 K32767 D2", "D2=-32768 D3=-16384"},
    {"DivTowardsZero", "X0=1", "LD X0\nDIV K7 K2 D0\nDIV K-7 K2 D2\nDIV K7 K-2 D4\nDIV K-7 K-2 D6",
     "D0=3 D1=1 D2=-3 D3=-1 D4=-3 D5=1 D6=3 D7=-1"},
    {"DivOverflow", "X0=1", "LD X0\nDIV K-32768 K-1 D0", "D0=-32768 D1=0"},
    {"DivByZero", "X0=1 D0=9 D1=8", "LD X0\nDIV K5 D9 D0\nMOV D0 D2", "D2=9", true},
    {"DivByZeroOff", "D0=9", "LD X0\nDIV K5 D9 D0\nLDI X0\nOUT Y0", "Y0=1", false},
    // Sources are read first: 7 / 2 with the divisor in the remainder's place.
    {"TargetsAreSources", "X0=1 D0=7 D1=2", "LD X0\nDIV D0 D1 D0", "D0=3 D1=1"},
    {"TargetsAreSourcesOfMul", "X0=1 D0=300 D1=300", "LD X0\nMUL D1 D0 D0", "D0=24464 D1=1"},
};

constexpr Scan kDialects[] = {
    {"PaperTwoOperands", "X0=1 D0=10 D1=3",
     "LD X0\nMV D0 D5\nADD D1 D5\nSUB D1 D5\nMUL D1 D5\nDIV D1 D5",
     "D5=10 D5=13 D5=10 D5=30 D5=10"},
    {"PaperWritesOneWord", "X0=1", "LD X0\nMV K300 D0\nMUL D0 D0 D2\nDIV D0 K7 D2",
     "D0=300 D2=24464 D2=42"},
    {"QTwoOperands", "X0=1 D0=10", "LD X0\n+ K1 D0\n- K2 D0\n* K3 D0\n/ K4 D0",
     "D0=11 D0=9 D0=27 D1=0 D0=6 D1=3"},
};

std::string scan_name(const testing::TestParamInfo<Scan>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Contacts, ReferenceScan, testing::ValuesIn(kContacts), scan_name);
INSTANTIATE_TEST_SUITE_P(Blocks, ReferenceScan, testing::ValuesIn(kBlocks), scan_name);
INSTANTIATE_TEST_SUITE_P(Coils, ReferenceScan, testing::ValuesIn(kCoils), scan_name);
INSTANTIATE_TEST_SUITE_P(Words, ReferenceScan, testing::ValuesIn(kWords), scan_name);
INSTANTIATE_TEST_SUITE_P(Dialects, ReferenceScan, testing::ValuesIn(kDialects), scan_name);

TEST(Reference, HoldsItsDevicesFromScanToScan) {
  // The paper's Figure 1: X0 starts, X1 stops, D0 counts the scans in between.
  const Program program = good_program("LD X0\nOR M0\nANI X1\nOUT M0\nLD M0\nADD K1 D0\nEND");
  Reference reference(program);
  EXPECT_EQ(reference.get(device("M0")), 0);
  reference.set(device("X0"), 1);
  reference.run_scan();
  reference.set(device("X0"), 0);
  reference.run_scan();
  reference.run_scan();
  EXPECT_EQ(reference.get(device("D0")), 3);
  reference.set(device("X1"), 1);
  reference.run_scan();
  EXPECT_EQ(writes(reference, program), "M0=0");
  EXPECT_EQ(reference.get(device("D0")), 3);
}

TEST(Reference, StepsOverOneInstructionAtATime) {
  const Program program = good_program("LD X0\nOUT Y0\nLDI X0\nMUL K300 K300 D0\nOUT Y1\nEND");
  Reference reference(program);
  reference.begin_scan();
  std::vector<std::size_t> order;
  std::vector<bool> results;
  for (std::size_t at = reference.next_instruction(); reference.step();
       at = reference.next_instruction()) {
    order.push_back(at);
    results.push_back(reference.result());
  }
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(results, (std::vector<bool>{false, false, true, true, true}));
  std::vector<std::size_t> sources;
  for (const ReferenceWrite& write : reference.writes()) sources.push_back(write.instruction);
  EXPECT_EQ(sources, (std::vector<std::size_t>{1, 3, 3, 4}));
}

TEST(Reference, ErrorIsOfOneScan) {
  const Program program = good_program("LD X0\nDIV K1 K0 D0\nEND");
  Reference reference(program);
  reference.set(device("X0"), 1);
  reference.run_scan();
  EXPECT_TRUE(reference.error());
  reference.set(device("X0"), 0);
  reference.run_scan();
  EXPECT_FALSE(reference.error());
}

TEST(Reference, SetsBitsToZeroOrOne) {
  const Program program = good_program("LD X0\nOUT Y0\nEND");
  Reference reference(program);
  reference.set(device("X0"), 5);
  EXPECT_EQ(reference.get(device("X0")), 1);
  reference.set(device("D0"), 5);
  EXPECT_EQ(reference.get(device("D0")), 5);
}

TEST(ReferenceRun, GivesTheTraceOfInterfaces) {
  const Program program = good_program("LD X0\nOUT Y10\nMOV D0 D1\nLDI X0\nOUT M0\nEND");
  ReferenceRun run(program, true);
  EXPECT_EQ(to_json(run.header()),
            R"({"rung_trace":1,"program":"t","dialect":"fx","tick_ms":10,"mpu":0})");
  const auto scan = [&](std::vector<StimulusEvent> events) { return to_json(run.scan(events)); };
  EXPECT_EQ(scan({}), R"({"scan":0,"clocks":null,"in":{},"writes":[["Y10",0],["M0",1]],"out":{},)"
                      R"("state":{"X0":0,"Y10":0,"M0":1,"D0":0,"D1":0}})");
  EXPECT_EQ(scan({{device("X0"), 1}, {device("D0"), -7}}),
            R"({"scan":1,"clocks":null,"in":{"X0":1,"D0":-7},)"
            R"("writes":[["Y10",1],["D1",-7],["M0",0]],"out":{"Y10":1},)"
            R"("state":{"X0":1,"Y10":1,"M0":0,"D0":-7,"D1":-7}})");
  // What does not change is not listed; a preset is, in every scan in which it occurs.
  EXPECT_EQ(scan({{device("X0"), 1}, {device("D0"), -7}}),
            R"({"scan":2,"clocks":null,"in":{"D0":-7},)"
            R"("writes":[["Y10",1],["D1",-7],["M0",0]],"out":{},)"
            R"("state":{"X0":1,"Y10":1,"M0":0,"D0":-7,"D1":-7}})");
}

TEST(ReferenceRun, HasTheTimeAndAllNamedDevices) {
  const Program program =
      good_program("LD M8002\nOUT T200 K1\nLD X0\nDADD C200 K-1 D0\nLD M8022\nSET S3\nEND");
  ReferenceRun run(program, true, 7300);
  EXPECT_EQ(to_json(run.header()),
            R"({"rung_trace":1,"program":"t","dialect":"fx","tick_ms":7.3,"mpu":0})");
  EXPECT_EQ(
      to_json(run.scan(std::vector<StimulusEvent>{{device("X0"), 1}, {device("CN200:h"), 2}})),
      R"({"scan":0,"clocks":null,"in":{"X0":1,"CN200:h":2},)"
      R"("writes":[["D0",-1],["D1",1]],"out":{},)"
      R"("state":{"X0":1,"M8002":1,"M8022":0,"S3":0,"TS200":0,"D0":-1,"D1":1,)"
      R"("TN200":0,"CN200":0,"CN200:h":2}})");
}

// What no list may name, but a caller may ask for.
TEST(Reference, HasNothingBeyondItsMemory) {
  const Program program = good_program("LD X0\nOUT Y0\nEND");
  Reference reference(program);
  reference.set({DeviceKind::D, 0xFFFFFFFF}, 5);
  EXPECT_EQ(reference.get({DeviceKind::D, 0xFFFFFFFF}), 0);
  EXPECT_EQ(reference.get({DeviceKind::SW, 4711}), 0);
}

}  // namespace
}  // namespace rung
