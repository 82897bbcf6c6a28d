// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "ldmicro/element.hpp"

namespace rung {
namespace {

struct Group {
  std::string_view keywords;  // with a blank around each
  const char* what;
  const char* mend;
};

// What LDmicro 5 has beyond the manual.
constexpr Group kGroups[] = {
    {" DELAY ", "a wait within the scan", "let TON or RTO wait from scan to scan"},
    {" TIME2COUNT TIME2DELAY ", "a conversion of times into waits",
     "compute the number of scans: delay / CYCLE"},
    {" SLEEP CLRWDT LOCK ", "a microcontroller's sleep, watchdog or halt",
     "remove it: the controller has its own"},
    {" GOTO GOSUB RETURN LABEL SUBPROG ENDSUB ", "a jump or a subroutine",
     "enable rungs with MASTER_RELAY, or with a contact in each"},
    {" ODR ODF OSL ", "an edge of LDmicro 5", "use OSR or OSF, behind a contact"},
    {" OSC ", "an oscillator", "use a negated contact, TON and TOF on one relay"},
    {" NPULSE NPULSE_OFF PULSER STEPPER QUAD_ENCOD ", "a pulse output or input in hardware",
     "write its steps with timers and counters where the scan is fast enough"},
    {" RTL TCY THI THL TLO TLH ", "a timer of LDmicro 5", "use TON, TOF and RTO with RES"},
    {" CTR ", "a circular counter downwards", "use CTD, a compare and MOVE"},
    {" BIN2BCD BCD2BIN OPPOSITE SWAP BUS ", "a conversion of LDmicro 5",
     "use DIV, MUL and SUB, or a LOOK_UP_TABLE"},
    {" SPI SPI_WR I2C_RD I2C_WR ", "a bus that the controller does not have",
     "reach the device over the UART"},
    {" 7SEGMENTS 9SEGMENTS 14SEGMENTS 16SEGMENTS ", "a segment display",
     "use a LOOK_UP_TABLE and one coil a segment"},
    {" MOD ", "the remainder of a division", "use DIV, MUL and SUB"},
    {" NEG ", "a change of sign", "use SUB from 0"},
    {" SHL SHR SR0 ROL ROR ", "a shift of bits", "use MUL or DIV by a power of two"},
    {" AND OR XOR NOT SET_BIT CLEAR_BIT IF_BIT_SET IF_BIT_CLEAR ",
     "an operation on the bits of a variable", "keep the bits as relays"},
    {" RSFR WSFR SSFR CSFR TSFR TCSFR ", "access to a microcontroller's registers",
     "remove it: the processor has none of them"},
    {" RANDOM SEED_RANDOM ", "random numbers", "use MUL and ADD on a variable that persists"},
    {" UART_RECV_AVAIL UART_SEND_READY UART_RECVn UART_SENDn UART_UDRE ", "a state of the UART",
     "use the conditions that UART_RECV and UART_SEND give"},
    {" STRING FRMT_STR_TO_CHAR ", "a string in memory", "use FORMATTED_STRING"},
    {" PWM_OFF SET_PWM_SOFT ", "a PWM output of LDmicro 5", "use SET_PWM, with duty 0 for off"},
};

}  // namespace

void refuse_ld_keyword(const LdLine& line, LdContext& context) {
  const std::string& keyword = line.keyword();
  if (keyword == "PLACEHOLDER") {
    return context.error(line.position(), "PLACEHOLDER: an empty place in the rung",
                         "put an element there, or delete the row");
  }
  const std::string word = " " + keyword + " ";
  const auto* const group = std::find_if(
      std::begin(kGroups), std::end(kGroups),
      [&](const Group& each) { return each.keywords.find(word) != std::string::npos; });
  if (group != std::end(kGroups)) {
    return context.error(line.position(),
                         fmt::format("{}: {}, which only LDmicro 5 has", keyword, group->what),
                         group->mend);
  }
  std::string upper = keyword;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  context.error(line.position(), fmt::format("{} is no element of LDmicro", shown(keyword)),
                upper != keyword ? "elements are written in capitals" : "");
}

}  // namespace rung
