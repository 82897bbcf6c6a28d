// SPDX-License-Identifier: Apache-2.0
// The C of LDmicro programs as their users meet it: names, and when which hook is called.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "backends/c_writer.hpp"
#include "reference_ldmicro_story.hpp"

namespace rung {
namespace {

std::string contents(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(CHooks, ARungUnderItsSource) {
  const std::string text = to_c(ld_program(
      "PARALLEL, CONTACTS Xstart 0, CONTACTS Yrun 0, END, CONTACTS Xstop 1, TON T 30000, COIL Yrun "
      "0 0 0; CONTACTS Yrun 0, MOVE int T"));
  const std::string rungs =
      "   *     9: CONTACTS Xstart 0\n"
      "   *    10: CONTACTS Yrun 0\n"
      "   *    11: END\n"
      "   *    12: CONTACTS Xstop 1\n"
      "   *    13: TON T 30000\n"
      "   *    14: COIL Yrun 0 0 0 */\n"
      "  r0 = 1;\n"
      "  in0 = r0;\n"
      "  any0 = 0;\n"
      "  r0 &= plc.b_Xstart;\n"
      "  any0 |= r0;\n"
      "  r0 = in0;\n"
      "  r0 &= plc.b_Yrun;\n"
      "  r0 |= any0;\n"
      "  r0 &= plc.b_Xstop ^ 1u;\n"
      "  r0 = plc_ton(&plc.w_T, r0, 2);\n"
      "  plc.b_Yrun = (uint8_t)(r0);\n";
  EXPECT_NE(text.find(rungs), std::string::npos) << text;
  EXPECT_NE(text.find("  if (r0) plc.w_int = plc.w_T;\n"), std::string::npos);
  EXPECT_NE(text.find("Call PlcCycle every 10000 microseconds"), std::string::npos);
}

TEST(CHooks, OnlyThoseThatAProgramUses) {
  const std::string text =
      to_c(ld_program("CONTACTS Xa 0, COIL Yb 0 0 0, COIL Rc 0 0 0, MOVE d 1"));
  for (const char* const there :
       {"uint8_t PlcInput_Xa(void);", "void PlcOutput_Yb(uint8_t value);",
        "uint8_t PlcReadBit_Rc(void);", "void PlcWriteWord_d(int16_t value);"}) {
    EXPECT_NE(text.find(there), std::string::npos) << there;
  }
  for (const char* const absent : {"PlcElapsed", "PlcReadX", "PlcAdc", "PlcUart", "PlcSetPwm",
                                   "PlcPersist", "ReadBit_Xa", "running"}) {
    EXPECT_EQ(text.find(absent), std::string::npos) << absent;
  }
}

// Logs every hook that does something to the outside. Inputs and samples count up; of the UART
// there is a byte for each call, and it is ready every other time; the EEPROM's first value is 40.
constexpr const char* kUser = R"(
#include <stdio.h>

static int calls, bytes, ready;
static int16_t kept[2] = {40, 50};

uint8_t PlcInput_Xa(void) { return (uint8_t)(calls++ % 2 ? 0 : 7); }
void PlcOutput_Yb(uint8_t value) { printf("b%d ", value); }
int16_t PlcAdc_A1(void) { return (int16_t)(60 + 30 * calls); }
int16_t PlcUartReceive(void) { return (int16_t)(++bytes == 2 ? -1 : 64 + bytes); }
uint8_t PlcUartReady(void) { return (uint8_t)(ready++ % 2 ? 0 : 9); }
void PlcUartSend(uint8_t byte) { printf("t%d ", byte); }
void PlcSetPwm(uint8_t percent, uint32_t hertz) { printf("p%d,%lu ", percent, (unsigned long)hertz); }
uint8_t PlcPersistReady(void) { return 1; }
int16_t PlcPersistRead(uint8_t number) { return kept[number]; }
void PlcPersistWrite(uint8_t number, int16_t value) {
  kept[number] = value;
  printf("k%d,%d ", number, value);
}

int main(void) {
  int i;
  for (i = 0; i < 4; ++i) {
    if (i == 2) PlcWriteWord_w((int16_t)(PlcReadWord_w() + 5));
    PlcCycle();
    printf("a%d v%d e%d\n", PlcReadWord_A1(), PlcReadWord_v(), PlcError());
  }
  return 0;
}
)";

TEST(CHooks, AreCalledAroundTheScan) {
  const Program program = ld_program(
      "CONTACTS Xa 0, COIL Yb 0 0 0, UART_RECV v; UART_SEND v; READ_ADC A1, SET_PWM A1 100000; "
      "PERSIST x; PERSIST w; CONTACTS Xa 1, DIV z v z");
  const std::string base = RUNG_SCRATCH "/c_hooks";
  std::ofstream(base + ".c") << to_c(program) << kUser;
  const std::string command = fmt::format(
      "'{0}' -std=c99 -Wall -Wextra -pedantic -Wno-missing-prototypes -Werror -o "
      "'{1}.run' '{1}.c' >'{1}.log' 2>&1 && '{1}.run' >'{1}.out'",
      RUNG_C_COMPILER, base);
  ASSERT_EQ(std::system(command.c_str()), 0) << contents(base + ".log");
  // Scan 0: Xa is 1, so 65 is taken and sent; the sample is 90. 1: none has come, and Xa is 0: a
  // division by zero; the transmitter is not ready; a share above 100. 2: 67 comes and is sent; w
  // is 50 and 5. 3: 68 comes and waits.
  EXPECT_EQ(contents(base + ".out"),
            "b1 t65 p90,100000 a90 v65 e0\n"
            "b0 p100,100000 a120 v65 e1\n"
            "b1 t67 k1,55 a150 v67 e0\n"
            "b0 a180 v67 e1\n");
}

}  // namespace
}  // namespace rung
