// SPDX-License-Identifier: Apache-2.0
// Lines before the first task, tasks, steps that are refused: everything that is said, word for
// word.
#include <gtest/gtest.h>

#include "refused.hpp"

namespace rung::flowchart {
namespace {

const Refused kRefused[] = {
    {"NoTask", R"(# nothing
)",
     R"(t.flow:1:1: error: there is no task in this file
    write `task NAME start`, then `step NAME` and its lines
)"},
    {"UnknownWord", R"(tusk A
)",
     R"(t.flow:1:1: error: tusk: no line before the first task begins with this
    did you mean task?
)"},
    {"UnknownWordFar", R"(hello
)",
     R"(t.flow:1:1: error: hello: no line before the first task begins with this
    dialect, unit, ladder and board stand there, then tasks
)"},
    {"NotAWord", R"(=
)",
     R"(t.flow:1:1: error: =: no line before the first task begins with this
    dialect, unit, ladder and board stand there, then tasks
)"},
    {"OpenText", R"(ladder "x
)",
     R"(t.flow:1:8: error: the name that begins here has no closing quote
    write " behind it
)"},
    {"DialectUnknown", R"(dialect ldmicro
task A start
step S
)",
     R"(t.flow:1:9: error: ldmicro: not a dialect of flows
    write dialect fx, dialect q or dialect paper
)"},
    {"DialectTwice", R"(dialect fx
dialect q
task A start
step S
)",
     R"(t.flow:2:1: error: a second line `dialect`: line 1 has said it already
    leave one of them out
)"},
    {"UnitRange", R"(unit 16
task A start
step S
)",
     R"(t.flow:1:6: error: 16: not the number of a unit
    it is 1 to 15
)"},
    {"UnitWord", R"(unit one
task A start
step S
)",
     R"(t.flow:1:6: error: one where the number of a unit has to stand
    write unit 1
)"},
    {"UnitBehindBoards", R"(board M = unit 1 board 0
unit 2
task A start
step S
)",
     R"(t.flow:2:1: error: the unit stands before the boards, which may be its own
    put this line at the beginning
)"},
    {"LadderName", R"(ladder line.il
task A start
step S
)",
     R"(t.flow:1:8: error: line.il where the name of a file has to stand
    write ladder "line.il"
)"},
    {"LadderMissing", R"(ladder "not_there.il"
task A start
step S
)",
     R"(not_there.il:1:1: error: cannot open it: No such file or directory
t.flow:1:8: note: this ladder is refused
)"},
    {"LadderLdmicro", R"(ladder "a.ld"
task A start
step S
)",
     R"(t.flow:1:8: error: an LDmicro program cannot run beside tasks
    write the ladder as an instruction list
)"},
    {"HeaderTooLate", R"(task A start
step S
unit 3
bord
)",
     R"(t.flow:3:1: error: unit: stands before the first task only
    put this line at the beginning
t.flow:4:1: error: bord: neither a device nor a word of the language
    did you mean board?
)"},
    {"BoardForm", R"(board M = unit 1
task A start
step S
)",
     R"(t.flow:1:17: error: the end of the line where `board` has to stand
    write board NAME = unit 1 board 0
)"},
    {"BoardNumber", R"(board M = unit 1 board 16
board N = unit 0 board 1
task A start
step S
)",
     R"(t.flow:1:24: error: 16: not the number of a board
    it is 0 to 15
t.flow:2:16: error: 0: not the number of a unit
    it is 1 to 15
)"},
    {"BoardTwice", R"(board M = unit 1 board 0
board M = unit 1 board 1
board N = unit 1 board 0
task A start
step S
)",
     R"(t.flow:2:7: error: M: a board of this name is declared in line 1 already
    give it another name
t.flow:3:16: error: board 0 of unit 1 is M already (line 1)
    use that name
)"},
    {"BoardAttribute", R"(board M = unit 1 board 0 shared
task A start
step S
)",
     R"(t.flow:1:26: error: shared: not an attribute of a board
    they are panel, link and exclusive
)"},
    {"BoardOfAnother", R"(board M = unit 2 board 0 panel
board N = unit 2 board 1 exclusive
task A start
step S
)",
     R"(t.flow:1:26: error: panel of a board of unit 2: this is unit 1
    leave it out; that unit's own program says it
t.flow:2:26: error: exclusive of a board of unit 2: this is unit 1
    leave it out; that unit's own program says it
)"},
    {"BoardLink", R"(board M = unit 1 board 0 link
task A start
step S
)",
     R"(t.flow:1:26: error: link of this unit's own words, which lie over no link
    leave it out, or write panel for the device on the panel's line
)"},
    {"TaskName", R"(task
task 5
task step
task A.B
)",
     R"(t.flow:1:5: error: the end of the line where the name of a task has to stand
    write task NAME; names are letters, digits and _
t.flow:2:6: error: 5 where the name of a task has to stand
    write task NAME; names are letters, digits and _
t.flow:3:6: error: step is a word of the language, not the name of a task
    take another name, or write it in capitals
t.flow:4:6: error: A.B where the name of a task has to stand
    write task NAME; names are letters, digits and _
)"},
    {"TaskTwice", R"(task A start
step S
task A
step S
)",
     R"(t.flow:3:6: error: A: a task of this name is declared in line 1 already
    give it another name
)"},
    {"TaskTail", R"(task A begin
step S
)",
     R"(t.flow:1:8: error: begin: the line should end before this
    write task NAME, or task NAME start
)"},
    {"TaskWithoutStep", R"(task A start
task B start
step S
)",
     R"(t.flow:1:6: error: A: a task without a step
    begin with a line `step NAME`, or remove the task
)"},
    {"StepTwice", R"(task A start
step S
step T
step S
)",
     R"(t.flow:4:6: error: S: a step of this name is declared in line 2 already
    give it another name
)"},
    {"StepWithoutTask", R"(step S
Y0 = on
step T
)",
     R"(t.flow:1:1: error: a step of no task
    begin with a line `task NAME`
)"},
    {"LineWithoutStep", R"(task A start
Y0 = on
Y1 = on
step S
)",
     R"(t.flow:2:1: error: Y0: a line of no step: the task has none yet
    begin with a line `step NAME`
)"},
    {"SeveralAtOnce", R"(dialect z
board
task A start
step S
  Y0 = X9
  when Q goto S
  goto T
)",
     R"(t.flow:1:9: error: z: not a dialect of flows
    write dialect fx, dialect q or dialect paper
t.flow:2:6: error: the end of the line where the name of a board has to stand
    write board NAME = unit 1 board 0; names are letters, digits and _
t.flow:5:8: error: X9: not an input: its numbers are octal (digits 0 to 7) in dialect fx
    the devices are X0 to X377
t.flow:6:8: error: Q: neither a device nor a word of the language
    a device is a letter such as X, Y, M, D with a number: M10
t.flow:7:8: error: T: no step has this name
    declare it with a line `step T`
)"},
};

class FlowRefusedHeader : public testing::TestWithParam<Refused> {};
TEST_P(FlowRefusedHeader, SaysWhy) { expect_refused(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Flow, FlowRefusedHeader, testing::ValuesIn(kRefused), refused_name);

}  // namespace
}  // namespace rung::flowchart
