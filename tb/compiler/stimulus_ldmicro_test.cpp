// SPDX-License-Identifier: Apache-2.0
// The stimulus of an LDmicro program, which has names of its own, from a file and from a trace.
#include <gtest/gtest.h>

#include "programs/random_source.hpp"
#include "reference/run.hpp"
#include "reference_ldmicro_story.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

// Inputs Xa and Xb, a relay R, an output Yo; variables v, Aa (a channel too) and n, which is also a
// bit; Xb is an input and a variable.
constexpr const char* kProgram =
    "CONTACTS Xa 0, CONTACTS Xb 0, COIL R 0 0 0; CONTACTS n 0, MOVE n v, MOVE v Xb;"
    "READ_ADC Aa; UART_RECV v; MOVE Xb 3, COIL Yo 0 0 0";

struct Read {
  std::string events;  // " X0=1 D5=7 | " by kind and number, of the ports uart_rx_data and adc
  std::string messages;
};

Read read(std::string_view text) {
  const Program program = ld_program(kProgram);
  Diagnostics diagnostics;
  Read result;
  const auto source = decode_text(text, "s", diagnostics);
  const auto stimulus = parse_stimulus(*source, program, diagnostics);
  result.messages = printed(diagnostics);
  for (std::uint64_t scan = 0; stimulus && scan < stimulus->scans(); ++scan) {
    if (scan > 0) result.events += '|';
    for (const StimulusEvent& event : stimulus->events(scan)) {
      const std::string name = event.device == port::uart_rx_data ? "(byte)"
                               : event.device == port::adc        ? "(channel)"
                                                           : device_name(event.device, program);
      result.events += fmt::format(" {}={}", name, event.value);
    }
    result.events += ' ';
  }
  return result;
}

TEST(LdStimulus, NamesAreTheProgramsOwn) {
  const Read all = read("Xa=1 R=1 v=-7\nAa=1023 *2\nRX=255 RX=0 _=\n\nYo=1");
  EXPECT_EQ(all.messages, "");
  EXPECT_EQ(all.events, " Xa=1 R=1 v=-7 | (channel)=1023 | | (byte)=255 (byte)=0 | | Yo=1 ");
}

TEST(LdStimulus, ANameThatIsBitAndVariable) {
  // An input is the input, any other name the variable; its full name always works.
  const Read all = read("Xb=1 n=5\nXb:w=7 n:w=8");
  EXPECT_EQ(all.messages, "");
  EXPECT_EQ(all.events, " Xb=1 n:w=5 | Xb:w=7 n:w=8 ");
}

TEST(LdStimulus, SaysWhatIsWrong) {
  EXPECT_EQ(read("xa=1 Xc=1\nXa=2 RX=256 RX=-1\nv=32768 Aa=x\nXa\nM0=1 D0=1").messages,
            "s:1:1: error: the program has no xa\n"
            "    write Xa: case matters\n"
            "s:1:6: error: the program has no Xc\n"
            "    a stimulus names the program's own inputs, relays, variables and channels\n"
            "s:2:1: error: the value of Xa is 2, not a number from 0 to 1\n"
            "s:2:6: error: the value of RX is 256, not a number from 0 to 255\n"
            "s:2:13: error: the value of RX is -1, not a number from 0 to 255\n"
            "s:3:1: error: the value of v is 32768, not a number from -32768 to 32767\n"
            "s:3:9: error: the value of Aa is x, not a number from -32768 to 32767\n"
            "s:4:1: error: Xa is no stimulus\n"
            "    write Xname=1 for an input, name=7 for a variable or an analogue channel, RX=65 "
            "for a byte, *10 for ten scans\n"
            "s:5:1: error: the program has no M0\n"
            "    a stimulus names the program's own inputs, relays, variables and channels\n"
            "s:5:6: error: the program has no D0\n"
            "    a stimulus names the program's own inputs, relays, variables and channels\n");
}

// What a run shows as its `in` is a stimulus that gives the same run.
TEST(LdStimulus, OfATraceIsThatOfTheRun) {
  const Program program = ld_program(kProgram);
  const Stimulus stimulus = ld_stimulus(
      "Xa=1 Xb=1 n=5 Aa=9 | Xb:w=4 RX=65 | Aa=9 Xa=1 | v=3 R=1 RX=1 RX=2 | Xa=0", program);
  const auto run = [&](const Stimulus& given, std::uint64_t scans) {
    ReferenceRun reference(program, true);
    Trace trace{reference.header(), {}};
    for (std::uint64_t scan = 0; scan < scans; ++scan) {
      trace.scans.push_back(reference.scan(given.events(scan)));
    }
    return trace;
  };
  const Trace trace = run(stimulus, stimulus.scans());
  EXPECT_EQ(trace.header.dialect, "ldmicro");
  EXPECT_EQ(trace.header.tick_us, 10000);
  Diagnostics diagnostics;
  const auto again = read_trace(to_json_lines(trace), "g", diagnostics);
  ASSERT_TRUE(again) << printed(diagnostics);
  const auto from_trace = stimulus_of(*again, program, "g", diagnostics);
  ASSERT_TRUE(from_trace) << printed(diagnostics);
  EXPECT_EQ(to_json_lines(run(*from_trace, from_trace->scans())), to_json_lines(trace));
  EXPECT_EQ(to_json(trace.scans[1]),
            R"({"scan":1,"clocks":null,"in":{"Xb:w":4,"RX":[65]},"writes":[["R",1],)"
            R"(["v",65],["Xb:w",3],["Yo",1]],"out":{},"state":{"Xa":1,"Xb":1,"Yo":1,"R":1,"n":0,)"
            R"("n:w":5,"v":65,"Xb:w":3,"Aa":9}})");
}

TEST(LdStimulus, OfATraceSaysWhatIsWrong) {
  const Program program = ld_program(kProgram);
  Diagnostics diagnostics;
  const auto trace =
      read_trace(R"({"rung_trace":1,"program":"p","dialect":"ldmicro","tick_ms":10,"mpu":0})"
                 "\n"
                 R"({"scan":0,"in":{"Xa":2,"who":1,"RX":[5]},"writes":[],"out":{}})",
                 "g", diagnostics);
  ASSERT_TRUE(trace);
  EXPECT_FALSE(stimulus_of(*trace, program, "g", diagnostics));
  EXPECT_EQ(printed(diagnostics),
            "g:2:1: error: the value of Xa is 2, not a number from 0 to 1\n"
            "g:2:1: error: the program has no who\n"
            "    a stimulus names the program's own inputs, relays, variables and channels\n");
}

TEST(LdStimulus, AnyTextIsReadOrRefused) {
  static constexpr const char* kPieces[] = {"Xa", "=",   "1",  " ", "\n", "*",  "9",
                                            "_",  "n:w", "Aa", "-", "RX", "xa", "0"};
  const DeviceNames names(ld_program(kProgram));
  RandomSource random(7);
  int accepted = 0;
  for (int round = 0; round < 5000; ++round) {
    std::string text = "Xa=1";
    for (int i = random.below(12); i > 0; --i) text += kPieces[random.bits() % std::size(kPieces)];
    Diagnostics diagnostics;
    const auto source = decode_text(text, "s", diagnostics);
    ASSERT_TRUE(source);
    const auto stimulus = parse_stimulus(*source, names, diagnostics);
    ASSERT_EQ(stimulus.has_value(), !diagnostics.has_errors()) << text;
    accepted += stimulus ? 1 : 0;
  }
  EXPECT_GT(accepted, 100);
}

}  // namespace
}  // namespace rung
