// SPDX-License-Identifier: Apache-2.0
// Lines of steps that are refused: everything that is said, word for word.
#include <gtest/gtest.h>

#include "refused.hpp"

namespace rung::flowchart {
namespace {

const Refused kRefused[] = {
    {"GotoUnknown", R"(task A start
step S
  goto SS
step LONGNAME
  goto LONGNMAE
step T
  goto Nowhere
)",
     R"(t.flow:3:8: error: SS: no step has this name
    declare it with a line `step SS`
t.flow:5:8: error: LONGNMAE: no step has this name
    did you mean LONGNAME?
t.flow:7:8: error: Nowhere: no step has this name
    declare it with a line `step Nowhere`
)"},
    {"GotoOfAnotherTask", R"(task A start
step S
  goto T
task B start
step T
)",
     R"(t.flow:3:8: error: T: a step of another task, B
    goto leads to steps of the same task; other tasks are started and stopped
)"},
    {"GotoForm", R"(task A start
step S
  goto 5
step T
  goto T now
step U
  end it
)",
     R"(t.flow:3:8: error: 5 where the name of a step has to stand
    write goto STEP; names are letters, digits and _
t.flow:5:10: error: now: the line should end before this
    write goto STEP
t.flow:7:7: error: it: the line should end before this
    write end
)"},
    {"WhenForm", R"(task A start
step S
  when X0 then T
  when X0
  when goto S
  when D0 goto S
)",
     R"(t.flow:3:11: error: then where `goto` has to stand
    write when CONDITION goto STEP, or when CONDITION end
t.flow:4:10: error: the end of the line where `goto` has to stand
    write when CONDITION goto STEP, or when CONDITION end
t.flow:5:8: error: goto where a device or a number has to stand
    something is missing before it
t.flow:6:8: error: a word where a condition has to stand
    compare it (D0 > 5), or ask for one of its bits (D0.3)
)"},
    {"AfterGoto", R"(task A start
step S
  goto S
  Y0 = on
  end
)",
     R"(t.flow:4:3: error: the step has ended in line 3: this is never done
    put it before, or begin another step
t.flow:5:3: error: the step has ended in line 3: this is never done
    put it before, or begin another step
)"},
    {"Order", R"(board M = unit 1 board 0
board P = unit 1 board 1 panel exclusive
board Q = unit 1 board 2 panel exclusive
task A start
step S
  Y0 = on
  read D0 from M at 1
  write D0 to M at 1
  Y1 = on
  when X0 goto S
  write D0 to M at 2
  set M0
)",
     R"(t.flow:7:3: error: this has to stand before the first action
    a step is read, actions, write, transitions, in this order; else begin another
t.flow:9:3: error: this has to stand before the write
    a step is read, actions, write, transitions, in this order; else begin another
t.flow:11:3: error: a second write: a step has one at most
    begin another step for it
t.flow:12:3: error: this has to stand before the transitions
    a step is read, actions, write, transitions, in this order; else begin another
)"},
    {"Twice", R"(board M = unit 1 board 0
board P = unit 1 board 1 panel exclusive
board Q = unit 1 board 2 panel exclusive
task A start
step S
  read D0 from M at 1
  read D0 from M at 2
  write D0 to M at 1
  write D0 to M at 2
)",
     R"(t.flow:7:3: error: a second read: a step has one at most
    begin another step for it
t.flow:9:3: error: a second write: a step has one at most
    begin another step for it
)"},
    {"TransferForm", R"(board M = unit 1 board 0
board P = unit 1 board 1 panel exclusive
board Q = unit 1 board 2 panel exclusive
task A start
step S
  read from M at 1
step T
  read D0 to M at 1
step U
  write D0 count 2 M at 1
step V
  read D0 from M
)",
     R"(t.flow:6:8: error: from where a word device has to stand
    write read D100 count 4 from BOARD at 20
t.flow:8:11: error: to where `from` has to stand
    write read D100 count 4 from BOARD at 20
t.flow:10:20: error: M where `to` has to stand
    write write D100 count 4 to BOARD at 20
t.flow:12:17: error: the end of the line where `at` has to stand
    write read D100 count 4 from BOARD at 20
)"},
    {"TransferCount", R"(board M = unit 1 board 0
board P = unit 1 board 1 panel exclusive
board Q = unit 1 board 2 panel exclusive
task A start
step S
  read D0 count 0 from M at 1
step T
  read D0 count 33 from M at 1
step U
  read D7990 count 11 from M at 1
step V
  read D0 count 2 from M at 65535
step W
 read D0 from M at 65536
)",
     R"(t.flow:6:17: error: 0: not the number of words
    it is 1 to 32
t.flow:8:17: error: 33: not the number of words
    it is 1 to 32
t.flow:10:8: error: 11 words from D7990 on go beyond the last device
    the last one is D7999
t.flow:12:29: error: 2 words from variable 65535 on go beyond the last variable, 65535
    begin at a lower variable
t.flow:14:20: error: 65536: not the number of a variable
    it is 0 to 65535
)"},
    {"TransferDevice", R"(board M = unit 1 board 0
board P = unit 1 board 1 panel exclusive
board Q = unit 1 board 2 panel exclusive
task A start
step S
  read M0 from M at 1
step T
  read TN0 from M at 1
step U
  read K4Y0 from M at 1
step V
  read D0.3 from M at 1
)",
     R"(t.flow:6:8: error: M0: transfers move the words of D, R and W
    move other values there in an action: D0 = K4X0
t.flow:8:8: error: TN0: transfers move the words of D, R and W
    move other values there in an action: D0 = K4X0
t.flow:10:8: error: K4Y0: transfers move the words of D, R and W
    move other values there in an action: D0 = K4X0
t.flow:12:8: error: D0.3: transfers move the words of D, R and W
    move other values there in an action: D0 = K4X0
)"},
    {"TransferBoard", R"(board M = unit 1 board 0
board P = unit 1 board 1 panel exclusive
board Q = unit 1 board 2 panel exclusive
task A start
step S
  read D0 from MM at 1
step T
  read D0 from STORE at 1
)",
     R"(t.flow:6:16: error: MM: no board has this name
    declare it with a line `board MM = ...`
t.flow:8:16: error: STORE: no board has this name
    declare it with a line `board STORE = ...`
)"},
    {"TwoExclusive", R"(board M = unit 1 board 0
board P = unit 1 board 1 panel exclusive
board Q = unit 1 board 2 panel exclusive
task A start
step S
  read D0 from P at 1
  write D0 to Q at 1
)",
     R"(t.flow:7:15: error: a second exclusive board: the step holds P until it ends
    write in a step of its own, so that no two tasks wait for each other
)"},
    {"WaitForm", R"(task A start
step S
  wait
  wait 5
  wait 5 h
  wait 0 s
  wait 51 min
  wait 4000000 ms
  wait 1.5 s
  wait D0
  wait 5 s now
)",
     R"(t.flow:3:7: error: the end of the line where a device or a number has to stand
    something is missing here
t.flow:4:9: error: the end of the line where ms, s or min has to stand
    write wait 500 ms, wait 2 s, wait 3 min or wait CONDITION
t.flow:5:10: error: h where ms, s or min has to stand
    write wait 500 ms, wait 2 s, wait 3 min or wait CONDITION
t.flow:6:8: error: 0: not the number of milliseconds, seconds or minutes
    it is 1 to 3000000
t.flow:7:8: error: a wait of more than 50 minutes
    wait several times, or count with a counter of the ladder
t.flow:8:8: error: 4000000: not the number of milliseconds, seconds or minutes
    it is 1 to 3000000
t.flow:9:8: error: 1.5 where the number of milliseconds, seconds or minutes has to stand
    write wait 500 ms, wait 2 s, wait 3 min or wait CONDITION
t.flow:10:8: error: a word where a condition has to stand
    compare it (D0 > 5), or ask for one of its bits (D0.3)
t.flow:11:12: error: now: the line should end before this
    write wait 500 ms, wait 2 s, wait 3 min or wait CONDITION
)"},
    {"FirstWord", R"(task A start
step S
  sett M0
  from M
  5 = D0
  GOTO S
  X0 and Y0
)",
     R"(t.flow:3:3: error: sett: neither a device nor a word of the language
    did you mean set?
t.flow:4:3: error: from: no line of a step begins with this
    it begins with read, a device, set, reset, start, stop, write, when, goto, end or wait
t.flow:5:3: error: 5: no line of a step begins with this
    it begins with read, a device, set, reset, start, stop, write, when, goto, end or wait
t.flow:6:3: error: GOTO: neither a device nor a word of the language
    did you mean goto?
t.flow:7:3: error: X0: an input, which only the controller writes
    write a relay (M) or output (Y)
)"},
};

class FlowRefusedSteps : public testing::TestWithParam<Refused> {};
TEST_P(FlowRefusedSteps, SaysWhy) { expect_refused(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Flow, FlowRefusedSteps, testing::ValuesIn(kRefused), refused_name);

}  // namespace
}  // namespace rung::flowchart
