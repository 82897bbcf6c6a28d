// SPDX-License-Identifier: Apache-2.0
// Traces of LDmicro's own simulator: reading them, and comparing them with ours.
#include <gtest/gtest.h>

#include "programs/random_source.hpp"
#include "reference/run.hpp"
#include "reference_ldmicro_story.hpp"
#include "trace/ldmicro_trace.hpp"

namespace rung {
namespace {

struct ReadTrace {
  std::optional<LdmicroTrace> trace;
  std::string messages;
};

ReadTrace read(std::string_view text) {
  Diagnostics diagnostics;
  ReadTrace result;
  result.trace = read_ldmicro_trace(text, "t", diagnostics);
  result.messages = printed(diagnostics);
  return result;
}

TEST(LdTrace, ALineIsAScan) {
  const ReadTrace result = read("0: Xa=1 v=-7 TX=65\r\n\n1:\n2: Xa=0 TX=0 w=3 TX=255\n");
  EXPECT_EQ(result.messages, "");
  ASSERT_TRUE(result.trace);
  ASSERT_EQ(result.trace->scans.size(), 3U);
  const TraceScan& first = result.trace->scans[0];
  EXPECT_EQ(*first.state, (std::vector<TraceValue>{{"Xa", 1}, {"v", -7}}));
  EXPECT_EQ(first.tx, std::vector<int>{65});
  EXPECT_TRUE(result.trace->scans[1].state->empty());
  EXPECT_EQ(result.trace->scans[2].line, 4);
  EXPECT_EQ(result.trace->scans[2].tx, (std::vector<int>{0, 255}));
  EXPECT_FALSE(result.trace->stop);
}

TEST(LdTrace, EndsWhereTheSimulatorStopped) {
  const ReadTrace halt = read("0: a=1\n1: a=2 DIVZERO_HALT\nERROR: Division by zero\n");
  EXPECT_EQ(halt.messages, "");
  ASSERT_TRUE(halt.trace && halt.trace->stop);
  EXPECT_EQ(halt.trace->scans.size(), 1U);
  EXPECT_EQ(halt.trace->stop->line, 2);
  EXPECT_EQ(halt.trace->stop->what, "a division by zero");
  const ReadTrace refused = read("ERROR: Timer period too short \r\nINTCODE FAILED\n");
  ASSERT_TRUE(refused.trace && refused.trace->stop);
  EXPECT_TRUE(refused.trace->scans.empty());
  EXPECT_EQ(refused.trace->stop->line, 1);
  EXPECT_EQ(refused.trace->stop->what, "ERROR: Timer period too short");
}

TEST(LdTrace, SaysWhatIsWrong) {
  struct Row {
    const char* text;
    const char* message;
  };
  constexpr Row kRows[] = {
      {"", "t:1:1: error: this is no trace: it is empty\n"},
      {"\n \n", "t:1:1: error: this is no trace: it is empty\n"},
      {"Xa=1",
       "t:1:1: error: Xa=1 is no number of a scan; a line is `0: NAME=value ... TX=byte`\n"},
      {":", "t:1:1: error: : is no number of a scan; a line is `0: NAME=value ... TX=byte`\n"},
      {"0: a=1\n2: a=1", "t:2:1: error: it holds scan 2 where scan 1 should be\n"},
      {"0: a=32768", "t:1:1: error: a=32768 is no name with a value from -32768 to 32767\n"},
      {"0: TX=256", "t:1:1: error: TX=256 is no name with a value from 0 to 255\n"},
      {"0: a", "t:1:1: error: a is no name with a value from -32768 to 32767\n"},
      {"0: =1", "t:1:1: error: =1 is no name with a value from -32768 to 32767\n"},
      {"0: a=", "t:1:1: error: a= is no name with a value from -32768 to 32767\n"},
      {"0: a=1 DIVZERO_HALT\n1: a=1",
       "t:2:1: error: a scan behind the place where the simulator stopped\n"},
  };
  for (const Row& row : kRows) {
    const ReadTrace result = read(row.text);
    EXPECT_FALSE(result.trace) << row.text;
    EXPECT_EQ(result.messages, row.message) << row.text;
  }
}

TEST(LdTrace, IsToldFromOurs) {
  EXPECT_TRUE(is_ldmicro_trace("0: a=1"));
  EXPECT_TRUE(is_ldmicro_trace("\r\n  0:"));
  EXPECT_TRUE(is_ldmicro_trace("ERROR: x"));
  EXPECT_TRUE(is_ldmicro_trace("INTCODE FAILED"));
  EXPECT_FALSE(is_ldmicro_trace(R"({"rung_trace":1})"));
  EXPECT_FALSE(is_ldmicro_trace(""));
  EXPECT_FALSE(is_ldmicro_trace("\n"));
}

// One scan of a program against one line; the difference, or nothing.
std::string compared(const std::string& line) {
  const Program program = ld_program(
      "CONTACTS Xa 0, COIL Yo 0 0 0; ADD v v 1; CONTACTS n 0, MOVE n 9, OPEN, ADD w w 1;"
      "UART_SEND v");
  ReferenceRun run(program, true);
  const ReadTrace trace = read("0: " + line);
  EXPECT_TRUE(trace.trace) << trace.messages;
  const auto difference = compare_shown(trace.trace->scans.at(0), run.scan({}));
  return difference ? describe(*difference) : "";
}

TEST(LdTrace, ComparedWithOurs) {
  EXPECT_EQ(compared("Xa=0 Yo=0 v=1 w=0 TX=1"), "");
  // A name that is not there is 0; one that is a bit and a variable is left out.
  EXPECT_EQ(compared("v=1 n=4 TX=1"), "");
  EXPECT_EQ(compared("TX=1"), "scan 0: state of v: expected 0, got 1");
  EXPECT_EQ(compared("v=1 Yo=1 TX=1"), "scan 0: state of Yo: expected 1, got 0");
  EXPECT_EQ(compared("v=1 q=0 TX=1"), "scan 0: state of q: expected 0, got nothing");
  EXPECT_EQ(compared("v=1"), "scan 0: bytes sent: expected [], got [1]");
  EXPECT_EQ(compared("v=1 TX=2"), "scan 0: bytes sent: expected [2], got [1]");
}

// Whatever stands there: refused with an error or accepted without, and equal to itself.
TEST(LdTrace, TruncatedAndChanged) {
  const std::string whole =
      "0: Xa=1 v=-32768 n:w=7 TX=65\r\n1: Xa=0 TX=0 DIVZERO_HALT\nERROR: it has stopped\n";
  static constexpr const char* kPieces[] = {"=", " ", ":", "\n", "TX=", "-", "0", "ERROR:", "\xFF"};
  RandomSource random(6);
  int accepted = 0;
  for (int round = 0; round < 5000; ++round) {
    std::string changed = whole.substr(0, random.bits() % (whole.size() + 1));
    for (int i = random.below(3); i > 0 && !changed.empty(); --i) {
      changed.insert(random.bits() % changed.size(), kPieces[random.bits() % std::size(kPieces)]);
    }
    static_cast<void>(is_ldmicro_trace(changed));
    const ReadTrace result = read(changed);
    ASSERT_NE(result.trace.has_value(), !result.messages.empty()) << changed;
    if (!result.trace) continue;
    ++accepted;
    for (const TraceScan& scan : result.trace->scans) ASSERT_FALSE(compare_shown(scan, scan));
  }
  EXPECT_GT(accepted, 100);
}

}  // namespace
}  // namespace rung
