// SPDX-License-Identifier: Apache-2.0
// LDmicro files that are refused, with everything that is said of each, word for word.
#include <gtest/gtest.h>

#include "ldmicro_support.hpp"

namespace rung {
namespace {

struct RefusedFile {
  const char* name;
  std::string text;
  const char* messages;
};

class LdmicroRefused : public testing::TestWithParam<RefusedFile> {};

TEST_P(LdmicroRefused, SaysWhereWhatAndHowToMend) {
  const ParseResult result = parse_ld(GetParam().text);
  EXPECT_FALSE(result.program);
  EXPECT_EQ(result.messages, GetParam().messages);
}

std::string refused_file_name(const testing::TestParamInfo<RefusedFile>& info) {
  return info.param.name;
}

const RefusedFile kOperands[] = {
    {"Missing", ld_file("CONTACTS Xa\nADD d"),
     "t.ld:4:1: error: CONTACTS: 1 of its operands is missing\n"
     "    write: CONTACTS name negated\n"
     "t.ld:5:1: error: ADD: 2 of its operands are missing\n"
     "    write: ADD target operand operand\n"},
    {"TooMany", ld_file("OSR 1\nMOVE a 1 2\nEQU ' ' v\nRES a b"),
     "t.ld:4:5: error: 1: more operands than OSR takes\n"
     "    remove what does not belong to it\n"
     "t.ld:5:10: error: 2: more operands than MOVE takes\n"
     "    remove what does not belong to it\n"
     "t.ld:6:5: warning: ' is read as 0, as LDmicro 2.3 does with ' '\n"
     "    write 32 for a blank\n"
     "t.ld:6:7: warning: ' is read as 0, as LDmicro 2.3 does with ' '\n"
     "    write 32 for a blank\n"
     "t.ld:6:9: error: v: more operands than EQU takes\n"
     "    remove what does not belong to it\n"
     "t.ld:7:7: error: b: more operands than RES takes\n"
     "    remove what does not belong to it\n"},
    {"Names",
     ld_file("CONTACTS a-b 0\nMOVE 5 v\nRES \xC3\xA4\nSET_PWM 50 1000\nSHIFT_REGISTER 1s 2"),
     "t.ld:4:10: error: a-b is no name\n"
     "    names are of letters, digits and _, and do not begin with a digit\n"
     "t.ld:5:6: error: 5: MOVE needs a name here, not a number\n"
     "    give it a variable, to which MOVE gives the number\n"
     "t.ld:6:5: error: \xC3\xA4 is no name\n"
     "    names are of letters, digits and _, and do not begin with a digit\n"
     "t.ld:7:9: error: 50: SET_PWM needs a name here, not a number\n"
     "    give it a variable, to which MOVE gives the number\n"
     "t.ld:8:16: error: 1s is no name\n"
     "    names are of letters, digits and _, and do not begin with a digit\n"},
    {"Marks", ld_file("CONTACTS Xa 2\nCOIL R 0 x 0"),
     "t.ld:4:13: error: 2: this mark of CONTACTS is 0 or 1\n"
     "t.ld:5:10: error: x: this mark of COIL is 0 or 1\n"},
    {"CoilOnInput", ld_file("COIL Xa 0 0 0"),
     "t.ld:4:6: error: COIL on an input: names with X are what comes from outside\n"
     "    give the relay a name with another letter, R for instance\n"},
    {"Beyond16Bits",
     ld_file("MOVE v 32768\nCTU C -32769\nEQU v 99999999999999999999\nLOOK_UP_TABLE d i 1 0 40000"),
     "t.ld:4:8: error: 32768 is beyond 16 bits\n"
     "    values are -32768 to 32767\n"
     "t.ld:5:7: error: -32769 is beyond 16 bits: the limit of a counter\n"
     "    values are -32768 to 32767\n"
     "t.ld:6:7: error: 99999999999999999999 is beyond 16 bits\n"
     "    values are -32768 to 32767\n"
     "t.ld:7:23: error: 40000 is beyond 16 bits: a value of the table\n"
     "    values are -32768 to 32767\n"},
    {"Beyond32Bits", ld_file("TON T 2147483648\nSHIFT_REGISTER s 99999999999"),
     "t.ld:4:7: error: 2147483648 is beyond 32 bits\n"
     "t.ld:5:18: error: 99999999999 is beyond 32 bits\n"},
    {"Characters", ld_file("MOVE v '\xC3\xA4'"),
     "t.ld:4:8: error: '\xC3\xA4': the code of this character depends on Windows' language\n"
     "    write the code itself\n"},
    {"TimerTooShort", ld_file("TON T 19999\nTOF T -5\nRTO T 0"),
     "t.ld:4:7: error: TON T 19999: 19999 us is too short for a CYCLE of 10000 us\n"
     "    a delay is at least two cycles: 20000 us, or a shorter CYCLE\n"
     "t.ld:5:7: error: TOF T -5: -5 us is too short for a CYCLE of 10000 us\n"
     "    a delay is at least two cycles: 20000 us, or a shorter CYCLE\n"
     "t.ld:6:7: error: RTO T 0: 0 us is too short for a CYCLE of 10000 us\n"
     "    a delay is at least two cycles: 20000 us, or a shorter CYCLE\n"},
    {"TimerTooLong", ld_file("TON T 327690000"),
     "t.ld:4:7: error: TON T 327690000: 327690000 us is too long for a CYCLE of 10000 us: the "
     "variable counts 16 bits\n"
     "    at most 327689999 us, or a longer CYCLE, or a counter behind the timer\n"},
    {"VariableAsNumber", ld_file("TON T delay\nCTU C max"),
     "t.ld:4:7: error: delay: TON takes a decimal number here\n"
     "    LDmicro 2.3 has no variables in this place: write the number\n"
     "t.ld:5:7: error: max: CTU takes a decimal number here\n"
     "    LDmicro 2.3 has no variables in this place: write the number\n"},
    {"ShiftRegister", ld_file("SHIFT_REGISTER s 0\nSHIFT_REGISTER s -1\nSHIFT_REGISTER s 10001"),
     "t.ld:4:18: error: SHIFT_REGISTER of 0 stages\n"
     "    it has 1 to 10000\n"
     "t.ld:5:18: error: SHIFT_REGISTER of -1 stages\n"
     "    it has 1 to 10000\n"
     "t.ld:6:18: error: SHIFT_REGISTER of 10001 stages\n"
     "    it has 1 to 10000\n"},
    {"LookUpTable",
     ld_file("LOOK_UP_TABLE d i 3 0 1 2\nLOOK_UP_TABLE d i -1 0\nLOOK_UP_TABLE d 5 0 0"),
     "t.ld:4:19: error: LOOK_UP_TABLE: 3 values are announced, and there are 2\n"
     "    write them all, or the number that there are\n"
     "t.ld:5:19: error: LOOK_UP_TABLE: -1 values are announced, and there are 0\n"
     "    write them all, or the number that there are\n"
     "t.ld:6:17: error: 5: LOOK_UP_TABLE needs a name here, not a number\n"
     "    give it a variable, to which MOVE gives the number\n"},
    {"Points",
     ld_file(
         "PIECEWISE_LINEAR d i 0\nPIECEWISE_LINEAR d i 2 0 0 0 5\nPIECEWISE_LINEAR d i 2 5 0 4 5\n"
         "PIECEWISE_LINEAR d i 2 0 0 1 32767\nPIECEWISE_LINEAR d i 2 0 0 2 "
         "-16384\nPIECEWISE_LINEAR d i 2 0 0 1\nPIECEWISE_LINEAR d i -1"),
     "t.ld:4:22: error: PIECEWISE_LINEAR without a point\n"
     "    write at least one, and two for a line\n"
     "t.ld:5:22: error: PIECEWISE_LINEAR: x = 0 does not lie behind x = 0\n"
     "    sort the points by x, each x once\n"
     "t.ld:6:22: error: PIECEWISE_LINEAR: x = 4 does not lie behind x = 5\n"
     "    sort the points by x, each x once\n"
     "t.ld:7:22: error: PIECEWISE_LINEAR: between x = 0 and 1 the distances multiply to 32767, "
     "beyond the 16 bits of the interpolation\n"
     "    put points between the two, or use smaller values\n"
     "t.ld:8:22: error: PIECEWISE_LINEAR: between x = 0 and 2 the distances multiply to -32768, "
     "beyond the 16 bits of the interpolation\n"
     "    put points between the two, or use smaller values\n"
     "t.ld:9:22: error: PIECEWISE_LINEAR: 2 points are announced, and there are 1\n"
     "    write them all, or the number that there are\n"
     "t.ld:10:22: error: PIECEWISE_LINEAR: -1 points are announced, and there are 0\n"
     "    write them all, or the number that there are\n"},
    {"Frequency", ld_file("SET_PWM d 0\nSET_PWM d -5"),
     "t.ld:4:11: error: SET_PWM: a frequency of 0 Hz\n"
     "    write 1 Hz or more\n"
     "t.ld:5:11: error: SET_PWM: a frequency of -5 Hz\n"
     "    write 1 Hz or more\n"},
    {"StringEscapes",
     ld_file("FORMATTED_STRING (none) 2 92 97\nFORMATTED_STRING (none) 1 92\nFORMATTED_STRING "
             "(none) 3 92 120 65\n"
             "FORMATTED_STRING v 2 92 48\nFORMATTED_STRING v 3 92 45 54\nFORMATTED_STRING v 4 92 "
             "49 92 49"),
     "t.ld:4:25: error: FORMATTED_STRING: \\a is no escape of a format string\n"
     "    the escapes are \\r \\n \\b \\f \\\\ \\xAB, and \\N or \\-N for N digits (1 to 5) of the "
     "variable\n"
     "t.ld:5:25: error: FORMATTED_STRING: a \\ with nothing behind it ends the string\n"
     "    the escapes are \\r \\n \\b \\f \\\\ \\xAB, and \\N or \\-N for N digits (1 to 5) of the "
     "variable\n"
     "t.ld:6:25: error: FORMATTED_STRING: \\x without two hexadecimal digits behind it\n"
     "    the escapes are \\r \\n \\b \\f \\\\ \\xAB, and \\N or \\-N for N digits (1 to 5) of the "
     "variable\n"
     "t.ld:7:20: error: FORMATTED_STRING: \\0: digits of the variable are 1 to 5\n"
     "    the escapes are \\r \\n \\b \\f \\\\ \\xAB, and \\N or \\-N for N digits (1 to 5) of the "
     "variable\n"
     "t.ld:8:20: error: FORMATTED_STRING: \\- without a number of digits from 1 to 5\n"
     "    the escapes are \\r \\n \\b \\f \\\\ \\xAB, and \\N or \\-N for N digits (1 to 5) of the "
     "variable\n"
     "t.ld:9:20: error: FORMATTED_STRING: the string shows the variable twice\n"
     "    one \\N or \\-N a string: write the second value with another FORMATTED STRING\n"},
    {"StringVariable", ld_file("FORMATTED_STRING v 1 65\nFORMATTED_STRING (none) 2 92 49"),
     "t.ld:4:20: error: FORMATTED_STRING: the string does not show its variable\n"
     "    write \\N where its N digits belong, or (none) instead of the variable\n"
     "t.ld:5:25: error: FORMATTED_STRING: the string shows digits, but of no variable\n"
     "    name the variable instead of (none)\n"},
    {"StringCodes",
     ld_file("FORMATTED_STRING (none) 2 65\nFORMATTED_STRING (none) 1 65 66\nFORMATTED_STRING "
             "(none) 1 256\nFORMATTED_STRING (none)\nFORMATTED_STRING (none) text"),
     "t.ld:4:25: error: FORMATTED_STRING: 2 codes are announced, and there are 1\n"
     "    write them all, or the number that there are\n"
     "t.ld:5:30: error: FORMATTED_STRING: 1 codes are announced, and 1 more follow\n"
     "    write the number of codes that there are\n"
     "t.ld:6:27: error: 256 is no code of a character\n"
     "    codes are 32 to 255; for others write the escape \\xAB: 92 120 and two digits\n"
     "t.ld:7:1: error: FORMATTED_STRING: the number of its codes is missing\n"
     "    write: FORMATTED_STRING variable count code ...\n"
     "t.ld:8:25: error: text: FORMATTED_STRING takes a decimal number here\n"
     "    LDmicro 2.3 has no variables in this place: write the number\n"},
    {"StringText",
     ld_file("FORMATTED_STRING (none) a b\nFORMATTED_STRING (none) \xE8\xA1\xA8", "LDmicro0.2"),
     "t.ld:4:27: error: FORMATTED_STRING: this follows the string, in which blanks stand as \\x20\n"
     "t.ld:5:25: error: FORMATTED_STRING: a character of more than 8 bits\n"
     "    write the bytes to send as escapes \\xAB\n"},
    {"Channels",
     ld_file("READ_ADC a\nREAD_ADC b\nREAD_ADC c\nREAD_ADC d\nREAD_ADC e\nREAD_ADC f\nREAD_ADC "
             "g\nREAD_ADC h\nREAD_ADC i"),
     "t.ld:12:10: error: READ_ADC i: one analogue channel more than the 8 that there are\n"
     "    read the channels that are left into the variables that have one\n"},
};
INSTANTIATE_TEST_SUITE_P(Operands, LdmicroRefused, testing::ValuesIn(kOperands), refused_file_name);

const RefusedFile kTails[] = {
    {"All",
     ld_file(
         "CONTACTS Xa 0 1\nCOIL R 0 0 0 1\nTON T 50000 1\nTOF T 50000 -2\nRTO T 50000 v\nCTU C 5 "
         "1\nCTD C 5 0 \\\n"
         "CTC C 5 0 o\nREAD_ADC A 1\nSET_PWM d 1000 P1 0-256\nSET_PWM d 1000 P2\nUART_SEND c 2 0\n"
         "UART_RECV c 1 1"),
     "t.ld:4:15: error: CONTACTS: start value 1 is LDmicro 5's, and changes what 2.3 does\n"
     "    write 0, and set the bit in a first scan with OSR and a coil\n"
     "t.ld:5:14: error: COIL: T-trigger 1 is LDmicro 5's, and changes what 2.3 does\n"
     "    write 0, and toggle with OSR, a contact and a negated coil\n"
     "t.ld:6:13: error: TON: adjustment 1 is LDmicro 5's, and changes what 2.3 does\n"
     "    change the delay instead, one CYCLE for each 1\n"
     "t.ld:7:13: error: TOF: adjustment -2 is LDmicro 5's, and changes what 2.3 does\n"
     "    change the delay instead, one CYCLE for each 1\n"
     "t.ld:8:13: error: RTO: adjustment v is LDmicro 5's, and changes what 2.3 does\n"
     "    change the delay instead, one CYCLE for each 1\n"
     "t.ld:9:9: error: CTU: initial value 1 is LDmicro 5's, and changes what 2.3 does\n"
     "    write 0, and set the variable in a first scan with OSR and MOVE\n"
     "t.ld:10:11: error: CTD: kind of input \\ is LDmicro 5's, and changes what 2.3 does\n"
     "    write /, and put OSF or a contact before the counter\n"
     "t.ld:11:11: error: CTC: kind of input o is LDmicro 5's, and changes what 2.3 does\n"
     "    write /, and put OSF or a contact before the counter\n"
     "t.ld:12:12: error: READ_ADC: reference voltage 1 is LDmicro 5's, and changes what 2.3 does\n"
     "    write 0: the board has one\n"
     "t.ld:13:19: error: SET_PWM: resolution 0-256 is LDmicro 5's, and changes what 2.3 does\n"
     "    write 0-100%, and scale the duty\n"
     "t.ld:14:16: error: SET_PWM: P2 is a second output beside P1\n"
     "    drive one PWM output\n"
     "t.ld:15:13: error: UART_SEND: size 2 is LDmicro 5's, and changes what 2.3 does\n"
     "    send and receive one byte at a time: write 1\n"
     "t.ld:16:15: error: UART_RECV: wait 1 is LDmicro 5's, and changes what 2.3 does\n"
     "    write 0: a scan does not wait\n"},
    {"In02", ld_file("TON T 50000 1\nTON T 50000 0 0", "LDmicro0.2"),
     "t.ld:4:13: error: TON: adjustment 1 is LDmicro 5's, and changes what 2.3 does\n"
     "    change the delay instead, one CYCLE for each 1\n"
     "t.ld:5:15: error: 0: more operands than TON takes\n"
     "    remove what does not belong to it\n"},
    {"Sizes",
     "LDmicro0.2\nVAR LIST\n  1 bytes c\n  2 bytes d\n  e signed 32 bit variable\n  3 bytes "
     "unused\nEND\n"
     "PROGRAM\nRUNG\nMOVE c e\nMOVE e d\nMOVE d c\nEND\n",
     "t.ld:3:11: error: c: a size of 8 bits; the variables of 2.3 have 16\n"
     "    give it 16 bits, or 2 bytes, if its values fit\n"
     "t.ld:5:3: error: e: a size of 32 bits; the variables of 2.3 have 16\n"
     "    give it 16 bits, or 2 bytes, if its values fit\n"},
};
INSTANTIATE_TEST_SUITE_P(Tails, LdmicroRefused, testing::ValuesIn(kTails), refused_file_name);

const RefusedFile kKeywords[] = {
    {"Placeholder", ld_file("PLACEHOLDER"),
     "t.ld:4:1: error: PLACEHOLDER: an empty place in the rung\n"
     "    put an element there, or delete the row\n"},
    {"Unknown", ld_file("contacts Xa 0\nFROB a\n\xE8\xA1\xA8"),
     "t.ld:4:1: error: contacts is no element of LDmicro\n"
     "    elements are written in capitals\n"
     "t.ld:5:1: error: FROB is no element of LDmicro\n"
     "t.ld:6:1: error: \xE8\xA1\xA8 is no element of LDmicro\n"},
    {"OfLDmicro5",
     ld_file("DELAY 100\nSLEEP\nGOTO 5\nODR\nOSC\nSTEPPER a\nTHI T 5\nCTR C 5 0 / 0\nBIN2BCD a b\n"
             "SPI a\n7SEGMENTS a\nMOD a b c\nNEG a b\nSHL a b 1\nXOR a b c\nRSFR a 1\nRANDOM a\n"
             "UART_RECV_AVAIL\nSTRING a\nPWM_OFF a\nTIME2COUNT a 5",
             "LDmicro0.2"),
     "t.ld:4:1: error: DELAY: a wait within the scan, which only LDmicro 5 has\n"
     "    let TON or RTO wait from scan to scan\n"
     "t.ld:5:1: error: SLEEP: a microcontroller's sleep, watchdog or halt, which only LDmicro 5 "
     "has\n"
     "    remove it: the controller has its own\n"
     "t.ld:6:1: error: GOTO: a jump or a subroutine, which only LDmicro 5 has\n"
     "    enable rungs with MASTER_RELAY, or with a contact in each\n"
     "t.ld:7:1: error: ODR: an edge of LDmicro 5, which only LDmicro 5 has\n"
     "    use OSR or OSF, behind a contact\n"
     "t.ld:8:1: error: OSC: an oscillator, which only LDmicro 5 has\n"
     "    use a negated contact, TON and TOF on one relay\n"
     "t.ld:9:1: error: STEPPER: a pulse output or input in hardware, which only LDmicro 5 has\n"
     "    write its steps with timers and counters where the scan is fast enough\n"
     "t.ld:10:1: error: THI: a timer of LDmicro 5, which only LDmicro 5 has\n"
     "    use TON, TOF and RTO with RES\n"
     "t.ld:11:1: error: CTR: a circular counter downwards, which only LDmicro 5 has\n"
     "    use CTD, a compare and MOVE\n"
     "t.ld:12:1: error: BIN2BCD: a conversion of LDmicro 5, which only LDmicro 5 has\n"
     "    use DIV, MUL and SUB, or a LOOK_UP_TABLE\n"
     "t.ld:13:1: error: SPI: a bus that the controller does not have, which only LDmicro 5 has\n"
     "    reach the device over the UART\n"
     "t.ld:14:1: error: 7SEGMENTS: a segment display, which only LDmicro 5 has\n"
     "    use a LOOK_UP_TABLE and one coil a segment\n"
     "t.ld:15:1: error: MOD: the remainder of a division, which only LDmicro 5 has\n"
     "    use DIV, MUL and SUB\n"
     "t.ld:16:1: error: NEG: a change of sign, which only LDmicro 5 has\n"
     "    use SUB from 0\n"
     "t.ld:17:1: error: SHL: a shift of bits, which only LDmicro 5 has\n"
     "    use MUL or DIV by a power of two\n"
     "t.ld:18:1: error: XOR: an operation on the bits of a variable, which only LDmicro 5 has\n"
     "    keep the bits as relays\n"
     "t.ld:19:1: error: RSFR: access to a microcontroller's registers, which only LDmicro 5 has\n"
     "    remove it: the processor has none of them\n"
     "t.ld:20:1: error: RANDOM: random numbers, which only LDmicro 5 has\n"
     "    use MUL and ADD on a variable that persists\n"
     "t.ld:21:1: error: UART_RECV_AVAIL: a state of the UART, which only LDmicro 5 has\n"
     "    use the conditions that UART_RECV and UART_SEND give\n"
     "t.ld:22:1: error: STRING: a string in memory, which only LDmicro 5 has\n"
     "    use FORMATTED_STRING\n"
     "t.ld:23:1: error: PWM_OFF: a PWM output of LDmicro 5, which only LDmicro 5 has\n"
     "    use SET_PWM, with duty 0 for off\n"
     "t.ld:24:1: error: TIME2COUNT: a conversion of times into waits, which only LDmicro 5 has\n"
     "    compute the number of scans: delay / CYCLE\n"},
};
INSTANTIATE_TEST_SUITE_P(Keywords, LdmicroRefused, testing::ValuesIn(kKeywords), refused_file_name);

const RefusedFile kStructure[] = {
    {"Empty", "\n\n",
     "t.ld:1:1: error: this is no LDmicro program: the line PROGRAM is not there\n"
     "    its rungs follow that line; if it was cut off, save it again\n"},
    {"NoProgram", "LDmicro0.1\nCYCLE=10000\n",
     "t.ld:1:1: error: this is no LDmicro program: the line PROGRAM is not there\n"
     "    its rungs follow that line; if it was cut off, save it again\n"},
    {"NoRung", "LDmicro0.1\nPROGRAM\n",
     "t.ld:1:1: error: the program has no rung\n"
     "    write RUNG and END at least\n"},
    {"RungNotEnded", "LDmicro0.1\nPROGRAM\nRUNG\nOSR\nRUNG\nPARALLEL\nSERIES\nOSR\n",
     "t.ld:3:1: error: RUNG: its END is not there before the RUNG of line 5\n"
     "    write END behind its last element\n"
     "t.ld:7:1: error: SERIES: its END is not there before the end of the file\n"
     "    write END behind its last element\n"},
    {"EndTooMuch", ld_file("OSR\nEND\nOSF\nSHORT"),
     "t.ld:6:1: error: OSF outside of a rung\n"
     "    elements stand between RUNG and its END\n"},
    {"EmptyParallel", ld_file("PARALLEL\nEND"),
     "t.ld:4:1: error: PARALLEL without a branch\n"
     "    put elements into it, or remove it\n"},
    {"ParallelInParallel", ld_file("PARALLEL\nPARALLEL\nOSR\nOSF\nEND\nEND"),
     "t.ld:5:1: error: PARALLEL as a branch of a PARALLEL\n"
     "    put its branches into the outer one, or put it into a SERIES\n"},
    {"MoreInALine", "LDmicro0.1\nPROGRAM\nRUNG x\nPARALLEL 1\nOSR\nEND 2\nEND 3\nRUNG 1 2\nEND\n",
     "t.ld:3:6: error: x: behind RUNG stands its number or nothing\n"
     "    write what follows in a line of its own\n"
     "t.ld:4:10: error: 1: PARALLEL stands alone in its line\n"
     "    write what follows in a line of its own\n"
     "t.ld:6:5: error: 2: END stands alone in its line\n"
     "    write what follows in a line of its own\n"
     "t.ld:7:5: error: 3: END stands alone in its line\n"
     "    write what follows in a line of its own\n"
     "t.ld:8:6: error: 1: behind RUNG stands its number or nothing\n"
     "    write what follows in a line of its own\n"},
    {"Numbers", "LDmicro0.1\nCYCLE=0\nCRYSTAL=fast\nBAUD=-1\nPROGRAM\nRUNG\nTON T 50000\nEND\n",
     "t.ld:2:1: error: CYCLE=0: the time from scan to scan in microseconds is 1 to 2147483647\n"
     "    write CYCLE=10000 for 10 ms\n"
     "t.ld:3:1: error: CRYSTAL=fast: this is 1 to 2147483647\n"
     "    write CRYSTAL=4000000, or leave the line out\n"
     "t.ld:4:1: error: BAUD=-1: this is 1 to 2147483647\n"
     "    write BAUD=2400, or leave the line out\n"},
    {"CycleBeyond32Bits", "CYCLE=2147483648\nPROGRAM\nRUNG\nEND\n",
     "t.ld:1:1: error: CYCLE=2147483648: the time from scan to scan in microseconds is 1 to "
     "2147483647\n"
     "    write CYCLE=10000 for 10 ms\n"},
    {"IoList", "IO LIST\nXa 5\nX-b at 5\nXc at 5x\nXd at -1\nPROGRAM\nRUNG\nEND\n",
     "t.ld:1:1: error: IO LIST: its END is not there\n"
     "    write END after its last line\n"
     "t.ld:2:1: error: Xa 5: no line of an IO LIST\n"
     "    write: name at pin; 0 is a pin that is not assigned yet\n"
     "t.ld:3:1: error: X-b at 5: no line of an IO LIST\n"
     "    write: name at pin; 0 is a pin that is not assigned yet\n"
     "t.ld:4:7: error: 5x is no pin's number\n"
     "    write the number of the pin, or 0\n"
     "t.ld:5:7: error: -1 is no pin's number\n"
     "    write the number of the pin, or 0\n"},
};
INSTANTIATE_TEST_SUITE_P(Structure, LdmicroRefused, testing::ValuesIn(kStructure),
                         refused_file_name);

TEST(LdmicroRefusals, PersistsBeyondTheLastingMemory) {
  std::string elements;
  for (int i = 0; i < 49; ++i) elements += "PERSIST a\n";
  const ParseResult result = parse_ld(ld_file(elements));
  EXPECT_FALSE(result.program);
  EXPECT_EQ(result.messages,
            "t.ld:52:1: error: PERSIST 49: the lasting memory keeps 48 values\n"
            "    keep fewer variables\n");
}

TEST(LdmicroRefusals, DepthIsLimited) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "PARALLEL\nSERIES\n";
    text += "OSR\n";
    for (int i = 0; i < depth; ++i) text += "END\nEND\n";
    return ld_file(text);
  };
  EXPECT_TRUE(parse_ld(nested(49)).program);
  EXPECT_EQ(parse_ld(nested(100000)).messages,
            "t.ld:103:1: error: SERIES nests deeper than 100\n"
            "    keep inner results in relays, in rungs of their own\n");
}

TEST(LdmicroRefusals, EndAfterAHundredErrors) {
  std::string elements;
  for (int i = 0; i < 10000; ++i) elements += "FROB\n";
  Diagnostics diagnostics;
  const auto source = decode_ldmicro(ld_file(elements), "t.ld", diagnostics);
  ASSERT_TRUE(source);
  EXPECT_FALSE(parse_ldmicro(*source, diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 101);
}

}  // namespace
}  // namespace rung
