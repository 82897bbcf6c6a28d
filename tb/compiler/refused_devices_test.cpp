// SPDX-License-Identifier: Apache-2.0
// Refused lists: rows and counts, and devices for what this controller does not have.
#include <gtest/gtest.h>

#include "refused.hpp"

namespace rung {
namespace {

class RefusedDevices : public testing::TestWithParam<Refused> {};

TEST_P(RefusedDevices, SaysWhereWhatAndHowToMend) { expect_refused(GetParam()); }

constexpr Refused kDevices[] = {
    {"CountsOfRows",
     "LD X0\nBMOV D0 D10 K0\nBMOV D0 D10 K513\nBMOV D0 D7999 K2\nBMOV D0 D10 D5\nFMOV K0 D7990 "
     "K11\nSFTL X0 M0 K4 K5\nSFTL X0 M0 K1025 K1\nSFTL X370 M0 K16 K9\nWSFR D0 D7999 K2 K1\nROL D0 "
     "K17\nROL D0 D1\nSFL D0 K16\nDROR D0 K33\nCMP K1 K2 M7678\nBMOV K4X0 K4M0 K17\nFMOV K0 D0 "
     "K-1\nEND",
     std::nullopt,
     "t:2:13: error: BMOV K0: a count that this instruction does not take\n"
     "    write K1 to K512\n"
     "t:3:13: error: BMOV K513: a count that this instruction does not take\n"
     "    write K1 to K512\n"
     "t:4:9: error: BMOV D7999: takes more devices than there are: the last one is D7999\n"
     "    name D7998 or below\n"
     "t:5:13: error: BMOV D5: a count that only the run shows: a constant scan needs a constant\n"
     "    write a constant such as K4\n"
     "t:6:9: error: FMOV D7990: takes more devices than there are: the last one is D7999\n"
     "    name D7989 or below\n"
     "t:7:15: error: SFTL K5: shifts by more than the 4 that there are\n"
     "    the last count may be at most the one before it\n"
     "t:8:12: error: SFTL K1025: a count that this instruction does not take\n"
     "    write K1 to K1024\n"
     "t:9:6: error: SFTL X370: takes more devices than there are: the last one is X377\n"
     "    name X367 or below\n"
     "t:10:9: error: WSFR D7999: takes more devices than there are: the last one is D7999\n"
     "    name D7998 or below\n"
     "t:11:8: error: ROL K17: a count that this instruction does not take\n"
     "    write K0 to K16\n"
     "t:12:8: error: ROL D1: a count that only the run shows: a constant scan needs a constant\n"
     "    write a constant such as K4\n"
     "t:13:8: error: SFL K16: a count that this instruction does not take\n"
     "    write K0 to K15\n"
     "t:14:9: error: DROR K33: a count that this instruction does not take\n"
     "    write K0 to K32\n"
     "t:15:11: error: CMP M7678: takes more devices than there are: the last one is M7679\n"
     "    name M7677 or below\n"
     "t:16:6: error: BMOV K4X0: takes more devices than there are: the last one is X377\n"
     "    there are not so many: write a smaller count\n"
     "t:17:12: error: FMOV K-1: a count that this instruction does not take\n"
     "    write K1 to K512\n"},
    {"CountsOfRowsInQ",
     "LD X0\nROL D0 K16\nDSFL D12287 K2\nBSFL M0 K0\nSFT M0\nBMOV D0 D10000 K3000\nEND", Dialect::Q,
     "t:2:8: error: ROL K16: a count that this instruction does not take\n"
     "    write K0 to K15\n"
     "t:3:6: error: DSFL D12287: takes more devices than there are: the last one is D12287\n"
     "    name D12286 or below\n"
     "t:4:9: error: BSFL K0: a count that this instruction does not take\n"
     "    write K1 to K32767\n"
     "t:5:5: error: SFT M0: takes the value of the bit before it, and there is none\n"
     "    name a device with a number from 1 on\n"
     "t:6:9: error: BMOV D10000: takes more devices than there are: the last one is D12287\n"
     "    name D9288 or below\n"},
    {"ResetRanges",
     "LD X0\nZRST X0 X5\nZRST M0 D5\nZRST C0 C200\nZRST V0 V1\nZRST M8000 M8005\nZRST K1 K2\nEND",
     std::nullopt,
     "t:2:6: error: ZRST X0: an input, and inputs cannot be written\n"
     "    name a Y, M, D, T or C\n"
     "t:2:9: error: ZRST X5: an input, and inputs cannot be written\n"
     "    name a Y, M, D, T or C\n"
     "t:3:9: error: ZRST D5: not of the kind that the first operand is\n"
     "    reset each kind with its own ZRST\n"
     "t:4:9: error: ZRST C200: a counter of another width than the first\n"
     "    reset each with its own ZRST\n"
     "t:5:6: error: ZRST V0: an index register, which is reset one by one\n"
     "    use RST\n"
     "t:5:9: error: ZRST V1: an index register, which is reset one by one\n"
     "    use RST\n"
     "t:6:6: error: ZRST M8000: driven by the controller and cannot be written\n"
     "    name a Y, M, D, T or C\n"
     "t:6:12: error: ZRST M8005: a special relay of the self-diagnosis of the maker's controller\n"
     "t:7:6: error: ZRST K1: a constant cannot be written\n"
     "    name a Y, M, D, T or C\n"
     "t:7:9: error: ZRST K2: a constant cannot be written\n"
     "    name a Y, M, D, T or C\n"},
    {"Presets",
     "LD X0\nOUT T0 K-1\nOUT T0 K32768\nOUT C0 X0\nOUT C200 K2147483648\nOUT T0 C200\nOUT C200 "
     "V0\nOUT T0 D5Z0\nOUT TN0 K5\nEND",
     std::nullopt,
     "t:2:8: error: OUT K-1: a preset below 0\n"
     "    write K1 to K32767\n"
     "t:3:8: error: OUT K32768: more than 16 bits hold\n"
     "    K goes from -32768 to 32767\n"
     "t:4:8: error: OUT X0: an input where a word is read\n"
     "    name a D, or a constant such as K10\n"
     "t:5:10: error: OUT K2147483648: more than 32 bits hold\n"
     "    K goes from -2147483648 to 2147483647\n"
     "t:6:8: error: OUT C200: a counter of 32 bits where 16 are taken\n"
     "    use a 32-bit instruction (D form)\n"
     "t:7:10: error: OUT V0: an index register has 16 bits and stands for itself\n"
     "    name a D, or a constant such as K10\n"
     "t:8:8: error: OUT D5Z0: an index is not supported here\n"
     "    index the contacts LD, AND, OR and their inverses, OUT, SET, RST, or a word that stands "
     "for itself\n"
     "t:9:5: error: OUT TN0: the value of a timer, not a timer or counter\n"
     "    name a timer (T) or counter (C)\n"},
    {"HighSpeedCounters", "LD X0\nOUT C235 K5\nDMOV C255 D0\nRST C251\nEND", std::nullopt,
     "t:2:5: error: OUT C235: a high-speed counter, hardware that this controller does not have\n"
     "t:3:6: error: DMOV C255: a high-speed counter, hardware that this controller does not have\n"
     "t:4:5: error: RST C251: a high-speed counter, hardware that this controller does not have\n"},
    {"SpecialsOfFx",
     "LD M8029\nOR M8147\nOR M8028\nOR M8015\nOR M8034\nOR M8236\nOR M8058\nOR M8122\nOR "
     "M8500\nSET M8039\nMOV K5 D8039\nMOV D8013 D0\nMOV D8010 D0\nMOV D8144 D0\nMOV D8100 D0\nOUT "
     "M8000\nOUT M8013\nSET M8002\nOUT M8009\nMOV M8000 D0\nEND",
     std::nullopt,
     "t:1:4: error: LD M8029: a special relay of \"instruction complete\" of positioning, pulse "
     "output and similar hardware, which this controller does not have\n"
     "t:2:4: error: OR M8147: a special relay of pulse output and positioning, hardware that this "
     "controller does not have\n"
     "t:3:4: error: OR M8028: a special relay of a mode of instructions that are not supported\n"
     "t:4:4: error: OR M8015: a special relay of the real-time clock, which this controller does "
     "not have\n"
     "t:5:4: error: OR M8034: a special relay of the operating mode of the maker's controller "
     "(battery, memory, RUN, STOP)\n"
     "t:6:4: error: OR M8236: a special relay of high-speed counters, hardware that this "
     "controller does not have\n"
     "t:7:4: error: OR M8058: a special relay of interrupts, which a constant scan cannot have\n"
     "t:8:4: error: OR M8122: a special relay of serial communication, which is not supported\n"
     "t:9:4: error: OR M8500: a special relay for something that this controller does not have\n"
     "    the special relays here are M8000 to M8003, M8011 to M8014, M8020 to M8022, M8067, M8068 "
     "and M8200 to M8234\n"
     "t:10:5: error: SET M8039: a special relay of constant scan, which is not set by the program "
     "here: every scan has the same period\n"
     "    set the scan period with --tick, and remove this\n"
     "t:11:8: error: MOV D8039: a special register of constant scan, which is not set by the "
     "program here: every scan has the same period\n"
     "    set the scan period with --tick, and remove this\n"
     "t:12:5: error: MOV D8013: a special register of the real-time clock, which this controller "
     "does not have\n"
     "t:13:5: error: MOV D8010: a special register of scan time; here it is constant, and rung "
     "compile tells it\n"
     "t:14:5: error: MOV D8144: a special register of pulse output and positioning, hardware that "
     "this controller does not have\n"
     "t:15:5: error: MOV D8100: a special register for something that this controller does not "
     "have\n"
     "t:16:5: error: OUT M8000: driven by the controller and cannot be written\n"
     "    name a Y or M\n"
     "t:17:5: error: OUT M8013: driven by the controller and cannot be written\n"
     "    name a Y or M\n"
     "t:18:5: error: SET M8002: driven by the controller and cannot be written\n"
     "    name a Y or M\n"
     "t:19:5: error: OUT M8009: a special relay of the self-diagnosis of the maker's controller\n"
     "t:20:5: error: MOV M8000: a relay where a word is read\n"
     "    name a D, or a constant such as K10\n"},
    {"SpecialsOfQ",
     "LD SM1880\nOR SM1840\nOR SM414\nOR SM213\nOR SM52\nOR SM9999\nOR SD1882.1\nMOV SD520 D0\nMOV "
     "SD412 D0\nMOV SD1880 D0\nMOV SD999 D0\nOUT SM400\nRST SM413\nEND",
     Dialect::Q,
     "t:1:4: error: LD SM1880: a special relay of the LCPU's built-in high-speed counter, hardware "
     "that this controller does not have\n"
     "t:2:4: error: OR SM1840: a special relay of pulse output and positioning, hardware that this "
     "controller does not have\n"
     "t:3:4: error: OR SM414: a special relay of a clock whose period is a parameter of the "
     "maker's controller\n"
     "    use SM409 to SM413, or a timer\n"
     "t:4:4: error: OR SM213: a special relay of the real-time clock, which this controller does "
     "not have\n"
     "t:5:4: error: OR SM52: a special relay of the self-diagnosis of the maker's controller\n"
     "t:6:4: error: OR SM9999: a special relay for something that this controller does not have\n"
     "    the special relays here are SM0, SM56, SM400 to SM403, SM409 to SM413 and SM700\n"
     "t:7:4: error: OR SD1882.1: a special register of the LCPU's built-in high-speed counter, "
     "hardware that this controller does not have\n"
     "t:8:5: error: MOV SD520: a special register of scan time; here it is constant, and rung "
     "compile tells it\n"
     "t:9:5: error: MOV SD412: a special register of a counter of clocks, which is not supported\n"
     "    count SM412 with a counter\n"
     "t:10:5: error: MOV SD1880: a special register of the LCPU's built-in high-speed counter, "
     "hardware that this controller does not have\n"
     "t:11:5: error: MOV SD999: a special register for something that this controller does not "
     "have\n"
     "t:12:5: error: OUT SM400: driven by the controller and cannot be written\n"
     "    name a Y or M\n"
     "t:13:5: error: RST SM413: driven by the controller and cannot be written\n"
     "    name a Y or M\n"},
    {"OfOtherHardware",
     "LD X0\nMOV ZR5 D0\nMOV E1.5 D0\nMOV U0\\G1 D0\nMOV \"AB\" D0\nMOV @D0 D1\nOUT DY0\nMOV TC0 "
     "D0\nMOV FD0 D0\nOUT BL0\nEND",
     std::nullopt,
     "t:2:5: error: MOV ZR5: a file register by its serial number, not supported yet\n"
     "    use R or D\n"
     "t:3:5: error: MOV E1.5: a floating-point constant, not supported yet\n"
     "t:4:5: error: MOV U0\\G1: in the memory of a module or network, which this controller does "
     "not have\n"
     "t:5:5: error: MOV \"AB\": a text constant, not supported yet\n"
     "t:6:5: error: MOV @D0: an indirect device, not supported yet\n"
     "t:7:5: error: OUT DY0: a direct output, not supported yet\n"
     "    use Y: outputs are refreshed once a scan\n"
     "t:8:5: error: MOV TC0: the coil of a timer, not supported yet\n"
     "    name the timer itself: T0\n"
     "t:9:5: error: MOV FD0: a function register, not supported yet\n"
     "    use words (D): subroutines have no operands here\n"
     "t:10:5: error: OUT BL0: an SFC block, not supported yet\n"
     "    use relays (M)\n"},
    {"Pointers",
     "LD X0\nCJ M0\nCJ 5\nCALL P4096\nMC N8 M0\nMC M0 M1\nMC P0 M1\nFOR D0\nNEXT\nFOR "
     "K0\nNEXT\nEND",
     std::nullopt,
     "t:2:4: error: CJ M0: not a pointer\n"
     "    name a pointer such as P10\n"
     "t:3:4: error: CJ 5: a number, not a device\n"
     "    a constant is written K5\n"
     "t:4:6: error: CALL P4096: beyond P4095\n"
     "    write P0 to P4095\n"
     "t:5:4: error: MC N8: beyond N7\n"
     "    write N0 to N7\n"
     "t:6:4: error: MC M0: not a nesting level\n"
     "    name a nesting level, N0 to N7\n"
     "t:7:4: error: MC P0: not a nesting level\n"
     "    name a nesting level, N0 to N7\n"
     "t:8:5: error: FOR D0: a loop whose count only the run shows: a constant scan needs a "
     "constant\n"
     "    write a constant such as K4\n"
     "t:10:5: error: FOR K0: a count that this instruction does not take\n"
     "    write K1 to K32767\n"},
};

INSTANTIATE_TEST_SUITE_P(Devices, RefusedDevices, testing::ValuesIn(kDevices), refused_name);

}  // namespace
}  // namespace rung
