// SPDX-License-Identifier: Apache-2.0
// Refused lists: operands that are not there, or do not fit.
#include <gtest/gtest.h>

#include "refused.hpp"

namespace rung {
namespace {

class RefusedOperands : public testing::TestWithParam<Refused> {};

TEST_P(RefusedOperands, SaysWhereWhatAndHowToMend) { expect_refused(GetParam()); }

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
     "    a device is a letter such as X, Y, M, D with a number: M10\n"},
    {"NotDecimal", "LD M1A\nOUT Y0\nLD SM4A\nOUT Y0\nEND", std::nullopt,
     "t:1:4: error: LD M1A: not a relay: its numbers are decimal in dialect fx\n"
     "    the devices are M0 to M7679\n"
     "t:3:4: error: LD SM4A: a special relay, which dialect fx does not have\n"
     "    if the program is for such a controller, use --dialect q\n"},
    {"NotDecimalSpecial", "LD SM4A\nOUT Y0\nEND", Dialect::Q,
     "t:1:4: error: LD SM4A: not a special relay: its number is decimal\n"},
    {"RangesOfFx",
     "LD X400\nOUT Y400\nOUT M7680\nMOV D8512 D0\nOUT M99999999999999999999\nLD T512\nOR C256\nOR "
     "S4096\nMOV R32768 V8\nMOV Z8 D0\nOUT Y0\nEND",
     std::nullopt,
     "t:1:4: error: LD X400: beyond the last device of dialect fx\n"
     "    the devices are X0 to X377\n"
     "t:2:5: error: OUT Y400: beyond the last device of dialect fx\n"
     "    the devices are Y0 to Y377\n"
     "t:3:5: error: OUT M7680: beyond the last device of dialect fx\n"
     "    the devices are M0 to M7679\n"
     "t:4:5: error: MOV D8512: beyond the last device of dialect fx\n"
     "    the devices are D0 to D7999\n"
     "t:5:5: error: OUT M99999999999999999999: beyond the last device of dialect fx\n"
     "    the devices are M0 to M7679\n"
     "t:6:4: error: LD T512: beyond the last device of dialect fx\n"
     "    the devices are T0 to T511\n"
     "t:7:4: error: OR C256: beyond the last device of dialect fx\n"
     "    the devices are C0 to C234\n"
     "t:8:4: error: OR S4096: beyond the last device of dialect fx\n"
     "    the devices are S0 to S4095\n"
     "t:9:5: error: MOV R32768: beyond the last device of dialect fx\n"
     "    the devices are R0 to R32767\n"
     "t:9:12: error: MOV V8: beyond the last device of dialect fx\n"
     "    the devices are V0 to V7\n"
     "t:10:5: error: MOV Z8: beyond the last device of dialect fx\n"
     "    the devices are Z0 to Z7\n"},
    {"RangesOfQ",
     "LD X2000\nOUT Y2000\nOUT M8192\n+ D12288 D0\nOUT ST2048 K1\nOUT C1024 K1\nOUT B2000\nMOV "
     "W2000 Z20\nEND",
     std::nullopt,
     "t:1:4: error: LD X2000: beyond the last device of dialect q\n"
     "    the devices are X0 to X1FFF\n"
     "t:2:5: error: OUT Y2000: beyond the last device of dialect q\n"
     "    the devices are Y0 to Y1FFF\n"
     "t:3:5: error: OUT M8192: beyond the last device of dialect q\n"
     "    the devices are M0 to M8191\n"
     "t:4:3: error: + D12288: beyond the last device of dialect q\n"
     "    the devices are D0 to D12287\n"
     "t:5:5: error: OUT ST2048: beyond the last device of dialect q\n"
     "    the devices are ST0 to ST2047\n"
     "t:6:5: error: OUT C1024: beyond the last device of dialect q\n"
     "    the devices are C0 to C1023\n"
     "t:7:5: error: OUT B2000: beyond the last device of dialect q\n"
     "    the devices are B0 to B1FFF\n"
     "t:8:5: error: MOV W2000: beyond the last device of dialect q\n"
     "    the devices are W0 to W1FFF\n"
     "t:8:11: error: MOV Z20: beyond the last device of dialect q\n"
     "    the devices are Z0 to Z19\n"},
    {"BitKinds",
     "LD D0\nAND K1\nORP K1M0\nOUT X0\nOUT D0\nOUT K5\nOUT K1M0\nSET X1\nSET T0\nRST X2\nRST "
     "K2\nPLS C0\nPLF D0.1\nALT X0\nMC N0 X0\nEND",
     std::nullopt,
     "t:1:4: error: LD D0: a word where a bit is read\n"
     "    name an X, Y or M\n"
     "t:2:5: error: AND K1: a constant where a bit is read\n"
     "    name an X, Y or M\n"
     "t:3:5: error: ORP K1M0: a digit group where a bit is named\n"
     "    name an X, Y or M\n"
     "t:4:5: error: OUT X0: an input, and inputs cannot be written\n"
     "    name a Y or M\n"
     "t:5:5: error: OUT D0: a word where a bit is written\n"
     "    name a Y or M; a word is written by MOV\n"
     "t:6:5: error: OUT K5: a constant cannot be written\n"
     "    name a Y or M\n"
     "t:7:5: error: OUT K1M0: a digit group where a bit is named\n"
     "    name a Y or M\n"
     "t:8:5: error: SET X1: an input, and inputs cannot be written\n"
     "    name a Y or M\n"
     "t:9:5: error: SET T0: a timer, which only OUT and RST name\n"
     "    name a Y or M\n"
     "t:10:5: error: RST X2: an input, and inputs cannot be written\n"
     "    name a Y or M\n"
     "t:11:5: error: RST K2: a constant cannot be written\n"
     "    name a Y or M\n"
     "t:12:5: error: PLS C0: a counter, which only OUT and RST name\n"
     "    name a Y or M\n"
     "t:13:5: error: PLF D0.1: a bit of a word, which is not supported here\n"
     "    name a Y or M\n"
     "t:14:5: error: ALT X0: an input, and inputs cannot be written\n"
     "    name a Y or M\n"
     "t:15:7: error: MC X0: an input, and inputs cannot be written\n"
     "    name a Y or M\n"},
    {"WordKinds",
     "LD X0\nMOV X0 D0\nMOV Y0 M1\nMOV D0 K5\nADD D0 D1 X1\nINC D0.1\nMUL D0 D1 K4M0\nDMOV V0 "
     "D0\nDMOV D0 Z0\nMUL D0 D1 Z0\nMOV P0 D0\nINC N0\nMOV C200 D0\nADD C0 K1 C234\nBMOV C200 D0 "
     "K1\nBMOV V0 D0 K1\nEND",
     Dialect::Fx,
     "t:2:5: error: MOV X0: an input where a word is read\n"
     "    name a D, or a constant such as K10\n"
     "t:3:5: error: MOV Y0: an output where a word is read\n"
     "    name a D, or a constant such as K10\n"
     "t:3:8: error: MOV M1: a relay where a word is written\n"
     "    this operand is a target: name a D\n"
     "t:4:8: error: MOV K5: a constant cannot be written\n"
     "    this operand is a target: name a D\n"
     "t:5:11: error: ADD X1: an input, and inputs cannot be written\n"
     "    this operand is a target: name a D\n"
     "t:6:5: error: INC D0.1: a bit where a word is named\n"
     "    this operand is a target: name a D\n"
     "t:7:11: error: MUL K4M0: a digit group, which is not supported here\n"
     "    this operand is a target: name a D\n"
     "t:8:6: error: DMOV V0: an index register has 16 bits and stands for itself\n"
     "    name a D, or a constant such as K10\n"
     "t:9:9: error: DMOV Z0: an index register has 16 bits and stands for itself\n"
     "    this operand is a target: name a D\n"
     "t:10:11: error: MUL Z0: an index register has 16 bits and stands for itself\n"
     "    this operand is a target: name a D\n"
     "t:11:5: error: MOV P0: a pointer or nesting level, which has no value\n"
     "    name a D, or a constant such as K10\n"
     "t:12:5: error: INC N0: a pointer or nesting level, which has no value\n"
     "    this operand is a target: name a D\n"
     "t:13:5: error: MOV C200: a counter of 32 bits where 16 are taken\n"
     "    use a 32-bit instruction (D form)\n"
     "t:14:11: error: ADD C234: a counter of 32 bits where 16 are taken\n"
     "    use a 32-bit instruction (D form)\n"
     "t:15:6: error: BMOV C200: a counter of 32 bits where 16 are taken\n"
     "    use a 32-bit instruction (D form)\n"
     "t:16:6: error: BMOV V0: an index register has 16 bits and stands for itself\n"
     "    name a D\n"},
    {"NoDevice", "LD FOO\nOUT Y\nLD CN200:H\nOUT Y0\nEND", std::nullopt,
     "t:1:4: error: LD FOO: not a device\n"
     "    a device is a letter such as X, Y, M, D with a number: M10\n"
     "t:2:5: error: OUT Y: not a device\n"
     "    a device is a letter such as X, Y, M, D with a number: M10\n"
     "t:3:4: error: LD CN200:H: not a device\n"
     "    a device is a letter such as X, Y, M, D with a number: M10\n"},
    {"OtherDialects", "LD L0\nOR B1F\nOR F1\nOR SM400\nOR STS1\nMOV W1A SD0\nMOV SW1 D0\nEND",
     Dialect::Fx,
     "t:1:4: error: LD L0: a latched relay, which dialect fx does not have\n"
     "    if the program is for such a controller, use --dialect q\n"
     "t:2:4: error: OR B1F: a link relay, which dialect fx does not have\n"
     "    if the program is for such a controller, use --dialect q\n"
     "t:3:4: error: OR F1: an annunciator, which dialect fx does not have\n"
     "    if the program is for such a controller, use --dialect q\n"
     "t:4:4: error: OR SM400: a special relay, which dialect fx does not have\n"
     "    if the program is for such a controller, use --dialect q\n"
     "t:5:4: error: OR STS1: a retentive timer, which dialect fx does not have\n"
     "    if the program is for such a controller, use --dialect q\n"
     "t:6:5: error: MOV W1A: a word, which dialect fx does not have\n"
     "    if the program is for such a controller, use --dialect q\n"
     "t:6:9: error: MOV SD0: a special register, which dialect fx does not have\n"
     "    if the program is for such a controller, use --dialect q\n"
     "t:7:5: error: MOV SW1: a word, which dialect fx does not have\n"
     "    if the program is for such a controller, use --dialect q\n"},
    {"OtherDialectsInQ", "LD X0\nMOV V0 D0\nOUT Y0\nEND", Dialect::Q,
     "t:2:5: error: MOV V0: an index register, which dialect q does not have\n"
     "    if the program is for such a controller, use --dialect fx\n"},
    {"Counts",
     "LD\nAND X0 X1\nOUT Y0 K5\nMOV D0\nMOV\nMOV D0 D1 D2\nADD D0 D1 D2 D3\nADD D0\nNOP D0\nOUT "
     "T0\nZCP D0 D1 D2\nSFTL X0 M0 K4\nEND",
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
     "    NOP takes no operand\n"
     "t:10:1: error: OUT: 1 of its operands is missing\n"
     "    OUT takes two operands: timer, preset\n"
     "t:11:1: error: ZCP: 1 of its operands is missing\n"
     "    ZCP takes four operands: source, source, source, first target\n"
     "t:12:1: error: SFTL: 1 of its operands is missing\n"
     "    SFTL takes four operands: first source, first target, count, count\n"},
    {"TwoOperandsInFx", "LD X0\nADD K1 D0\nWAND D0 D1\nEND", Dialect::Fx,
     "t:2:1: error: ADD: 1 of its operands is missing\n"
     "    write ADD D0 K1 D0, or use --dialect paper\n"
     "t:3:1: error: WAND: 1 of its operands is missing\n"
     "    write WAND D1 D0 D1, or use --dialect paper\n"},
    {"Constants",
     "LD X0\nMOV K32768 D0\nMOV K-32769 D0\nMOV H10000 D0\nMOV HFG D0\nMOV K D0\nMOV K1F D0\nMOV "
     "H-1 D0\nMOV K999999999999999999999 D0\nMOV 5 D0\nMOV -5 D0\nDMOV K2147483648 D0\nDMOV "
     "K-2147483649 D0\nDMOV H100000000 D0\nEND",
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
     "    a constant is written K-5\n"
     "t:12:6: error: DMOV K2147483648: more than 32 bits hold\n"
     "    K goes from -2147483648 to 2147483647\n"
     "t:13:6: error: DMOV K-2147483649: more than 32 bits hold\n"
     "    K goes from -2147483648 to 2147483647\n"
     "t:14:6: error: DMOV H100000000: more than 32 bits hold\n"
     "    H goes from 0 to FFFFFFFF\n"},
    {"SecondWordBeyondTheEnd",
     "LD X0\nMUL D0 D1 D7999\nDIV D0 D1 D7999\nDMOV D7999 D0\nDMUL D0 D2 D7997\nDMOV C199 D0\nDINC "
     "T511\nDMOV R32767 R0\nEND",
     std::nullopt,
     "t:2:11: error: MUL D7999: takes more devices than there are: the last one is D7999\n"
     "    name D7998 or below\n"
     "t:3:11: error: DIV D7999: takes more devices than there are: the last one is D7999\n"
     "    name D7998 or below\n"
     "t:4:6: error: DMOV D7999: takes more devices than there are: the last one is D7999\n"
     "    name D7998 or below\n"
     "t:5:12: error: DMUL D7997: takes more devices than there are: the last one is D7999\n"
     "    name D7996 or below\n"
     "t:6:6: error: DMOV C199: takes more devices than there are: the last one is C199\n"
     "    name C198 or below\n"
     "t:7:6: error: DINC T511: takes more devices than there are: the last one is T511\n"
     "    name T510 or below\n"
     "t:8:6: error: DMOV R32767: takes more devices than there are: the last one is R32767\n"
     "    name R32766 or below\n"},
    {"SecondWordBeyondTheEndInQ", "LD X0\n* D0 D12287\nEND", std::nullopt,
     "t:2:6: error: * D12287: takes more devices than there are: the last one is D12287\n"
     "    name D12286 or below\n"},
    {"Commas", "LD X0,\nMOV D0,D1\nMOV K1,D1\nEND", std::nullopt,
     "t:1:4: error: LD X0,: not a device\n"
     "    separate operands with blanks\n"
     "t:2:5: error: MOV D0,D1: not a device\n"
     "    separate operands with blanks\n"
     "t:3:5: error: MOV K1,D1: not a device\n"
     "    separate operands with blanks\n"},
    {"Digits",
     "LD X0\nMOV K5X0 D0\nMOV K0X0 D0\nDMOV K9X0 D0\nMOV K4X365 D0\nMOV D0 K1X0\nMOV K4D0 D0\nMOV "
     "K4T0 D0\nMOV K4M8000 D0\nMOV K4X0Z0 D0\nMOV K999999999999X0 D0\nMOV K4X8 D0\nWSFL K4M0 D0 K4 "
     "K1\nOUT T0 K4M0\nEND",
     std::nullopt,
     "t:2:5: error: MOV K5X0: a word of 16 bits takes 1 to 4 groups of four\n"
     "    write K1 to K4 before the device\n"
     "t:3:5: error: MOV K0X0: a word of 16 bits takes 1 to 4 groups of four\n"
     "    write K1 to K4 before the device\n"
     "t:4:6: error: DMOV K9X0: a word of 32 bits takes 1 to 8 groups of four\n"
     "    write K1 to K8 before the device\n"
     "t:5:5: error: MOV K4X365: takes more devices than there are: the last one is X377\n"
     "    name X360 or below\n"
     "t:6:8: error: MOV K1X0: an input, and inputs cannot be written\n"
     "    this operand is a target: name a D\n"
     "t:7:5: error: MOV K4D0: a digit group of a word\n"
     "    groups are taken of X, Y, M and the like: K4M0\n"
     "t:8:5: error: MOV K4T0: a digit group of a timer\n"
     "    groups are taken of X, Y, M and the like: K4M0\n"
     "t:9:5: error: MOV K4M8000: a special relay, whose neighbours mean other things\n"
     "    name it where one bit is read or written\n"
     "t:10:5: error: MOV K4X0Z0: a digit group with an index, which is not supported\n"
     "    move the group to a word first, or address words\n"
     "t:11:5: error: MOV K999999999999X0: a word of 16 bits takes 1 to 4 groups of four\n"
     "    write K1 to K4 before the device\n"
     "t:12:5: error: MOV K4X8: not an input: its numbers are octal (digits 0 to 7) in dialect fx\n"
     "    after X7 comes X10; for a list with hexadecimal X and Y use --dialect q\n"
     "t:13:6: error: WSFL K4M0: a digit group, which is not supported here\n"
     "    name a D\n"
     "t:14:8: error: OUT K4M0: a digit group, which is not supported here\n"
     "    name a D, or a constant such as K10\n"},
    {"WordBits",
     "LD D0.G\nAND D0.10\nOR M0.1\nOR Z0.1\nOR T0.1\nOR D0.\nPLS D0.1\nCMP K1 K2 D0.1\nOUT Y0\nEND",
     std::nullopt,
     "t:1:4: error: LD D0.G: not a bit of a word\n"
     "    the bits are .0 to .F\n"
     "t:2:5: error: AND D0.10: not a bit of a word\n"
     "    the bits are .0 to .F\n"
     "t:3:4: error: OR M0.1: a bit of a relay\n"
     "    bits are taken of data registers: D0.F\n"
     "t:4:4: error: OR Z0.1: a bit of an index register\n"
     "    bits are taken of data registers: D0.F\n"
     "t:5:4: error: OR T0.1: a bit of a timer\n"
     "    bits are taken of data registers: D0.F\n"
     "t:6:4: error: OR D0.: not a bit of a word\n"
     "    the bits are .0 to .F\n"
     "t:7:5: error: PLS D0.1: a bit of a word, which is not supported here\n"
     "    name a Y or M\n"
     "t:8:11: error: CMP D0.1: a bit of a word, which is not supported here\n"
     "    name a Y or M\n"},
    {"Indexes",
     "LDP X0Z0\nAND T0Z0\nOR M8000Z0\nOR X0Z8\nOUT T0Z0 K5\nSET S0Z0\nPLS M0Z0\nBMOV D0Z0 D1 "
     "K2\nMOV K5Z0 D0\nMOV V0Z0 D0\nSFTL X0 M0Z0 K4 K1\nZRST D0Z0 D5\nCMP K1 K2 M0Z0\nMOV D0Q0 "
     "D1\nOUT Y0\nEND",
     std::nullopt,
     "t:1:5: error: LDP X0Z0: an index is not supported here\n"
     "    index the contacts LD, AND, OR and their inverses, OUT, SET, RST, or a word that stands "
     "for itself\n"
     "t:2:5: error: AND T0Z0: a timer with an index, which is not supported\n"
     "    index a D, X, Y or M\n"
     "t:3:4: error: OR M8000Z0: a special relay, whose neighbours mean other things\n"
     "    name it where one bit is read or written\n"
     "t:4:4: error: OR X0Z8: beyond the last device of dialect fx\n"
     "    the devices are Z0 to Z7\n"
     "t:5:5: error: OUT T0Z0: a timer with an index, which is not supported\n"
     "    index a D, X, Y or M\n"
     "t:6:5: error: SET S0Z0: a state with an index, which is not supported\n"
     "    index a D, X, Y or M\n"
     "t:7:5: error: PLS M0Z0: an index is not supported here\n"
     "    index the contacts LD, AND, OR and their inverses, OUT, SET, RST, or a word that stands "
     "for itself\n"
     "t:8:6: error: BMOV D0Z0: an index is not supported here\n"
     "    index the contacts LD, AND, OR and their inverses, OUT, SET, RST, or a word that stands "
     "for itself\n"
     "t:9:5: error: MOV K5Z0: a constant with an index, which is not supported\n"
     "    add the index register to the constant in a register first\n"
     "t:10:5: error: MOV V0Z0: an index register with an index, which is not supported\n"
     "    index a D, X, Y or M\n"
     "t:11:9: error: SFTL M0Z0: an index is not supported here\n"
     "    index the contacts LD, AND, OR and their inverses, OUT, SET, RST, or a word that stands "
     "for itself\n"
     "t:12:6: error: ZRST D0Z0: an index is not supported here\n"
     "    index the contacts LD, AND, OR and their inverses, OUT, SET, RST, or a word that stands "
     "for itself\n"
     "t:13:11: error: CMP M0Z0: an index is not supported here\n"
     "    index the contacts LD, AND, OR and their inverses, OUT, SET, RST, or a word that stands "
     "for itself\n"
     "t:14:5: error: MOV D0Q0: not a device\n"
     "    a device is a letter such as X, Y, M, D with a number: M10\n"},
    {"InterruptLabel", "LD X0\nOUT Y0\nI10\nLD X1\nOUT Y1\nEND", std::nullopt,
     "t:3:1: error: I10: begins an interrupt program, which a constant scan cannot have\n"
     "    do the work in the scan: it is shorter than a usual interrupt period\n"},
};

INSTANTIATE_TEST_SUITE_P(Operands, RefusedOperands, testing::ValuesIn(kOperands), refused_name);

}  // namespace
}  // namespace rung
