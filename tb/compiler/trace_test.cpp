// SPDX-License-Identifier: Apache-2.0
// Traces: written, read back, refused, compared.
#include "trace/trace.hpp"

#include <gtest/gtest.h>

#include "support.hpp"
#include "trace/compare.hpp"
#include "trace/recorder.hpp"

namespace rung {
namespace {

constexpr const char* kHeader =
    R"({"rung_trace":1,"program":"x.il","dialect":"fx","tick_ms":10,"mpu":3})";

TEST(Trace, ComesBackAsItWasWritten) {
  Trace trace;
  trace.header = {"x \"y\".il", "fx", 2500, 3};
  TraceScan scan;
  scan.clocks = 123;
  scan.in = {{"X0", 1}, {"A1", 1023}};
  scan.rx = {66};
  scan.writes = {{"M0", 1}, {"D0", -7}, {"M0", 0}};
  scan.out = {{"Y1", 1}};
  scan.state = std::vector<TraceValue>{{"X0", 1}, {"D0", -7}};
  scan.tx = {72, 105};
  trace.scans.push_back(scan);
  TraceScan plain;
  plain.scan = 1;
  trace.scans.push_back(plain);

  const std::string text = to_json_lines(trace);
  EXPECT_EQ(text, R"({"rung_trace":1,"program":"x \"y\".il","dialect":"fx","tick_ms":2.5,"mpu":3})"
                  "\n"
                  R"({"scan":0,"clocks":123,"in":{"X0":1,"A1":1023,"RX":[66]},)"
                  R"("writes":[["M0",1],["D0",-7],["M0",0]],"out":{"Y1":1},)"
                  R"("state":{"X0":1,"D0":-7},"tx":[72,105]})"
                  "\n"
                  R"({"scan":1,"clocks":null,"in":{},"writes":[],"out":{}})"
                  "\n");
  Diagnostics diagnostics;
  const auto read = read_trace(text, "t", diagnostics);
  EXPECT_EQ(printed(diagnostics), "");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->header, trace.header);
  EXPECT_EQ(to_json_lines(*read), text);
  EXPECT_EQ(read->scans[1].line, 3);
}

TEST(Trace, ReadsWhatItDoesNotKnow) {
  Diagnostics diagnostics;
  const auto trace = read_trace(
      "\xEF\xBB\xBF{\"later\":true,\"mpu\":0,\"tick_ms\":0.001,\"dialect\":\"q\",\"program\":\"p\","
      "\"rung_trace\":1}\r\n\r\n"
      R"({"scan":0,"in":{},"writes":[],"out":{},"more":[1,2]})",
      "t", diagnostics);
  EXPECT_EQ(printed(diagnostics), "");
  ASSERT_TRUE(trace);
  EXPECT_EQ(trace->header.tick_us, 1);
  EXPECT_EQ(trace->scans.size(), 1U);
  EXPECT_FALSE(trace->scans[0].clocks);
}

struct BadTrace {
  const char* name;
  std::string text;
  const char* message;
};

class RefusedTrace : public testing::TestWithParam<BadTrace> {};

TEST_P(RefusedTrace, SaysLineAndReason) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_trace(GetParam().text, "t", diagnostics));
  EXPECT_EQ(printed(diagnostics), GetParam().message);
}

std::string after_header(const char* line) { return std::string(kHeader) + "\n" + line; }

const BadTrace kBad[] = {
    {"Empty", "", "t:1:1: error: this is no trace: it is empty\n"},
    {"OnlyBlankLines", "\n \n", "t:1:1: error: this is no trace: it is empty\n"},
    {"NotJson", "LD X0\n", "t:1:1: error: not JSON at its character 1\n"},
    {"NotAnObject", "[1]", "t:1:1: error: not a JSON object\n"},
    {"NoHeader", R"({"scan":0})",
     "t:1:1: error: this is no trace: its first line has no \"rung_trace\"\n"},
    {"OtherVersion", R"({"rung_trace":2})",
     "t:1:1: error: this trace has another version than 1\n"},
    {"NoProgram", R"({"rung_trace":1})", "t:1:1: error: it has no \"program\"\n"},
    {"BadTick", R"({"rung_trace":1,"program":"","dialect":"","tick_ms":-1,"mpu":1})",
     "t:1:1: error: \"tick_ms\" is out of range\n"},
    {"BadMpu", R"({"rung_trace":1,"program":"","dialect":"","tick_ms":1,"mpu":5})",
     "t:1:1: error: \"mpu\" is not between 0 and 4\n"},
    {"CutOff", after_header(R"({"scan":0,"clocks":nul)"),
     "t:2:1: error: not JSON at its character 23\n"},
    {"NoScan", after_header("{}"), "t:2:1: error: it has no \"scan\"\n"},
    {"ScanMissing", after_header(R"({"scan":1,"in":{},"writes":[],"out":{}})"),
     "t:2:1: error: it holds scan 1 where scan 0 should be\n"},
    {"BadClocks", after_header(R"({"scan":0,"clocks":-1,"in":{},"writes":[],"out":{}})"),
     "t:2:1: error: \"clocks\" is not between 0 and 9223372036854775807\n"},
    {"BadIn", after_header(R"({"scan":0,"in":[],"writes":[],"out":{}})"),
     "t:2:1: error: \"in\" is not an object\n"},
    {"BadRx", after_header(R"({"scan":0,"in":{"RX":[256]},"writes":[],"out":{}})"),
     "t:2:1: error: a byte of \"RX\" is not between 0 and 255\n"},
    {"BadValue", after_header(R"({"scan":0,"in":{},"writes":[],"out":{"Y0":0.5}})"),
     "t:2:1: error: the value of Y0 is not an integer\n"},
    {"HugeValue",
     after_header(R"({"scan":0,"in":{},"writes":[["D0",99999999999999999999]],"out":{}})"),
     "t:2:1: error: the value of D0 is not an integer\n"},
    {"LargeValue",
     after_header(R"({"scan":0,"in":{},"writes":[["D0",18446744073709551615]],"out":{}})"),
     "t:2:1: error: the value of D0 is not between -2147483648 and 2147483647\n"},
    {"NoName", after_header(R"({"scan":0,"in":{},"writes":[["",1]],"out":{}})"),
     "t:2:1: error: a device has an empty name\n"},
    {"BadWrite", after_header(R"({"scan":0,"in":{},"writes":[["D0"]],"out":{}})"),
     "t:2:1: error: a write is not a pair of device and value\n"},
    {"BadWrites", after_header(R"({"scan":0,"in":{},"writes":{},"out":{}})"),
     "t:2:1: error: \"writes\" is not a list\n"},
    {"BadTx", after_header(R"({"scan":0,"in":{},"writes":[],"out":{},"tx":7})"),
     "t:2:1: error: \"tx\" is not a list of bytes\n"},
    {"DeepNesting", std::string(100000, '['), "t:1:1: error: not JSON at its character 100001\n"},
};
INSTANTIATE_TEST_SUITE_P(Traces, RefusedTrace, testing::ValuesIn(kBad),
                         [](const auto& info) { return std::string(info.param.name); });

TraceScan scan_of(std::vector<TraceValue> writes) {
  TraceScan scan;
  scan.writes = std::move(writes);
  return scan;
}

std::string first_difference(const std::vector<TraceScan>& expected,
                             const std::vector<TraceScan>& got, bool clocks = true) {
  TraceComparison comparison(clocks);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (const auto found = comparison.next(expected[i], got[i])) return describe(*found);
  }
  return "";
}

TEST(TraceComparison, OrderCountsForOneDeviceOnly) {
  EXPECT_EQ(first_difference({scan_of({{"M0", 1}, {"M1", 1}, {"M0", 0}})},
                             {scan_of({{"M1", 1}, {"M0", 1}, {"M0", 0}})}),
            "");
  EXPECT_EQ(first_difference({scan_of({{"D0", 1}, {"M1", 1}, {"D0", 2}})},
                             {scan_of({{"M1", 1}, {"D0", 2}, {"D0", 1}})}),
            "scan 0: write of D0: expected 1, got 2");
}

TEST(TraceComparison, WritesThatChangeNothingDoNotCount) {
  EXPECT_EQ(first_difference({scan_of({{"M0", 0}, {"M1", 1}, {"M1", 1}}), scan_of({{"M1", 1}})},
                             {scan_of({{"M1", 1}}), scan_of({})}),
            "");
  // Nor do those that write what a preset had put there.
  TraceScan preset = scan_of({{"D0", 7}});
  preset.in = {{"D0", 7}};
  TraceScan silent = preset;
  silent.writes.clear();
  EXPECT_EQ(first_difference({preset}, {silent}), "");
}

TEST(TraceComparison, ShowsTheFirstDifference) {
  EXPECT_EQ(first_difference({scan_of({{"M0", 1}}), scan_of({{"M0", 0}})},
                             {scan_of({{"M0", 1}}), scan_of({})}),
            "scan 0: write of M0: expected 0, got nothing");
  EXPECT_EQ(first_difference({scan_of({})}, {scan_of({{"M5", 1}})}),
            "scan 0: write of M5: expected nothing, got 1");
  TraceScan a;
  TraceScan b;
  a.in = {{"X0", 1}};
  EXPECT_EQ(first_difference({a}, {b}), "scan 0: input X0: expected 1, got 0");
  b.in = a.in;
  a.out = {{"Y0", 1}};
  EXPECT_EQ(first_difference({a}, {b}), "scan 0: output Y0: expected 1, got 0");
  b.out = a.out;
  a.state = {{"X0", 1}, {"D1", 3}};
  EXPECT_EQ(first_difference({a}, {b}), "") << "only one side has a state";
  b.state = {{"D1", 4}, {"X0", 1}};
  EXPECT_EQ(first_difference({a}, {b}), "scan 0: state of D1: expected 3, got 4");
  b.state = {{"D1", 3}, {"X0", 1}, {"D2", 0}};
  EXPECT_EQ(first_difference({a}, {b}), "scan 0: state of D2: expected nothing, got 0");
  b.state = {{"D1", 3}};
  EXPECT_EQ(first_difference({a}, {b}), "scan 0: state of X0: expected 1, got nothing");
  b.state = a.state;
  a.tx = {1, 2};
  EXPECT_EQ(first_difference({a}, {b}), "scan 0: bytes sent: expected [1 2], got []");
  b.tx = a.tx;
  b.rx = {9};
  EXPECT_EQ(first_difference({a}, {b}), "scan 0: bytes received: expected [], got [9]");
  b.rx.clear();
  a.clocks = 5;
  EXPECT_EQ(first_difference({a}, {b}), "") << "only one side has clocks";
  b.clocks = 6;
  EXPECT_EQ(first_difference({a}, {b}), "scan 0: clocks: expected 5, got 6");
  EXPECT_EQ(first_difference({a}, {b}, false), "");
}

TEST(TraceComparison, AnUnchangedOutputThatIsListedIsNoDifference) {
  TraceScan on;
  on.out = {{"Y0", 1}};
  TraceScan quiet;
  EXPECT_EQ(first_difference({on, on}, {on, quiet}), "");
  TraceScan zero;
  zero.out = {{"Y1", 0}};
  EXPECT_EQ(first_difference({zero}, {quiet}), "");
}

TEST(TraceComparison, WholeTraces) {
  Trace reference{{"p", "fx", 10000, 0}, {scan_of({{"M0", 1}})}};
  Trace mpu = reference;
  mpu.header.mpu = 3;
  mpu.scans[0].clocks = 7;
  EXPECT_FALSE(compare_traces(reference, mpu));
  Trace other = mpu;
  other.scans[0].clocks = 8;
  ASSERT_TRUE(compare_traces(mpu, other));
  EXPECT_EQ(compare_traces(mpu, other)->aspect, TraceAspect::Clocks);
  other.header.mpu = 2;
  EXPECT_FALSE(compare_traces(mpu, other)) << "clocks of different processors";
  other.scans.clear();
  ASSERT_TRUE(compare_traces(mpu, other));
  EXPECT_EQ(describe(*compare_traces(mpu, other)),
            "scan 0: end of the trace: expected 1 scans, got 0 scans");
}

TEST(TraceComparison, MergedTracesAreComparedByTheEndsOfScans) {
  Trace all{{"p", "fx", 10000, 0}, {scan_of({{"M0", 1}, {"M0", 0}, {"M1", 1}})}};
  Trace merged{{"p", "fx", 10000, 4}, {scan_of({{"M1", 1}, {"M0", 0}})}};
  ASSERT_TRUE(compare_traces(all, merged));
  merged.header.slots = 8;
  merged.header.merged = true;
  EXPECT_FALSE(compare_traces(all, merged));
  EXPECT_FALSE(compare_traces(merged, all));
  Trace wrong = merged;
  wrong.scans[0].writes[1].value = 1;
  ASSERT_TRUE(compare_traces(all, wrong));
  EXPECT_EQ(compare_traces(all, wrong)->device, "M0");
  // Clocks: of as many slots and the same way to compile only.
  Trace slower = merged;
  merged.scans[0].clocks = 7;
  slower.scans[0].clocks = 8;
  EXPECT_TRUE(compare_traces(merged, slower));
  slower.header.slots = 4;
  EXPECT_FALSE(compare_traces(merged, slower));
  // And the header says it in the file.
  Diagnostics diagnostics;
  const auto back = read_trace(to_json_lines(merged), "t", diagnostics);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->header, merged.header);
  for (const char* wrong_header :
       {R"({"rung_trace":1,"program":"p","dialect":"fx","tick_ms":10,"mpu":4,"slots":"8"})",
        R"({"rung_trace":1,"program":"p","dialect":"fx","tick_ms":10,"mpu":4,"merged":1})",
        R"({"rung_trace":1,"program":"p","dialect":"fx","tick_ms":10,"mpu":5})"}) {
    EXPECT_FALSE(read_trace(std::string(wrong_header) + "\n", "t", diagnostics)) << wrong_header;
  }
}

TEST(TraceRecorder, ListsWhatChanged) {
  TraceRecorder recorder(false);
  recorder.input("X0", 0);
  recorder.input("X1", 1);
  recorder.output("Y0", 1);
  recorder.state("Y0", 1);
  recorder.received(65);
  recorder.sent(66);
  EXPECT_EQ(
      to_json(recorder.finish(9)),
      R"({"scan":0,"clocks":9,"in":{"X1":1,"RX":[65]},"writes":[],"out":{"Y0":1},"tx":[66]})");
  recorder.input("X1", 1);
  recorder.output("Y0", 0);
  recorder.write("Y0", 0);
  EXPECT_EQ(to_json(recorder.finish(std::nullopt)),
            R"({"scan":1,"clocks":null,"in":{},"writes":[["Y0",0]],"out":{"Y0":0}})");
}

}  // namespace
}  // namespace rung
