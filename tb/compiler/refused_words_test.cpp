// SPDX-License-Identifier: Apache-2.0
// Refused lists: instructions that are not there and operands that do not fit.
#include <gtest/gtest.h>

#include "refused.hpp"

namespace rung {
namespace {

class RefusedWords : public testing::TestWithParam<Refused> {};

TEST_P(RefusedWords, SaysWhereWhatAndHowToMend) { expect_refused(GetParam()); }

constexpr Refused kWords[] = {
    {"Unknown", "LDD X0\nANDD X1\nOUTT Y0\nXYZZY Y0\nLD X0\nOUT Y0\nEND\n", std::nullopt,
     "t:1:1: error: LDD is not an instruction\n"
     "    did you mean LD?\n"
     "t:2:1: error: ANDD is not an instruction\n"
     "    did you mean AND?\n"
     "t:3:1: error: OUTT is not an instruction\n"
     "    did you mean OUT?\n"
     "t:4:1: error: XYZZY is not an instruction\n"},
    {"UnknownOnTheSameLine", "LD X0 FOO X1 OUT Y0 END", std::nullopt,
     "t:1:7: error: FOO is not an instruction\n"
     "    did you mean FOR?\n"},
    {"VeryLongWord", "QQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQ\nEND",
     std::nullopt,
     "t:1:1: error: QQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQQ... is not an instruction\n"},
    {"OperandFirst", "X0 LD\nLD X1\nOUT Y0\nEND", std::nullopt,
     "t:1:1: error: X0 is not an instruction\n"
     "    this is an operand: its instruction stands before it, on the same line\n"
     "t:1:4: error: LD: 1 of its operands is missing\n"
     "    LD takes one operand: the device\n"},
    {"Labels", "P0\nLD X0\nOUT Y0\nI10\nLD X1\nCALL P2\nEND", std::nullopt,
     "t:1:1: error: P0: a label; jumps, subroutines and interrupts are not supported yet\n"
     "t:4:1: error: I10: a label; jumps, subroutines and interrupts are not supported yet\n"
     "t:6:1: error: CALL: a subroutine call, not supported yet\n"},
    {"StepNumberAlone", "LD X0\n5\nOUT Y0\n6 7 END", std::nullopt,
     "t:2:1: error: no instruction follows the step number 5\n"
     "    write the instruction after its number, on the same line\n"
     "t:4:1: error: no instruction follows the step number 6\n"
     "    write the instruction after its number, on the same line\n"},
    {"EdgesAndCompares",
     "LDP X0\nANDF X1\nORP X2\nOUT Y0\nLD= D0 D1\nANDD> D0 D2\nORE<= D0 D2\nINV\nMEP\nOUT Y1\nEND",
     std::nullopt,
     "t:1:1: error: LDP: an edge contact, not supported yet\n"
     "t:2:1: error: ANDF: an edge contact, not supported yet\n"
     "t:3:1: error: ORP: an edge contact, not supported yet\n"
     "t:5:1: error: LD=: a compare contact, not supported yet\n"
     "t:6:1: error: ANDD>: a compare contact, not supported yet\n"
     "t:7:1: error: ORE<=: a compare contact, not supported yet\n"
     "t:8:1: error: INV: the inversion of a result, not supported yet\n"
     "    write the inverse logic: swap AND with OR and each contact with its inverse\n"
     "t:9:1: error: MEP: the edge of a result, not supported yet\n"},
    {"OtherForms",
     "LD X0\nMOVP K1 D0\nDMOV D0 D2\nDMOVP D0 D2\nD+ D0 D2\n+P K1 D0\nD/P D0 D2 D4\nE* D0 D2\nBK+ "
     "D0 D2 D4 K3\nB- D0 D2\nEND",
     std::nullopt,
     "t:2:1: error: MOVP: the pulse form of MOV, not supported yet\n"
     "t:3:1: error: DMOV: the 32-bit form of MOV, not supported yet\n"
     "t:4:1: error: DMOVP: the 32-bit pulse form of MOV, not supported yet\n"
     "t:5:1: error: D+: 32-bit arithmetic, not supported yet\n"
     "t:6:1: error: +P: the pulse form of +, not supported yet\n"
     "t:7:1: error: D/P: 32-bit arithmetic in its pulse form, not supported yet\n"
     "t:8:1: error: E*: floating-point arithmetic, not supported yet\n"
     "t:9:1: error: BK+: block arithmetic, not supported yet\n"
     "t:10:1: error: B-: BCD arithmetic, not supported yet\n"},
    {"CoilsAndControl",
     "LD X0\nPLS M0\nOUTI Y0\nOUTH T0 K5\nMC N0 M0\nLD X0\nOUT Y1\nMCR N0\nLD X0\nCJ P1\nFEND\nFOR "
     "K3\nNEXT\nEI\nWDT\nEND",
     std::nullopt,
     "t:2:1: error: PLS: a pulse coil, not supported yet\n"
     "t:3:1: error: OUTI: LadderDrive's inverted coil, not supported yet\n"
     "    invert the logic before an OUT\n"
     "t:4:1: error: OUTH: a high-speed timer coil, not supported yet\n"
     "t:5:1: error: MC: master control, not supported yet\n"
     "    put the zone's condition into each network\n"
     "t:8:1: error: MCR: master control, not supported yet\n"
     "t:10:1: error: CJ: a jump, not supported yet\n"
     "t:11:1: error: FEND: a part of subroutines, not supported yet\n"
     "    a main program ends with END\n"
     "t:12:1: error: FOR: a loop, not supported yet\n"
     "    write its body as often as it runs\n"
     "t:13:1: error: NEXT: a loop, not supported yet\n"
     "    write its body as often as it runs\n"
     "t:14:1: error: EI: a part of interrupt programs, which a constant scan cannot have\n"
     "    do the work in the scan: it is shorter than a usual interrupt period\n"
     "t:15:1: error: WDT: a watchdog refresh in the scan, which a constant scan needs not\n"
     "    remove it\n"},
    {"WordOperations",
     "LD X0\nINC D0\nCMP D0 D1 M0\nWAND D0 D1 D2\nROL D0 K1\nZRST D0 D5\nBCD D0 D1\nDECO D0 D1 "
     "K2\nPID D0 D1 D2 D3\nSIN D0 D2\n$MOV \"AB\" D0\nTRD D0\nEND",
     std::nullopt,
     "t:2:1: error: INC: an increment, not supported yet\n"
     "    add or subtract K1 instead\n"
     "t:3:1: error: CMP: a compare, not supported yet\n"
     "t:4:1: error: WAND: bit-wise logic of words, not supported yet\n"
     "t:5:1: error: ROL: a shift or rotation, not supported yet\n"
     "t:6:1: error: ZRST: a transfer of more than one word, not supported yet\n"
     "t:7:1: error: BCD: a conversion, not supported yet\n"
     "t:8:1: error: DECO: a data operation, not supported yet\n"
     "t:9:1: error: PID: a PID controller, not supported yet\n"
     "t:10:1: error: SIN: floating-point arithmetic, not supported yet\n"
     "    scale the values to 16-bit integers where that will do\n"
     "t:11:1: error: $MOV: an operation on texts, not supported yet\n"
     "t:12:1: error: TRD: an operation on a real-time clock, which this controller does not "
     "have\n"},
    {"Hardware",
     "LD X0\nPLSY K1 K2 Y0\nDDRVI D0 D2 Y0 Y1\nHSCS D0 D2 Y0\nPWM D0 D1 Y0\nICPWM1 K1 "
     "K2\nIPSTOP1\nRS D0 K1 D2 K3\nG.READ U0 D0\nTO K0 K0 D0 K1\nREF X0 K8\nSEGL D0 Y0\nRSET "
     "K0\nEND",
     std::nullopt,
     "t:2:1: error: PLSY: pulse output, positioning hardware that this controller does not have\n"
     "    use an external positioning unit and start it with an output (Y)\n"
     "t:3:1: error: DDRVI: pulse output, positioning hardware that this controller does not have\n"
     "    use an external positioning unit and start it with an output (Y)\n"
     "t:4:1: error: HSCS: a high-speed counter instruction, hardware that this controller does not "
     "have\n"
     "t:5:1: error: PWM: pulse-width output, hardware that this controller does not have\n"
     "t:6:1: error: ICPWM1: for the LCPU's built-in high-speed counter, hardware that this "
     "controller does not have\n"
     "t:7:1: error: IPSTOP1: for the LCPU's built-in positioning, hardware that this controller "
     "does not have\n"
     "t:8:1: error: RS: serial communication, not supported yet\n"
     "t:9:1: error: G.READ: for an intelligent module or network, which this controller does not "
     "have\n"
     "t:10:1: error: TO: access to the memory of a special module, which this controller does not "
     "have\n"
     "t:11:1: error: REF: a refresh within the scan; here inputs and outputs are refreshed once a "
     "scan\n"
     "    remove it\n"
     "t:12:1: error: SEGL: for a keypad, display or similar unit, which this controller does not "
     "have\n"
     "t:13:1: error: RSET: for files and memory cards, which this controller does not have\n"},
    {"StepLadder", "STL S0\nOUT Y0\nLD X0\nSET S1\nRET\nEND", std::nullopt,
     "t:1:1: error: STL: a part of step ladder programs, not supported yet\n"
     "    use a relay (M) a step, with SET and RST\n"
     "t:4:5: error: SET S1: a step relay, not supported yet\n"
     "    use a relay (M)\n"
     "t:5:1: error: RET: a part of step ladder programs, not supported yet\n"
     "    use a relay (M) a step, with SET and RST\n"},
    {"OtherDialect", "LD X0\nMV K1 D0\n+ K1 D0\n/ D0 D1\nEND", std::nullopt,
     "t:3:1: error: +: no instruction of dialect paper\n"
     "    write ADD, or use --dialect q\n"
     "t:4:1: error: /: no instruction of dialect paper\n"
     "    write DIV, or use --dialect q\n"},
    {"MvInFx", "LD X0\nMV K1 D0\nEND", Dialect::Fx,
     "t:2:1: error: MV: no instruction of dialect fx\n"
     "    write MOV\n"},
    {"AddInQ", "LD X0\nADD K1 D0\nEND", Dialect::Q,
     "t:2:1: error: ADD: no instruction of dialect q\n"
     "    write +\n"},
};

constexpr Refused kOperands[] = {
    {"NotOctal", "LD X8\nOUT Y19\nLD X1F\nOUT Y0\nEND", std::nullopt,
     "t:1:4: error: LD X8: not an input: its numbers are octal (digits 0 to 7) in dialect fx\n"
     "    after X7 comes X10; for a list with hexadecimal X and Y use --dialect q\n"
     "t:2:5: error: OUT Y19: not an output: its numbers are octal (digits 0 to 7) in dialect fx\n"
     "    after Y7 comes Y10; for a list with hexadecimal X and Y use --dialect q\n"
     "t:3:4: error: LD X1F: not an input: its numbers are octal (digits 0 to 7) in dialect fx\n"
     "    after X7 comes X10; for a list with hexadecimal X and Y use --dialect q\n"},
    {"NotHexadecimal", "LD X1G\nOUT Y0\nEND", Dialect::Q,
     "t:1:4: error: LD X1G: not a device\n"
     "    the devices are X, Y, M and D with a number, such as M10\n"},
    {"NotDecimal", "LD M1A\nOUT Y0\nEND", std::nullopt,
     "t:1:4: error: LD M1A: not a relay: its numbers are decimal in dialect fx\n"
     "    the devices are M0 to M7679\n"},
    {"RangesOfFx",
     "LD X400\nOUT Y400\nOUT M7680\nOUT M8000\nMOV D8000 D7999\nMOV D8512 D0\nOUT "
     "M99999999999999999999\nEND",
     std::nullopt,
     "t:1:4: error: LD X400: beyond the last device of dialect fx\n"
     "    the devices are X0 to X377\n"
     "t:2:5: error: OUT Y400: beyond the last device of dialect fx\n"
     "    the devices are Y0 to Y377\n"
     "t:3:5: error: OUT M7680: beyond the last device of dialect fx\n"
     "    the devices are M0 to M7679\n"
     "t:4:5: error: OUT M8000: a special relay, not supported yet\n"
     "t:5:5: error: MOV D8000: a special register, not supported yet\n"
     "t:6:5: error: MOV D8512: beyond the last device of dialect fx\n"
     "    the devices are D0 to D7999\n"
     "t:7:5: error: OUT M99999999999999999999: beyond the last device of dialect fx\n"
     "    the devices are M0 to M7679\n"},
    {"RangesOfQ", "LD X2000\nOUT Y2000\nOUT M8192\n+ D12288 D0\nEND", std::nullopt,
     "t:1:4: error: LD X2000: beyond the last device of dialect q\n"
     "    the devices are X0 to X1FFF\n"
     "t:2:5: error: OUT Y2000: beyond the last device of dialect q\n"
     "    the devices are Y0 to Y1FFF\n"
     "t:3:5: error: OUT M8192: beyond the last device of dialect q\n"
     "    the devices are M0 to M8191\n"
     "t:4:3: error: + D12288: beyond the last device of dialect q\n"
     "    the devices are D0 to D12287\n"},
    {"Kinds",
     "LD D0\nAND K1\nOUT X0\nOUT D0\nOUT K5\nSET X1\nRST X2\nRST K2\nMOV X0 D0\nMOV Y0 M1\nMOV D0 "
     "K5\nADD D0 D1 X1\nEND",
     std::nullopt,
     "t:1:4: error: LD D0: a word where a bit is read\n"
     "    name an X, Y or M\n"
     "t:2:5: error: AND K1: a constant where a bit is read\n"
     "    name an X, Y or M\n"
     "t:3:5: error: OUT X0: an input, and inputs cannot be written\n"
     "    name a Y or M\n"
     "t:4:5: error: OUT D0: a word where a bit is written\n"
     "    name a Y or M; a word is written by MOV\n"
     "t:5:5: error: OUT K5: a constant cannot be written\n"
     "    name a Y or M\n"
     "t:6:5: error: SET X1: an input, and inputs cannot be written\n"
     "    name a Y or M\n"
     "t:7:5: error: RST X2: an input, and inputs cannot be written\n"
     "    name a Y or M\n"
     "t:8:5: error: RST K2: a constant cannot be written\n"
     "    name a Y or M\n"
     "t:9:5: error: MOV X0: an input where a word is read\n"
     "    name a D, or a constant such as K10\n"
     "t:10:5: error: MOV Y0: an output where a word is read\n"
     "    name a D, or a constant such as K10\n"
     "t:10:8: error: MOV M1: a relay where a word is written\n"
     "    the last operand is the target: name a D\n"
     "t:11:8: error: MOV K5: a constant cannot be written\n"
     "    the last operand is the target: name a D\n"
     "t:12:11: error: ADD X1: an input where a word is written\n"
     "    the last operand is the target: name a D\n"},
    {"NoDevice", "LD FOO\nOUT Y\nEND", std::nullopt,
     "t:1:4: error: LD FOO: not a device\n"
     "    the devices are X, Y, M and D with a number, such as M10\n"
     "t:2:5: error: OUT Y: not a device\n"
     "    the devices are X, Y, M and D with a number, such as M10\n"},
    {"Counts",
     "LD\nAND X0 X1\nOUT Y0 K5\nMOV D0\nMOV\nMOV D0 D1 D2\nADD D0 D1 D2 D3\nADD D0\nNOP D0\nEND",
     std::nullopt,
     "t:1:1: error: LD: 1 of its operands is missing\n"
     "    LD takes one operand: the device\n"
     "t:2:8: error: AND X1: one operand too many\n"
     "    AND takes one operand: the device\n"
     "t:3:8: error: OUT K5: one operand too many\n"
     "    OUT takes one operand: the device\n"
     "t:4:1: error: MOV: 1 of its operands is missing\n"
     "    MOV takes two operands: source, target\n"
     "t:5:1: error: MOV: 2 of its operands are missing\n"
     "    MOV takes two operands: source, target\n"
     "t:6:11: error: MOV D2: one operand too many\n"
     "    MOV takes two operands: source, target\n"
     "t:7:14: error: ADD D3: one operand too many\n"
     "    ADD takes three operands: source, source, target\n"
     "t:8:1: error: ADD: 2 of its operands are missing\n"
     "    ADD takes three operands: source, source, target\n"
     "t:9:5: error: NOP D0: one operand too many\n"
     "    NOP takes no operand\n"},
    {"TwoOperandsInFx", "LD X0\nADD K1 D0\nEND", Dialect::Fx,
     "t:2:1: error: ADD: 1 of its operands is missing\n"
     "    write ADD D0 K1 D0, or use --dialect paper\n"},
    {"Constants",
     "LD X0\nMOV K32768 D0\nMOV K-32769 D0\nMOV H10000 D0\nMOV HFG D0\nMOV K D0\nMOV K1F D0\nMOV "
     "H-1 D0\nMOV K999999999999999999999 D0\nMOV 5 D0\nMOV -5 D0\nEND",
     std::nullopt,
     "t:2:5: error: MOV K32768: more than 16 bits hold\n"
     "    K goes from -32768 to 32767\n"
     "t:3:5: error: MOV K-32769: more than 16 bits hold\n"
     "    K goes from -32768 to 32767\n"
     "t:4:5: error: MOV H10000: more than 16 bits hold\n"
     "    H goes from 0 to FFFF\n"
     "t:5:5: error: MOV HFG: not a constant\n"
     "    decimal constants are written K10 or K-10, hexadecimal ones H0A\n"
     "t:6:5: error: MOV K: not a constant\n"
     "    decimal constants are written K10 or K-10, hexadecimal ones H0A\n"
     "t:7:5: error: MOV K1F: not a constant\n"
     "    decimal constants are written K10 or K-10, hexadecimal ones H0A\n"
     "t:8:5: error: MOV H-1: not a constant\n"
     "    decimal constants are written K10 or K-10, hexadecimal ones H0A\n"
     "t:9:5: error: MOV K999999999999999999999: more than 16 bits hold\n"
     "    K goes from -32768 to 32767\n"
     "t:10:5: error: MOV 5: a number, not a device\n"
     "    a constant is written K5\n"
     "t:11:5: error: MOV -5: a number, not a device\n"
     "    a constant is written K-5\n"},
    {"SecondWordBeyondTheEnd", "LD X0\nMUL D0 D1 D7999\nDIV D0 D1 D7999\nEND", std::nullopt,
     "t:2:11: error: MUL D7999: the result takes two words, and there is none after this\n"
     "    name D7998 or below\n"
     "t:3:11: error: DIV D7999: the result takes two words, and there is none after this\n"
     "    name D7998 or below\n"},
    {"SecondWordBeyondTheEndInQ", "LD X0\n* D0 D12287\nEND", std::nullopt,
     "t:2:6: error: * D12287: the result takes two words, and there is none after this\n"
     "    name D12286 or below\n"},
    {"Commas", "LD X0,\nMOV D0,D1\nMOV K1,D1\nEND", std::nullopt,
     "t:1:4: error: LD X0,: not a device\n"
     "    separate operands with blanks\n"
     "t:2:5: error: MOV D0,D1: not a device\n"
     "    separate operands with blanks\n"
     "t:3:5: error: MOV K1,D1: not a device\n"
     "    separate operands with blanks\n"},
    {"BitsNotYet",
     "LD T0\nAND C5\nOUT C235\nLD SM400\nOR SD1882.1\nOUT S5\nLD L0\nOR B1F\nOUT F1\nOUT D0.1\nOUT "
     "T0 K50\nRST T0\nEND",
     std::nullopt,
     "t:1:4: error: LD T0: a timer, not supported yet\n"
     "t:2:5: error: AND C5: a counter, not supported yet\n"
     "t:3:5: error: OUT C235: a high-speed counter, hardware that this controller does not have\n"
     "t:4:4: error: LD SM400: a special relay, not supported yet\n"
     "t:5:4: error: OR SD1882.1: a bit of a word, not supported yet\n"
     "t:6:5: error: OUT S5: a step relay, not supported yet\n"
     "    use a relay (M)\n"
     "t:7:4: error: LD L0: a latch relay, not supported yet\n"
     "    use a relay (M)\n"
     "t:8:4: error: OR B1F: a link relay, not supported yet\n"
     "    use a relay (M)\n"
     "t:9:5: error: OUT F1: an annunciator, not supported yet\n"
     "    use a relay (M)\n"
     "t:10:5: error: OUT D0.1: a bit of a word, not supported yet\n"
     "t:11:5: error: OUT T0: a timer, not supported yet\n"
     "t:12:5: error: RST T0: a timer, not supported yet\n"},
    {"WordsNotYet",
     "LD X0\nMOV K2X0 D0\nMOV D0Z1 D1\nMOV W1A D0\nMOV R0 D0\nMOV ZR5 D0\nMOV E1.5 D0\nMOV U0\\G1 "
     "D0\nMOV \"AB\" D0\nMOV @D0 D1\nMOV V0 D0\nMOV Z1 D0\nMOV TN0 D0\nEND",
     std::nullopt,
     "t:2:5: error: MOV K2X0: a group of bits used as a word, not supported yet\n"
     "t:3:5: error: MOV D0Z1: an indexed device, not supported yet\n"
     "t:4:5: error: MOV W1A: a link register, not supported yet\n"
     "    use a word (D)\n"
     "t:5:5: error: MOV R0: a file register, not supported yet\n"
     "    use a word (D)\n"
     "t:6:5: error: MOV ZR5: a file register, not supported yet\n"
     "    use a word (D)\n"
     "t:7:5: error: MOV E1.5: a floating-point constant, not supported yet\n"
     "t:8:5: error: MOV U0\\G1: in the memory of a module or network, which this controller does "
     "not have\n"
     "t:9:5: error: MOV \"AB\": a text constant, not supported yet\n"
     "t:10:5: error: MOV @D0: an indirect device, not supported yet\n"
     "t:11:5: error: MOV V0: an index register or edge relay, not supported yet\n"
     "t:12:5: error: MOV Z1: an index register, not supported yet\n"
     "t:13:5: error: MOV TN0: a timer, not supported yet\n"},
};

INSTANTIATE_TEST_SUITE_P(Words, RefusedWords, testing::ValuesIn(kWords), refused_name);
INSTANTIATE_TEST_SUITE_P(Operands, RefusedWords, testing::ValuesIn(kOperands), refused_name);

}  // namespace
}  // namespace rung
