// SPDX-License-Identifier: Apache-2.0
// The C back end: every element of LDmicro's programs.
#include <gtest/gtest.h>

#include "c_story.hpp"

namespace rung {
namespace {

constexpr Dialect kLd = Dialect::Ldmicro;

constexpr CStory kRungs[] = {
    {"Contacts", "CONTACTS Xa 0, CONTACTS Xb 1, COIL Yo 0 0 0", "Xa=1 | Xb=1 | Xa=0 Xb=0",
     "Yo=1 | Yo=0 | Yo=0", kLd},
    {"Coils",
     "CONTACTS Xa 0, COIL Yn 1 0 0, COIL Ys 0 1 0, COIL Ro 0 0 0; CONTACTS Xb 0, COIL Ys 0 0 1",
     "| Xa=1 | Xa=0 | Xb=1", "Yn=1 Ys=0 Ro=0 | Yn=0 Ys=1 Ro=1 | Yn=1 Ys=1 Ro=0 | Ys=0", kLd},
    {"Branches",
     "CONTACTS Xa 0, PARALLEL, SERIES, CONTACTS Xb 0, COIL R1 0 0 0, OPEN, END, CONTACTS R1 0, "
     "SERIES, CONTACTS Xc 0, PARALLEL, CONTACTS Xd 0, CONTACTS Xe 1, END, END, END, COIL Yo 0 0 0",
     "Xa=1 | Xb=1 | Xb=0 Xc=1 | Xe=1 | Xd=1 | Xa=0",
     "Yo=0 R1=0 | Yo=1 R1=1 | Yo=1 R1=0 | Yo=0 | Yo=1 | Yo=0", kLd},
    {"ShortAndOpen", "SHORT, COIL Ya 0 0 0, OPEN, COIL Yb 0 0 0; COMMENT c", "|",
     "Ya=1 Yb=0 | Ya=1 Yb=0", kLd},
    {"Edges", "CONTACTS Xa 0, OSR, COIL Yr 0 0 0; CONTACTS Xa 0, OSF, COIL Yf 0 0 0",
     "Xa=1 | | Xa=0 | ", "Yr=1 Yf=0 | Yr=0 Yf=0 | Yr=0 Yf=1 | Yf=0", kLd},
    {"MasterRelay",
     "CONTACTS Xa 0, MASTER_RELAY; COIL Y1 0 0 0; CONTACTS Xb 0, MASTER_RELAY; COIL Y2 0 0 0",
     "| Xa=1 | Xb=1 | Xa=0", "Y1=0 Y2=1 | Y1=1 Y2=0 | Y1=1 Y2=1 | Y1=0 Y2=1", kLd},
    {"BitAndVariable", "CONTACTS for 0, ADD for for 1; CONTACTS Xa 0, COIL for 0 0 0",
     "Xa=1 | for:w=-5 | Xa=0 |", "for=1 for:w=0 | for:w=-4 | for:w=-3 for=0 | for:w=-3", kLd},
    {"NamesOfC",
     "ADD INT16_MAX INT16_MAX 1, MOVE divided 7, COIL plc 0 0 0, COIL edge 0 0 0, OSR, "
     "MOVE PlcCycle 3, MOVE int divided, COIL _9 1 0 0",
     "|", "INT16_MAX=1 divided=7 plc=1 edge=1 PlcCycle=3 int=7 _9=0 | INT16_MAX=2", kLd},
};

constexpr CStory kCounts[] = {
    {"Ton", "CONTACTS Xa 0, TON T 30000, COIL Yo 0 0 0", "Xa=1 | | | | Xa=0 | Xa=1 T=9",
     "T=1 Yo=0 | T=2 Yo=0 | T=2 Yo=1 | Yo=1 | T=0 Yo=0 | T=9 Yo=1", kLd},
    {"Tof", "CONTACTS Xa 0, TOF T 30000, COIL Yo 0 0 0", "| Xa=1 | Xa=0 | | | T=-1",
     "T=2 Yo=0 | T=0 Yo=1 | T=1 Yo=1 | T=2 Yo=1 | T=2 Yo=0 | T=0 Yo=1", kLd},
    {"Rto", "CONTACTS Xa 0, RTO T 30000, COIL Yo 0 0 0; CONTACTS Xr 0, RES T",
     "Xa=1 | Xa=0 | Xa=1 | | Xa=0 | Xr=1",
     "T=1 Yo=0 | T=1 Yo=0 | T=2 Yo=0 | Yo=1 | Yo=1 | T=0 Yo=1", kLd},
    {"Ctu", "CONTACTS Xa 0, CTU C 2, COIL Yo 0 0 0", "Xa=1 | | Xa=0 | Xa=1 C=32767 | C=2 Xa=0",
     "C=1 Yo=0 | C=1 | C=1 Yo=0 | C=-32768 Yo=0 | C=2 Yo=1", kLd},
    {"CtuAtItsLeast", "CTU C -32768, COIL Yo 0 0 0", "C=-32768 |", "C=-32767 Yo=1 | Yo=1", kLd},
    {"Ctd", "CONTACTS Xa 0, CTD C -1, COIL Yo 0 0 0", "| Xa=1 | Xa=0 | Xa=1 | Xa=0 | C=-32768 Xa=1",
     "C=0 Yo=1 | C=-1 Yo=1 | Yo=1 | C=-2 Yo=0 | Yo=0 | C=32767 Yo=1", kLd},
    // What is above the limit without a count stays.
    {"Ctc", "CONTACTS Xa 0, CTC C 2, COIL Yo 0 0 0", "Xa=1 | Xa=0 | Xa=1 C=2 | C=9 | Xa=0 | Xa=1",
     "C=1 Yo=1 | C=1 Yo=0 | C=0 Yo=1 | C=9 Yo=1 | C=9 | C=0", kLd},
    {"CtcAtItsMost", "CONTACTS Xa 0, CTC C 32767", "Xa=1 C=5 | Xa=0 C=7 | Xa=1", "C=0 | C=7 | C=0",
     kLd},
    {"ShiftRegister", "CONTACTS Xa 0, SHIFT_REGISTER s 3",
     "Xa=1 s0=7 | s0=8 | Xa=0 | Xa=1 | Xa=0 | Xa=1 s0=9",
     "s0=7 s1=7 s2=0 | s0=8 s1=7 | s1=7 | s1=8 s2=7 | | s0=9 s1=9 s2=8", kLd},
};

constexpr CStory kWords[] = {
    {"Move", "CONTACTS Xa 0, MOVE v -32768, MOVE w v, MOVE c 'A'", "| Xa=1",
     "v=0 | v=-32768 w=-32768 c=65", kLd},
    {"ArithmeticWraps", "ADD a u v, SUB s u v, MUL m u v",
     "u=32767 v=1 | u=-32768 v=1 | u=300 v=300 | u=-32768 v=-32768",
     "a=-32768 s=32766 m=32767 | a=-32767 s=32767 m=-32768 | a=600 s=0 m=24464 | a=0 s=0 m=0", kLd},
    {"Divide", "CONTACTS Xa 0, DIV d u v", "| Xa=1 u=-7 v=2 | u=-32768 v=-1 | v=0 | Xa=0",
     "ERROR=0 | d=-3 | d=-32768 ERROR=0 | d=-32768 ERROR=1 | ERROR=0", kLd},
    {"Compares",
     "EQU u v, COIL Y1 0 0 0; NEQ u v, COIL Y2 0 0 0; GRT u v, COIL Y3 0 0 0; GEQ u v, COIL Y4 0 0 "
     "0; LES u v, COIL Y5 0 0 0; LEQ u -3, COIL Y6 0 0 0; CONTACTS Xa 0, LEQ u v, COIL Y7 0 0 0",
     "| u=-32768 v=32767 | u=5 v=-5 Xa=1 | v=5",
     "Y1=1 Y2=0 Y3=0 Y4=1 Y5=0 Y6=0 Y7=0 | Y1=0 Y2=1 Y3=0 Y4=0 Y5=1 Y6=1 Y7=0 | Y2=1 Y3=1 Y4=1 "
     "Y5=0 Y6=0 Y7=0 | Y7=1",
     kLd},
    {"LookUpTable", "CONTACTS Xa 0, LOOK_UP_TABLE d i 3 0 10 -20 30",
     "i=1 | Xa=1 | i=2 | i=3 | i=-1 | i=0", "d=0 | d=-20 | d=30 | d=30 | d=30 | d=10", kLd},
    // 1 gives 3, whose row is still to come and gives 0, whose row is not.
    {"LookUpTableOfItsIndex", "LOOK_UP_TABLE i i 4 0 5 3 7 0", "i=1 | i=0 | i=2 | i=9",
     "i=0 | i=5 | i=7 | i=9", kLd},
    {"PiecewiseLinear", "CONTACTS Xa 0, PIECEWISE_LINEAR d i 3 0 0 10 30 20 -20",
     "i=5 | Xa=1 | i=10 | i=13 | i=20 | i=21 | i=-4",
     "d=0 | d=15 | d=30 | d=15 | d=-20 | d=-20 | "
     "d=-12",
     kLd},
    // 15 is on the second segment and becomes 5, which is on the first and becomes 15.
    {"PiecewiseLinearOfItsIndex", "PIECEWISE_LINEAR i i 3 0 0 10 30 20 -20", "i=15 | i=25",
     "i=15 | i=25", kLd},
    {"PiecewiseLinearOfOnePoint", "PIECEWISE_LINEAR d i 1 0 7", "i=-5 | i=0", "d=0 | d=0", kLd},
};

constexpr CStory kPeripherals[] = {
    {"ReadAdc", "CONTACTS Xa 0, READ_ADC A1; READ_ADC A2",
     "%adc0=700 %adc1=-1 | Xa=1 | %adc0=3 | Xa=0 %adc0=9",
     "A1=0 A2=-1 | A1=700 | A1=3 | A1=3 A2=-1", kLd},
    {"SetPwm", "CONTACTS Xa 0, SET_PWM v 100000; CONTACTS Xb 0, SET_PWM w 50",
     "v=30 w=70 | Xa=1 | Xb=1 | Xa=0 w=-5",
     "%pwm_duty=0 %pwm_hz_low=0 %pwm_hz_high=0 | %pwm_duty=30 %pwm_hz_low=-31072 %pwm_hz_high=1 | "
     "%pwm_duty=70 %pwm_hz_low=-31072 | %pwm_duty=-5 %pwm_hz_high=1",
     kLd},
    // Kept are 5 and 6; the second one is read when it is first executed.
    {"Persist", "PERSIST v; CONTACTS Xa 0, PERSIST w",
     "%persist_value0=5 %persist_value1=6 v=1 | %persist_ready=1 | %persist_ready=1 v=8 | v=9 | "
     "%persist_ready=1 | Xa=1 w=2 %persist_ready=1 v=9 | w=3",
     "v=1 %persist_ready=0 | v=5 %persist_value0=5 %persist_ready=1 | v=8 %persist_value0=8 "
     "%persist_index=0 %persist_ready=0 | %persist_value0=8 | %persist_value0=9 %persist_ready=0 | "
     "w=6 "
     "%persist_ready=1 | w=3 %persist_value1=3 %persist_index=1 %persist_ready=0",
     kLd},
    {"UartSend", "CONTACTS Xa 0, UART_SEND v, COIL Yb 0 0 0", "v=321 | Xa=1 | v=-1 | | Xa=0 |",
     "Yb=0 | TX=65 Yb=1 | Yb=1 | TX=255 Yb=1 | Yb=1 | Yb=0", kLd},
    {"UartReceive", "CONTACTS Xa 0, UART_RECV v, COIL Yg 0 0 0",
     "RX=65 | RX=200 | Xa=1 | | RX=0 | Xa=0",
     "v=0 Yg=0 | v=0 | v=200 Yg=1 | Yg=0 | v=0 Yg=1 | Yg=0", kLd},
    // One waits for the other; both are sent once at the start.
    {"StringsWithoutVariable",
     "CONTACTS Xa 0, FORMATTED_STRING (none) 2 72 105, COIL Yb 0 0 0; FORMATTED_STRING (none) 4 92 "
     "120 70 70",
     "| | | | | Xa=1 | | | ",
     "TX=72 Yb=1 | Yb=1 | TX=105 Yb=0 | | TX=255 | Yb=1 | TX=72 | Yb=1 | TX=105 Yb=0", kLd},
    {"SignedNumber", "FORMATTED_STRING v 4 60 92 45 51", "v=-35 | | | v=7 | | | | |",
     "TX=60 | | TX=45 | | TX=32 | | TX=51 | | TX=53", kLd},
    {"NegativeNumber", "FORMATTED_STRING v 3 92 45 51", "v=-305 | v=1 | | | | | ",
     "TX=45 | | TX=51 | | TX=48 | | TX=53", kLd},
    // Beyond its digits, and without a sign: 62 51 50; 48 - 2, 48 - 7.
    {"NumberTooBig", "FORMATTED_STRING v 2 92 51", "v=1432 | v=0 | | | ",
     "TX=62 | | TX=51 | | TX=50", kLd},
    {"NegativeWithoutSign", "FORMATTED_STRING v 2 92 50", "v=-27 | | ", "TX=46 | | TX=41", kLd},
    {"TheLeastNumber", "FORMATTED_STRING v 3 92 45 53", "v=-32768 | | | | | | | | | | ",
     "TX=45 | | TX=45 | | TX=46 | | TX=41 | | TX=42 | | TX=40", kLd},
    {"EmptyString", "CONTACTS Xa 0, FORMATTED_STRING (none) 0, COIL Yb 0 0 0", "| Xa=1",
     "Yb=0 | Yb=0", kLd},
};

TEST(CLdmicro, Rungs) { expect_c_stories(kRungs); }
TEST(CLdmicro, TimersAndCounters) { expect_c_stories(kCounts); }
TEST(CLdmicro, Words) { expect_c_stories(kWords); }
TEST(CLdmicro, Peripherals) { expect_c_stories(kPeripherals); }

}  // namespace
}  // namespace rung
