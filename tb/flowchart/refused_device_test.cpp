// SPDX-License-Identifier: Apache-2.0
// Devices, numbers, conditions and expressions that are refused: everything that is said, word for
// word.
#include <gtest/gtest.h>

#include "refused.hpp"

namespace rung::flowchart {
namespace {

const Refused kRefused[] = {
    {"Character", R"(task A start
step S
  Y0 = X0 & X1
)",
     R"(t.flow:3:11: error: &: no character of the language
    compiler/FLOW.md shows what there is
)"},
    {"Devices", R"(task A start
step S
  Y0 = X8
  Y1 = M7680
  Y2 = M8029
  D0 = W5
  Y3 = FOO
  Y4 = nto X0
  Y5 = M8022
  D0 = CN200:h
  D1 = D8000
)",
     R"(t.flow:3:8: error: X8: not an input: its numbers are octal (digits 0 to 7) in dialect fx
    the devices are X0 to X377
t.flow:4:8: error: M7680: beyond the last device of dialect fx
    the devices are M0 to M7679
t.flow:5:8: error: M8029: a special device that this controller does not have
    compiler/SEMANTICS.md lists those that it has
t.flow:6:8: error: W5: a word, which dialect fx does not have
    for such a controller begin with the line `dialect q`
t.flow:7:8: error: FOO: neither a device nor a word of the language
    a device is a letter such as X, Y, M, D with a number: M10
t.flow:8:8: error: nto: neither a device nor a word of the language
    did you mean to?
t.flow:9:8: error: M8022: what instructions of the ladder leave there; a step neither sets nor sees it
    copy it to a relay in the ladder
t.flow:10:13: error: :: no character of the language
    compiler/FLOW.md shows what there is
t.flow:11:8: error: D8000: a special device that this controller does not have
    compiler/SEMANTICS.md lists those that it has
)"},
    {"DevicesOfQ", R"(dialect q
task A start
step S
  Y0 = X2000
  D0 = V0
  M0 = SMA
  M1 = M1F
)",
     R"(t.flow:4:8: error: X2000: beyond the last device of dialect q
    the devices are X0 to X1FFF
t.flow:5:8: error: V0: an index register, which dialect q does not have
    for such a controller begin with the line `dialect fx`
t.flow:6:8: error: SMA: neither a device nor a word of the language
    a device is a letter such as X, Y, M, D with a number: M10
t.flow:7:8: error: M1F: not a relay: its numbers are decimal in dialect q
    the devices are M0 to M8191
)"},
    {"DevicesOfPaper", R"(dialect paper
task A start
step S
  D0 = K4X0
  Y0 = D0.3
  Y1 = T0
  Y2 = S0
)",
     R"(t.flow:4:8: error: K4X0: bits of words and words of bits are not in dialect paper
    begin with the line `dialect fx`
t.flow:5:8: error: D0.3: bits of words and words of bits are not in dialect paper
    begin with the line `dialect fx`
t.flow:6:8: error: T0: a timer, which dialect paper does not have
    for such a controller begin with the line `dialect fx`
t.flow:7:8: error: S0: a state, which dialect paper does not have
    for such a controller begin with the line `dialect fx`
)"},
    {"Groups", R"(task A start
step S
  D0 = K5X0
  K4X0 = 1
  D0 = K4M7670
  D0 = K2T0
  D0 = K1D0
  D0 = K1M8000
  D0 = K12X0
)",
     R"(t.flow:3:8: error: K5X0: not a digit group of a word
    K1 to K4: one to four digits of four bits each
t.flow:4:3: error: K4X0: an input, which only the controller writes
    write a relay (M) or output (Y)
t.flow:5:8: error: K4M7670: its 16 bits go beyond the last device
    the devices are M0 to M7679
t.flow:6:8: error: K2T0: a digit group begins with an input, output or relay
    K4X0, K2M16
t.flow:7:8: error: K1D0: a digit group begins with an input, output or relay
    K4X0, K2M16
t.flow:8:8: error: K1M8000: a digit group begins with an input, output or relay
    K4X0, K2M16
t.flow:9:8: error: K12X0: not a digit group of a word
    K1 to K4: one to four digits of four bits each
)"},
    {"WordBits", R"(task A start
step S
  Y0 = D0.G
  Y1 = D0.10
  Y2 = M0.1
  Y3 = TN0.1
  Y4 = D0.
)",
     R"(t.flow:3:8: error: D0.G: not a bit of a word
    bits of data registers are D0.0 to D0.F
t.flow:4:8: error: D0.10: not a bit of a word
    bits of data registers are D0.0 to D0.F
t.flow:5:8: error: M0.1: not a bit of a word
    bits of data registers are D0.0 to D0.F
t.flow:6:8: error: TN0.1: not a bit of a word
    bits of data registers are D0.0 to D0.F
t.flow:7:8: error: D0.: not a bit of a word
    bits of data registers are D0.0 to D0.F
)"},
    {"NotWritable", R"(task A start
step S
  X0 = on
  set X1
  M8000 = on
  T0 = on
  reset C5
  TN0 = 5
  CN0 = 1
  set D0
  M8013 = off
)",
     R"(t.flow:3:3: error: X0: an input, which only the controller writes
    write a relay (M) or output (Y)
t.flow:4:7: error: X1: an input, which only the controller writes
    write a relay (M) or output (Y)
t.flow:5:3: error: M8000: a special relay that only the controller writes
    write a relay (M)
t.flow:6:3: error: T0: a timer: timers and counters work in the ladder only
    use `wait 500 ms`, or start it in the ladder by a relay that the step sets
t.flow:7:9: error: C5: a counter: timers and counters work in the ladder only
    use `wait 500 ms`, or start it in the ladder by a relay that the step sets
t.flow:8:3: error: TN0: the value of a timer: timers and counters work in the ladder only
    use `wait 500 ms`, or start it in the ladder by a relay that the step sets
t.flow:9:3: error: CN0: the value of a counter: timers and counters work in the ladder only
    use `wait 500 ms`, or start it in the ladder by a relay that the step sets
t.flow:10:7: error: D0: set takes a bit, this is a word
    write D0 = 0 for a word, D0.3 for one of its bits
t.flow:11:3: error: M8013: a special relay that only the controller writes
    write a relay (M)
)"},
    {"Numbers", R"(task A start
step S
  D0 = 40000
  D1 = 0x10000
  D2 = -32769
  D3 = 1F
  D4 = 0x
  D5 = 99999999999999999999
  D6 = -0x8001
)",
     R"(t.flow:3:8: error: 40000: more than 16 bits hold
    constants are -32768 to 32767, or 0x0 to 0xFFFF
t.flow:4:8: error: 0x10000: more than 16 bits hold
    constants are -32768 to 32767, or 0x0 to 0xFFFF
t.flow:5:9: error: 32769: more than 16 bits hold
    constants are -32768 to 32767, or 0x0 to 0xFFFF
t.flow:6:8: error: 1F: not a number
    numbers are 300 or 0x1F; what follows needs a blank before it
t.flow:7:8: error: 0x: not a number
    numbers are 300 or 0x1F; what follows needs a blank before it
t.flow:8:8: error: 99999999999999999999: more than 16 bits hold
    constants are -32768 to 32767, or 0x0 to 0xFFFF
t.flow:9:9: error: 0x8001: more than 16 bits hold
    constants are -32768 to 32767, or 0x0 to 0xFFFF
)"},
    {"MixedTypes", R"(task A start
step S
  D0 = X0
  Y0 = D0
  D0 = D1 + M0
  Y0 = X0 and D0
  Y0 = D0 and 15 > 3
  Y0 = X0 = on
  Y0 = 0 < D0 < 5
  Y0 = X0 xor X1
  D0 = not D1
  D0 = 5 and on
  Y0 = -M0
)",
     R"(t.flow:3:8: error: a condition where a word has to stand
    a word takes numbers and words; a bit (M0) takes conditions
t.flow:4:8: error: a word where a condition has to stand
    compare it (D0 > 5), or ask for one of its bits (D0.3)
t.flow:5:11: error: + calculates with words, but there is M0, a bit
    conditions are joined with and, or, not
t.flow:6:11: error: and between X0, a bit and D0, a word
    it takes two conditions or two words; comparisons bind before it: write (D0 and 15) > 3
t.flow:7:11: error: and between D0, a word and a condition
    it takes two conditions or two words; comparisons bind before it: write (D0 and 15) > 3
t.flow:8:11: error: = compares words, but there is X0, a bit
    a bit is asked by its name alone: X0, not X0
t.flow:9:15: error: < compares words, but there is a condition
    join two comparisons with `and`: 0 < D0 and D0 < 9
t.flow:10:11: error: xor combines words, not conditions
    of conditions write (A and not B) or (B and not A)
t.flow:11:8: error: not inverts a condition, not a word
    of a word write D0 xor 0xFFFF
t.flow:12:10: error: and between a number and a condition
    it takes two conditions or two words; comparisons bind before it: write (D0 and 15) > 3
t.flow:13:8: error: - calculates with words, but there is M0, a bit
    conditions are joined with and, or, not
)"},
    {"DivisionByZero", R"(task A start
step S
  D0 = D1 / 0
  D0 = D1 % 0x0
)",
     R"(t.flow:3:13: error: a division by 0
    divide by something else
t.flow:4:13: error: a division by 0
    divide by something else
)"},
    {"Incomplete", R"(task A start
step S
  Y0 =
  Y0
  Y0 = (X0 or X1
  Y0 = X0 X1
  Y0 = X0 and
  Y0 = X0 and or X1
  D0 = 1 +
  D0 = 5 5
  Y0 = )
  set
  start
  D0 = (
)",
     R"(t.flow:3:7: error: the end of the line where a device or a number has to stand
    something is missing here
t.flow:4:5: error: the end of the line where `=` has to stand
    write Y0 = X0 and not X1
t.flow:5:17: error: the end of the line where `)` has to stand
    the ( in column 8 is still open
t.flow:6:11: error: X1: the line should end before this
    write Y0 = X0 and not X1
t.flow:7:14: error: the end of the line where a device or a number has to stand
    something is missing here
t.flow:8:15: error: or where a device or a number has to stand
    something is missing before it
t.flow:9:11: error: the end of the line where a device or a number has to stand
    something is missing here
t.flow:10:10: error: 5: the line should end before this
    write D0 = D1 + 1, set M0, start TASK, or one of them if M0
t.flow:11:8: error: ) where a device or a number has to stand
    compiler/FLOW.md shows conditions and expressions
t.flow:12:6: error: the end of the line where a bit has to stand
    write set M0
t.flow:13:8: error: the end of the line where the name of a task has to stand
    write start TASK; names are letters, digits and _
t.flow:14:9: error: the end of the line where a device or a number has to stand
    something is missing here
)"},
    {"If", R"(task A start
step S
  Y0 = X0 if X1
  D0 = 5 if
  set M0 if D0
  D0 = 5 when X0
)",
     R"(t.flow:3:11: error: if behind the value of a bit: it has one in any case
    write it into the condition, or use set M0 if ..., reset M0 if ...
t.flow:4:12: error: the end of the line where a device or a number has to stand
    something is missing here
t.flow:5:13: error: a word where a condition has to stand
    compare it (D0 > 5), or ask for one of its bits (D0.3)
t.flow:6:10: error: when: the line should end before this
    write D0 = D1 + 1, set M0, start TASK, or one of them if M0
)"},
    {"Failed", R"(board M = unit 1 board 0
board P = unit 1 board 1 panel exclusive
board Q = unit 1 board 2 panel exclusive
task A start
step S
  Y0 = failed
  when failed goto S
step T
  M0 = failed
  write D0 to M at 1
  wait failed
)",
     R"(t.flow:6:8: error: failed: no read stands before the actions
    a write comes after them: ask for it in a `when` behind it
t.flow:7:8: error: failed: this step has neither read nor write
    ask in the step that has the transfer
t.flow:9:8: error: failed: no read stands before the actions
    a write comes after them: ask for it in a `when` behind it
t.flow:11:8: error: failed: a wait only looks at what is there
    ask for it in a `when`, before the wait
)"},
    {"Running", R"(task A start
step S
  Y0 = running B
  Y1 = running
  start B
  stop 5
  start A now
)",
     R"(t.flow:3:16: error: B: no task has this name
    declare it with a line `task B`
t.flow:4:15: error: the end of the line where the name of a task has to stand
    write running TASK; names are letters, digits and _
t.flow:5:9: error: B: no task has this name
    declare it with a line `task B`
t.flow:6:8: error: 5 where the name of a task has to stand
    write stop TASK; names are letters, digits and _
t.flow:7:11: error: now: the line should end before this
    write D0 = D1 + 1, set M0, start TASK, or one of them if M0
)"},
};

class FlowRefusedExpressions : public testing::TestWithParam<Refused> {};
TEST_P(FlowRefusedExpressions, SaysWhy) { expect_refused(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Flow, FlowRefusedExpressions, testing::ValuesIn(kRefused), refused_name);

}  // namespace
}  // namespace rung::flowchart
