// SPDX-License-Identifier: Apache-2.0
// Stimulus files and the stimulus that a golden trace holds.
#include "trace/stimulus.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace rung {
namespace {

struct StimulusResult {
  std::optional<Stimulus> stimulus;
  std::string messages;
};

StimulusResult read(std::string_view text, Dialect dialect = Dialect::Fx) {
  Diagnostics diagnostics;
  StimulusResult result;
  if (const auto source = decode_text(text, "s", diagnostics)) {
    result.stimulus = parse_stimulus(*source, dialect, diagnostics);
  }
  result.messages = printed(diagnostics);
  return result;
}

// The events of each scan: " X0=1 D5=7 | | M0=1 ".
std::string dump(const Stimulus& stimulus, Dialect dialect = Dialect::Fx) {
  std::string text;
  for (std::uint64_t scan = 0; scan < stimulus.scans(); ++scan) {
    if (scan > 0) text += '|';
    for (const StimulusEvent& event : stimulus.events(scan)) {
      text += fmt::format(" {}={}", device_name(event.device, dialect), event.value);
    }
    text += ' ';
  }
  return text;
}

TEST(Stimulus, ALineIsAScan) {
  const StimulusResult result = read("X0=1 d005=-7\n\n_note x0=0 M3=1\r\n\t\n");
  EXPECT_EQ(result.messages, "");
  ASSERT_TRUE(result.stimulus);
  EXPECT_EQ(dump(*result.stimulus), " X0=1 D5=-7 | | X0=0 M3=1 | ");
}

TEST(Stimulus, RepeatedScansActOnce) {
  const StimulusResult result = read("D1=5 *3 X1=1\n*2\nX1=0");
  EXPECT_EQ(result.messages, "");
  ASSERT_TRUE(result.stimulus);
  EXPECT_EQ(dump(*result.stimulus), " D1=5 X1=1 | | | | | X1=0 ");
  EXPECT_TRUE(result.stimulus->events(99).empty());
}

TEST(Stimulus, ManyScansTakeNoRoom) {
  const StimulusResult result = read("*1000000000000\nX0=1\n");
  ASSERT_TRUE(result.stimulus);
  EXPECT_EQ(result.stimulus->scans(), 1000000000001U);
  EXPECT_EQ(result.stimulus->events(1000000000000U).size(), 1U);
}

TEST(Stimulus, NumbersAreOfTheDialect) {
  const StimulusResult octal = read("X10=1");
  ASSERT_TRUE(octal.stimulus);
  EXPECT_EQ(octal.stimulus->events(0)[0].device.number, 8U);
  const StimulusResult hexadecimal = read("X1F=1", Dialect::Q);
  ASSERT_TRUE(hexadecimal.stimulus);
  EXPECT_EQ(hexadecimal.stimulus->events(0)[0].device.number, 31U);
}

TEST(Stimulus, NamesAllDevicesAsTracesDo) {
  const StimulusResult fx =
      read("TN0=5 TS0=1 CN200=-1 cn200:h=32767 CS200=1 S20=1 M8200=1 M8022=1 R7=1 Z0=-3 V7=2");
  EXPECT_EQ(fx.messages, "");
  ASSERT_TRUE(fx.stimulus);
  EXPECT_EQ(dump(*fx.stimulus),
            " TN0=5 TS0=1 CN200=-1 CN200:h=32767 CS200=1 S20=1 M8200=1 M8022=1 R7=1 Z0=-3 V7=2 ");
  const StimulusResult q = read("STN3=7 STS3=1 B1F=1 W1f=-9 L5=1 F1=1 SM700=1 Z19=4", Dialect::Q);
  EXPECT_EQ(q.messages, "");
  ASSERT_TRUE(q.stimulus);
  EXPECT_EQ(dump(*q.stimulus, Dialect::Q), " STN3=7 STS3=1 B1F=1 W1F=-9 L5=1 F1=1 SM700=1 Z19=4 ");
}

TEST(Stimulus, WhatTheControllerDrivesCannotBeSet) {
  EXPECT_EQ(read("M8000=1 M8013=0 M8010=1\nT0=1 C7=3 TS0=2").messages,
            "s:1:1: error: M8000 cannot be set: the controller drives it\n"
            "    it follows from the scans and from --tick\n"
            "s:1:9: error: M8013 cannot be set: the controller drives it\n"
            "    it follows from the scans and from --tick\n"
            "s:1:17: error: M8010 is a special device that this controller does not have\n"
            "s:2:1: error: T0 is both a contact and a value\n"
            "    write TS0 for the contact or TN0 for the value\n"
            "s:2:6: error: C7 is both a contact and a value\n"
            "    write CS7 for the contact or CN7 for the value\n"
            "s:2:11: error: the value of TS0 is 2, not a number from 0 to 1\n");
  EXPECT_EQ(read("SM402=1 ST1=1", Dialect::Q).messages,
            "s:1:1: error: SM402 cannot be set: the controller drives it\n"
            "    it follows from the scans and from --tick\n"
            "s:1:9: error: ST1 is both a contact and a value\n"
            "    write STS1 for the contact or STN1 for the value\n");
}

TEST(Stimulus, SaysWhatIsWrong) {
  EXPECT_EQ(
      read("X0=1 RX=5\nA1=7\nX8=1 X0=2\nD0=32768 M0=x\nX0\n=1 *0 *x\n*2 *3\n*9999999999999")
          .messages,
      "s:1:6: error: RX is no device of dialect fx\n"
      "    a stimulus names devices as traces do, X0 M5 S20 D7 TN0 CN200:h, in the number base "
      "of the dialect\n"
      "s:2:1: error: A1 is no device of dialect fx\n"
      "    a stimulus names devices as traces do, X0 M5 S20 D7 TN0 CN200:h, in the number base "
      "of the dialect\n"
      "s:3:1: error: X8 is no device of dialect fx\n"
      "    a stimulus names devices as traces do, X0 M5 S20 D7 TN0 CN200:h, in the number base "
      "of the dialect\n"
      "s:3:6: error: the value of X0 is 2, not a number from 0 to 1\n"
      "s:4:1: error: the value of D0 is 32768, not a number from -32768 to 32767\n"
      "s:4:10: error: the value of M0 is x, not a number from 0 to 1\n"
      "s:5:1: error: X0 is no stimulus\n"
      "    write X0=1 for an input, D5=7 for a preset, *10 for ten scans\n"
      "s:6:1: error: =1 is no stimulus\n"
      "    write X0=1 for an input, D5=7 for a preset, *10 for ten scans\n"
      "s:6:4: error: *0 is no number of scans\n"
      "    write *1 to *1000000000000\n"
      "s:6:7: error: *x is no number of scans\n"
      "    write *1 to *1000000000000\n"
      "s:7:4: error: this line has a number of scans already\n"
      "s:8:1: error: *9999999999999 is no number of scans\n"
      "    write *1 to *1000000000000\n");
}

TEST(Stimulus, OfAGoldenTrace) {
  const std::string header =
      R"({"rung_trace":1,"program":"p","dialect":"fx","tick_ms":10,"mpu":0})";
  const auto of = [&](const std::string& lines, std::string& messages) {
    Diagnostics diagnostics;
    const auto trace = read_trace(header + "\n" + lines, "g", diagnostics);
    EXPECT_TRUE(trace);
    const auto stimulus = stimulus_of(*trace, Dialect::Fx, "g", diagnostics);
    messages = printed(diagnostics);
    return stimulus;
  };
  std::string messages;
  const auto good = of(R"({"scan":0,"in":{"X0":1,"D0":-3},"writes":[],"out":{}})"
                       "\n"
                       R"({"scan":1,"in":{},"writes":[],"out":{}})",
                       messages);
  EXPECT_EQ(messages, "");
  ASSERT_TRUE(good);
  EXPECT_EQ(dump(*good), " X0=1 D0=-3 | ");
  EXPECT_FALSE(of(R"({"scan":0,"in":{"X9":1,"X0":2,"RX":[1]},"writes":[],"out":{}})", messages));
  EXPECT_EQ(
      messages,
      "g:2:1: error: it gives received bytes (RX), which a list does not read\n"
      "g:2:1: error: X9 is no device of dialect fx\n"
      "    a stimulus names devices as traces do, X0 M5 S20 D7 TN0 CN200:h, in the number base "
      "of the dialect\n"
      "g:2:1: error: the value of X0 is 2, not a number from 0 to 1\n");
}

}  // namespace
}  // namespace rung
