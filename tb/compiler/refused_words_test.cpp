// SPDX-License-Identifier: Apache-2.0
// Refused lists: words that are no instructions, and instructions that are not there.
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
    {"StepNumberAlone", "LD X0\n5\nOUT Y0\n6 7 END", std::nullopt,
     "t:2:1: error: no instruction follows the step number 5\n"
     "    write the instruction after its number, on the same line\n"
     "t:4:1: error: no instruction follows the step number 6\n"
     "    write the instruction after its number, on the same line\n"},
    {"OtherForms",
     "LD X0\nE* D0 D2\nBK+ D0 D2 D4 K3\nB- D0 D2\nDB*P D0 D2 D4\nDEMOV D0 D2\nLDE<= D0 D2\nOUT "
     "Y0\nLD$= D0 D2\nOUT Y0\nEND",
     std::nullopt,
     "t:2:1: error: E*: floating-point arithmetic, not supported yet\n"
     "t:3:1: error: BK+: block arithmetic, not supported yet\n"
     "t:4:1: error: B-: BCD arithmetic, not supported yet\n"
     "t:5:1: error: DB*P: BCD arithmetic, not supported yet\n"
     "t:6:1: error: DEMOV: floating-point arithmetic, not supported yet\n"
     "    scale the values to 16-bit integers where that will do\n"
     "t:7:1: error: LDE<=: a compare contact on floating-point numbers, not supported yet\n"
     "t:9:1: error: LD$=: a compare contact on texts, not supported yet\n"},
    {"Control",
     "LD X0\nSCJ P1\nJMP P1\nGOEND\nFCALL P1\nBREAK D0 P1\nEI\nDI\nIRET\nIMASK D0\nWDT\nSTOP\nEGP "
     "V0\nOUT Y0\nEND",
     std::nullopt,
     "t:2:1: error: SCJ: a jump that waits for the next scan, not supported yet\n"
     "    use CJ\n"
     "t:3:1: error: JMP: a jump without a condition, not supported yet\n"
     "    use LD SM400 and CJ\n"
     "t:4:1: error: GOEND: a jump to the end, not supported yet\n"
     "    use CJ to a label before the end\n"
     "t:5:1: error: FCALL: a call that also switches outputs off or leaves the program, not "
     "supported yet\n"
     "    use CALL\n"
     "t:6:1: error: BREAK: a way out of a loop while it runs, which a constant scan cannot have\n"
     "    skip the rest of the body with CJ\n"
     "t:7:1: error: EI: a part of interrupt programs, which a constant scan cannot have\n"
     "    do the work in the scan: it is shorter than a usual interrupt period\n"
     "t:8:1: error: DI: a part of interrupt programs, which a constant scan cannot have\n"
     "    do the work in the scan: it is shorter than a usual interrupt period\n"
     "t:9:1: error: IRET: a part of interrupt programs, which a constant scan cannot have\n"
     "    do the work in the scan: it is shorter than a usual interrupt period\n"
     "t:10:1: error: IMASK: a part of interrupt programs, which a constant scan cannot have\n"
     "    do the work in the scan: it is shorter than a usual interrupt period\n"
     "t:11:1: error: WDT: a watchdog refresh in the scan, which a constant scan needs not\n"
     "    remove it\n"
     "t:12:1: error: STOP: an instruction to stop the controller, not supported yet\n"
     "t:13:1: error: EGP: an edge relay, not supported yet\n"
     "    use MEP or MEF, or PLS and PLF with relays\n"},
    {"WordOperations",
     "LD X0\nSFWR D0 D1 K5\nBXCH D0 D10 K3\nSMOV D0 K1 K2 D1 K3\nGRY D0 D1\nDECO D0 D1 K2\nPID D0 "
     "D1 D2 D3\nSIN D0 D2\n$MOV \"AB\" D0\nTRD D0\nEND",
     std::nullopt,
     "t:2:1: error: SFWR: a queue in data registers, not supported yet\n"
     "t:3:1: error: BXCH: a transfer of more than one word, not supported yet\n"
     "t:4:1: error: SMOV: a transfer of more than one word, not supported yet\n"
     "t:5:1: error: GRY: a conversion, not supported yet\n"
     "t:6:1: error: DECO: a data operation, not supported yet\n"
     "t:7:1: error: PID: a PID controller, not supported yet\n"
     "t:8:1: error: SIN: floating-point arithmetic, not supported yet\n"
     "    scale the values to 16-bit integers where that will do\n"
     "t:9:1: error: $MOV: an operation on texts, not supported yet\n"
     "t:10:1: error: TRD: an operation on a real-time clock, which this controller does not "
     "have\n"},
    {"Hardware",
     "LD X0\nPLSY K1 K2 Y0\nDPLSR K1 K2 K3 Y0\nDDRVI D0 D2 Y0 Y1\nHSCS D0 D2 Y0\nPWM D0 D1 "
     "Y0\nICPWM1 K1 K2\nIPSTOP1\nRS D0 K1 D2 K3\nG.READ U0 D0\nTO K0 K0 D0 K1\nDFROM K0 K0 D0 "
     "K1\nREF X0 K8\nSEGL D0 Y0\nRSET K0\nEND",
     std::nullopt,
     "t:2:1: error: PLSY: pulse output, positioning hardware that this controller does not have\n"
     "    use an external positioning unit and start it with an output (Y)\n"
     "t:3:1: error: DPLSR: pulse output, positioning hardware that this controller does not have\n"
     "    use an external positioning unit and start it with an output (Y)\n"
     "t:4:1: error: DDRVI: pulse output, positioning hardware that this controller does not have\n"
     "    use an external positioning unit and start it with an output (Y)\n"
     "t:5:1: error: HSCS: a high-speed counter instruction, hardware that this controller does not "
     "have\n"
     "t:6:1: error: PWM: pulse-width output, hardware that this controller does not have\n"
     "t:7:1: error: ICPWM1: for the LCPU's built-in high-speed counter, hardware that this "
     "controller does not have\n"
     "t:8:1: error: IPSTOP1: for the LCPU's built-in positioning, hardware that this controller "
     "does not have\n"
     "t:9:1: error: RS: serial communication, not supported yet\n"
     "t:10:1: error: G.READ: for an intelligent module or network, which this controller does not "
     "have\n"
     "t:11:1: error: TO: access to the memory of a special module, which this controller does not "
     "have\n"
     "t:12:1: error: DFROM: access to the memory of a special module, which this controller does "
     "not have\n"
     "t:13:1: error: REF: a refresh within the scan; here inputs and outputs are refreshed once a "
     "scan\n"
     "    remove it\n"
     "t:14:1: error: SEGL: for a keypad, display or similar unit, which this controller does not "
     "have\n"
     "t:15:1: error: RSET: for files and memory cards, which this controller does not have\n"},
    {"OtherDialect", "LD X0\nMV K1 D0\n+ K1 D0\n/ D0 D1\nEND", std::nullopt,
     "t:3:1: error: +: no instruction of dialect paper\n"
     "    write ADD, or use --dialect q\n"
     "t:4:1: error: /: no instruction of dialect paper\n"
     "    write DIV, or use --dialect q\n"},
    {"MvInFx", "LD X0\nMV K1 D0\nEND", Dialect::Fx,
     "t:2:1: error: MV: no instruction of dialect fx\n"
     "    write MOV\n"},
    {"AddInQ", "LD X0\nADD K1 D0\nSTL S0\nEND", Dialect::Q,
     "t:2:1: error: ADD: no instruction of dialect q\n"
     "    write +\n"
     "t:3:1: error: STL: no instruction of dialect q\n"
     "    use --dialect fx\n"},
    {"OfQInFx", "LD X0\nOUTH T0 K5\nWXNR D0 D1 D2\nSFT M5\nBSFL M0 K4\nDSFRP D0 K4\nEND",
     Dialect::Fx,
     "t:2:1: error: OUTH: no instruction of dialect fx\n"
     "    write OUT, or use --dialect q\n"
     "t:3:1: error: WXNR: no instruction of dialect fx\n"
     "    use --dialect q\n"
     "t:4:1: error: SFT: no instruction of dialect fx\n"
     "    use --dialect q\n"
     "t:5:1: error: BSFL: no instruction of dialect fx\n"
     "    use --dialect q\n"
     "t:6:1: error: DSFRP: no instruction of dialect fx\n"
     "    use --dialect q\n"},
    {"TimersInPaper", "LD X0\nOUT T0 K5\nRCL D0 K1\nSTL S0\nEND", Dialect::Paper,
     "t:2:5: error: OUT T0: a timer, which dialect paper does not have\n"
     "    if the program is for such a controller, use --dialect fx\n"
     "t:3:1: error: RCL: no instruction of dialect paper\n"
     "t:4:1: error: STL: no instruction of dialect paper\n"
     "    use --dialect fx\n"},
};

INSTANTIATE_TEST_SUITE_P(Words, RefusedWords, testing::ValuesIn(kWords), refused_name);

}  // namespace
}  // namespace rung
