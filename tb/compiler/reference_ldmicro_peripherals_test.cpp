// SPDX-License-Identifier: Apache-2.0
// The reference on LDmicro programs: analogue channels, PWM, lasting memory, UART.
#include "reference_ldmicro_story.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

constexpr LdStory kAnalogue[] = {
    {"ReadAdc", "CONTACTS Xa 0, READ_ADC Aa, COIL Yo 0 0 0", "Aa=512 | Xa=1 | Aa=100 | Xa=0 Aa=7",
     "Yo=0 | Aa=512 Yo=1 | Aa=100 Yo=1 | Yo=0"},
    {"OneChannelAName", "CONTACTS Xa 0, READ_ADC Aa; READ_ADC Ab; READ_ADC Aa",
     "Aa=3 Ab=4 | Aa=5 Xa=1", "Ab=4 Aa=3 | Aa=5"},
    {"PwmShowsNowhere", "CONTACTS Xa 0, SET_PWM v 1000, COIL Yo 0 0 0", "v=40 | Xa=1",
     "Yo=0 | Yo=1"},
    {"LastingMemoryIsNeverReady", "PERSIST v, COIL Yo 0 0 0", "v=4 |", "Yo=1 | Yo=1"},
};
INSTANTIATE_TEST_SUITE_P(Analogue, LdReferenceStory, testing::ValuesIn(kAnalogue), ld_story_name);

constexpr LdStory kUart[] = {
    // 321 is 1 and 65; the transmitter is busy in two scans.
    {"Send", "CONTACTS Xa 0, UART_SEND v, COIL Yo 0 0 0", "v=321 Xa=1 | Xa=0 | | Xa=1 | |",
     "Yo=1 TX=65 | Yo=1 | Yo=0 | Yo=1 TX=65 | Yo=1 | Yo=1 TX=65"},
    {"OneTransmitter", "UART_SEND a, COIL Y1 0 0 0; UART_SEND b, COIL Y2 0 0 0", "a=65 b=66 | |",
     "Y1=1 Y2=1 TX=65 | Y1=1 Y2=1 | Y1=1 Y2=1 TX=65"},
    {"Receive", "CONTACTS Xa 0, UART_RECV r, COIL Yo 0 0 0",
     "RX=66 | Xa=1 | | RX=67 RX=68 | Xa=0 RX=69 | | Xa=1 |",
     "Yo=0 | r=66 Yo=1 | Yo=0 | r=68 Yo=1 | Yo=0 | Yo=0 | r=69 Yo=1 | Yo=0"},
    {"NewerByteReplaces", "CONTACTS Xa 0, UART_RECV r, COIL Yo 0 0 0", "RX=255 | RX=0 r=1 | Xa=1",
     "Yo=0 | Yo=0 | r=0 Yo=1"},
    {"OneReceiverGetsIt", "UART_RECV r, COIL Y1 0 0 0; UART_RECV s, COIL Y2 0 0 0", "RX=7 |",
     "r=7 Y1=1 Y2=0 | Y1=0 Y2=0"},
};
INSTANTIATE_TEST_SUITE_P(Uart, LdReferenceStory, testing::ValuesIn(kUart), ld_story_name);

constexpr LdStory kStrings[] = {
    // Sent once at power-up; the condition falls with the last byte.
    {"PowerUp", "CONTACTS Xa 0, FORMATTED_STRING (none) 2 72 105, COIL Yo 0 0 0",
     "| | | | Xa=1 | | | |",
     "Yo=1 TX=72 | Yo=1 | Yo=0 TX=105 | Yo=0 | Yo=1 TX=72 | Yo=1 | Yo=0 TX=105 | Yo=0 | Yo=0"},
    {"StartsAnew", "CONTACTS Xa 0, FORMATTED_STRING (none) 2 72 105, COIL Yo 0 0 0",
     "| | Xa=1 | | |", "Yo=1 TX=72 | Yo=1 | Yo=1 TX=72 | Yo=1 | Yo=0 TX=105 | Yo=0"},
    {"TakesTurns",
     "FORMATTED_STRING (none) 1 65, COIL Y1 0 0 0; FORMATTED_STRING (none) 1 66, COIL Y2 0 0 0",
     "| | |", "Y1=0 Y2=1 TX=65 | Y1=0 Y2=1 | Y1=0 Y2=0 TX=66 | Y1=0 Y2=0"},
    // \r \n \b \f \\ \x4a
    {"Escapes", "FORMATTED_STRING (none) 14 92 114 92 110 92 98 92 102 92 92 92 120 52 97", "*11",
     "TX=13 | | TX=10 | | TX=8 | | TX=12 | | TX=92 | | TX=74"},
    // \-3 of -35, which is taken with the sign
    {"Signed", "FORMATTED_STRING v 3 92 45 51, COIL Yo 0 0 0", "v=-35 | v=999 | | | | |",
     "Yo=1 TX=45 | Yo=1 | Yo=1 TX=32 | Yo=1 | Yo=1 TX=51 | Yo=1 | Yo=0 TX=53"},
    {"SignedPositive", "FORMATTED_STRING v 3 92 45 50", "v=4 | | | |", "TX=32 | | TX=32 | | TX=52"},
    {"Zeros", "FORMATTED_STRING v 2 92 51", "| | | |", "TX=32 | | TX=32 | | TX=48"},
    {"ZerosBehindADigit", "FORMATTED_STRING v 2 92 52", "v=500 | | | | | |",
     "TX=32 | | TX=53 | | TX=48 | | TX=48"},
    // 14 is no digit: 48 + 14
    {"TooLarge", "FORMATTED_STRING v 2 92 51", "v=1432 | | | |", "TX=62 | | TX=51 | | TX=50"},
    // -35 is 0, -3 and -5
    {"NegativeWithoutSign", "FORMATTED_STRING v 2 92 51", "v=-35 | | | |",
     "TX=32 | | TX=45 | | TX=43"},
    // Its absolute value is itself: -3 -2 -7 -6 -8
    {"Lowest", "FORMATTED_STRING v 3 92 45 53", "v=-32768 | | | | | | | | | |",
     "TX=45 | | TX=45 | | TX=46 | | TX=41 | | TX=42 | | TX=40"},
    // a\2b, with what v is when its first digit goes out
    {"TakenAtItsFirstDigit", "FORMATTED_STRING v 4 97 92 50 98", "v=11 | | v=42 | | v=99 | | |",
     "TX=97 | | TX=52 | | TX=50 | | TX=98 |"},
};
INSTANTIATE_TEST_SUITE_P(Strings, LdReferenceStory, testing::ValuesIn(kStrings), ld_story_name);

TEST(LdReference, PwmPortsHoldDutyAndTheFirstFrequency) {
  const Program program =
      ld_program("CONTACTS Xa 0, SET_PWM v 100000; CONTACTS Xb 0, SET_PWM v 1000");
  Reference reference(program);
  const auto set = [&](const char* name, std::int16_t value) {
    reference.set(*DeviceNames(program).device(name), value);
  };
  set("v", 40);
  reference.run_scan();
  EXPECT_EQ(reference.get(port::pwm_duty), 0);
  set("Xa", 1);
  reference.run_scan();
  EXPECT_EQ(reference.get(port::pwm_duty), 40);
  // 100000 is 1 * 65536 + 34464, and 34464 - 65536 is -31072.
  EXPECT_EQ(reference.get(port::pwm_hz_low), -31072);
  EXPECT_EQ(reference.get(port::pwm_hz_high), 1);
  set("Xa", 0);
  set("Xb", 1);
  set("v", -5);
  reference.run_scan();
  EXPECT_EQ(reference.get(port::pwm_duty), -5);
  EXPECT_EQ(reference.get(port::pwm_hz_low), -31072);
}

TEST(LdReference, PersistRestoresOnceThenKeeps) {
  const Program program = ld_program("CONTACTS Xa 0, PERSIST v; PERSIST w");
  Reference reference(program);
  const DeviceNames names(program);
  const Device kept = port::persist_value;
  const Device kept_w = port::at(port::persist_value, 1);
  reference.set(kept, 7);
  reference.set(*names.device("v"), 3);
  reference.set(port::persist_ready, 1);
  reference.run_scan();
  EXPECT_EQ(done_in_scan(reference, program), "");
  reference.set(*names.device("Xa"), 1);
  reference.run_scan();
  EXPECT_EQ(done_in_scan(reference, program), "v=7");
  EXPECT_EQ(reference.get(port::persist_ready), 1);
  // Both have changed: the first one makes the memory busy.
  reference.set(*names.device("v"), 8);
  reference.set(*names.device("w"), 9);
  reference.run_scan();
  EXPECT_EQ(reference.get(kept), 8);
  EXPECT_EQ(reference.get(kept_w), 0);
  EXPECT_EQ(reference.get(port::persist_index), 0);
  EXPECT_EQ(reference.get(port::persist_ready), 0);
  reference.run_scan();
  EXPECT_EQ(reference.get(kept_w), 0);
  reference.set(port::persist_ready, 1);
  reference.run_scan();
  EXPECT_EQ(reference.get(kept_w), 9);
  EXPECT_EQ(reference.get(port::persist_index), 1);
  EXPECT_EQ(done_in_scan(reference, program), "");
}

}  // namespace
}  // namespace rung
