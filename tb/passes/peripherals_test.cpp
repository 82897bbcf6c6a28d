// SPDX-License-Identifier: Apache-2.0
// Whether the clock of a configuration can make what a program asks of UART and PWM.
#include "driver/peripherals.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "ldmicro/ldmicro.hpp"
#include "passes/support.hpp"

namespace rung {
namespace {

// What is said of a program with this baud rate and these elements, each in a rung of its own.
std::string messages(const std::string& baud, const std::vector<std::string>& elements,
                     const char* config = "hx8k") {
  std::string text = "LDmicro0.1\nCYCLE=10000\nBAUD=" + baud + "\nPROGRAM\n";
  for (const std::string& element : elements) text += "RUNG\n" + element + "\nEND\n";
  Diagnostics reading;
  const auto source = decode_text(text, "test.ld", reading);
  const auto program = parse_ldmicro(*source, reading);
  Diagnostics diagnostics;
  check_peripherals(*program, *isa::find_config(config), diagnostics);
  std::ostringstream out;
  diagnostics.print(out);
  return out.str();
}

const std::vector<std::string> kUart = {"UART_RECV v"};
const std::vector<std::string> kNoUart = {"SHORT"};

TEST(Peripherals, UsualBaudRatesAreMade) {
  for (const char* baud : {"300", "2400", "9600", "115200", "921600"}) {
    EXPECT_EQ(messages(baud, kUart), "") << baud;
    EXPECT_EQ(messages(baud, kUart, "ecp5"), "") << baud;
  }
}

TEST(Peripherals, ABaudRateThatCannotBeMadeIsRefused) {
  EXPECT_EQ(
      messages("2000000", kUart),
      "test.ld:3:1: error: BAUD=2000000: the clock of configuration hx8k, 12 MHz, cannot make it\n"
      "    choose one from 2 to 923076\n");
  EXPECT_EQ(messages("2000000", kNoUart), "");
}

TEST(Peripherals, ABaudRateThatIsFarOffIsWarnedOf) {
  EXPECT_EQ(messages("2", kUart),
            "test.ld:3:1: warning: BAUD=2: the clock of configuration hx8k, 12 MHz, makes 1.4, "
            "-28.5 % off\n"
            "    choose a higher one\n");
  EXPECT_EQ(messages("1000000", kUart),
            "test.ld:3:1: warning: BAUD=1000000: the clock of configuration hx8k, 12 MHz, has 12.0 "
            "clocks "
            "a bit, too few for a sender that is 2 % off\n"
            "    choose 923076 or less\n");
}

TEST(Peripherals, PwmFrequencies) {
  EXPECT_EQ(messages("2400", {"MOVE v 1", "SET_PWM v 120000"}), "");
  EXPECT_EQ(
      messages("2400", {"MOVE v 1", "SET_PWM v 240000"}),
      "test.ld:9:1: warning: SET_PWM v 240000: with the clock of configuration hx8k, 12 MHz, the "
      "duty comes in steps of 2.0 %\n"
      "    choose 120000 Hz or less\n");
  EXPECT_EQ(
      messages("2400", {"MOVE v 1", "SET_PWM v 7000000"}),
      "test.ld:9:1: error: SET_PWM v 7000000: the clock of configuration hx8k, 12 MHz, cannot make "
      "this frequency\n"
      "    choose 120000 Hz or less\n");
}

}  // namespace
}  // namespace rung
