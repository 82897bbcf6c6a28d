// SPDX-License-Identifier: Apache-2.0
// What the lines of a step become: rungs, steps and transfers.
#include <gtest/gtest.h>

#include "rungs/structure.hpp"
#include "support.hpp"

namespace rung::flowchart {
namespace {

std::string one(std::string_view line, std::string_view dialect = "fx") {
  const Flowchart chart = good("dialect " + std::string(dialect) + "\ntask A start\nstep S\n" +
                               std::string(line) + "\ngoto S\n");
  if (chart.steps.empty()) return {};
  std::string text = code(chart.steps[0]);
  // The goto.
  const std::size_t tail = text.rfind("MOV K0 next");
  return tail == std::string::npos ? text : text.substr(0, tail);
}

TEST(FlowCode, Bits) {
  EXPECT_EQ(one("Y0 = on"), "LD M8000; SET Y0; ");
  EXPECT_EQ(one("Y0 = off"), "LD M8000; RST Y0; ");
  EXPECT_EQ(one("y0 = x0"), "LD X0; OUT Y0; LD M8000; ");
  EXPECT_EQ(one("Y0 = X0 and not (X1 or M3)"), "LD X0; ANI X1; ANI M3; OUT Y0; LD M8000; ");
  EXPECT_EQ(one("Y0 = X0 or not X1 and M3"), "LDI X1; AND M3; OR X0; OUT Y0; LD M8000; ");
  EXPECT_EQ(one("Y0 = (X0 or X1) and (X2 or X3)"),
            "LD X0; OR X1; LD X2; OR X3; ANB; OUT Y0; LD M8000; ");
  EXPECT_EQ(one("Y0 = X0 and X1 or X2 and X3"),
            "LD X0; AND X1; LD X2; AND X3; ORB; OUT Y0; LD M8000; ");
  EXPECT_EQ(one("Y0 = not (D0 > 5 or D1 = 2)"), "LD<= D0 K5; AND<> D1 K2; OUT Y0; LD M8000; ");
  EXPECT_EQ(one("D1.F = D0.3 and off"), "LD M8000; RST D1.F; ");
  EXPECT_EQ(one("Y0 = 3 < 4"), "LD M8000; SET Y0; ");
  EXPECT_EQ(one("set M3\nreset M4 if T0"), "LD M8000; SET M3; LD TS0; RST M4; LD M8000; ");
}

TEST(FlowCode, Words) {
  EXPECT_EQ(one("D0 = D1 + 5 * D2 - 3"), "LD M8000; MUL K5 D2 t0; ADD D1 t0 t0; SUB t0 K3 D0; ");
  EXPECT_EQ(one("D0 = 2 + 3 * -4"), "LD M8000; MOV K-10 D0; ");
  EXPECT_EQ(one("D0 = 0xFFFF"), "LD M8000; MOV K-1 D0; ");
  EXPECT_EQ(one("D0 = -D1"), "LD M8000; SUB K0 D1 D0; ");
  EXPECT_EQ(one("D0 = D1 / 3"), "LD M8000; DIV D1 K3 D0; ");
  // By 0 a DIV does nothing; its result must not be used any further.
  EXPECT_EQ(one("D0 = D1 / D2"), "LD M8000; DIV D1 D2 D0; ");
  EXPECT_EQ(one("D0 = D1 / D2 + 1"),
            "LD M8000; DIV D1 D2 t0; LD<> D2 K0; ADD t0 K1 D0; LD M8000; ");
  EXPECT_EQ(one("D0 = D1 % 3"), "LD M8000; DIV D1 K3 t0; MOV t1 D0; ");
  EXPECT_EQ(one("D0 = D1 % D2"), "LD M8000; DIV D1 D2 t0; LD<> D2 K0; MOV t1 D0; LD M8000; ");
  EXPECT_EQ(one("D0 = D1 and 15 or D2 xor D3"),
            "LD M8000; WAND D1 K15 t0; WXOR D2 D3 t1; WOR t0 t1 D0; ");
  EXPECT_EQ(one("D0 = D1 if X0 or D1 / D2 > 3"),
            "LD M8000; DIV D1 D2 t0; LD> t0 K3; AND<> D2 K0; OR X0; MOV D1 D0; LD M8000; ");
  EXPECT_EQ(one("K4Y0 = K2X10 + TN0 + CN199"), "LD M8000; ADD K2X10 TN0 t0; ADD t0 CN199 K4Y0; ");
}

TEST(FlowCode, Dialects) {
  EXPECT_EQ(one("Y1F = X1A", "q"), "LD X1A; OUT Y1F; LD SM400; ");
  EXPECT_EQ(one("D0 = W1F * D1", "q"), "LD SM400; MUL W1F D1 D0; ");
  // No relay there is always on.
  EXPECT_EQ(one("D0 = D1 / 2", "paper"), "LDI never; DIV D1 K2 D0; ");
}

TEST(FlowCode, RungsAreWellFormed) {
  const Flowchart chart = good(R"(task A start
step S
  M0 = ((X0 or X1) and (X2 or X3) or (X4 and X5 or X6 and X7) and D0 > 1) and not (M1 and M2 or M3)
  D0 = (D1 + 1) * (D2 - 2) / (D3 % 7) if M0 or D4 / D5 = 2
  when M0 and (M1 or M2) end
  goto S
)");
  for (const Step& step : chart.steps) {
    std::vector<StructureItem> items;
    std::size_t covered = 0;
    for (const Instruction& each : step.rungs.instructions) {
      items.push_back({effect_of(each.op), each.text, each.position});
    }
    Diagnostics diagnostics;
    check_structure("t", Dialect::Fx, items, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors());
    for (const Network& network : step.rungs.networks) {
      EXPECT_EQ(network.first, covered);
      covered += network.count;
    }
    EXPECT_EQ(covered, step.rungs.instructions.size());
  }
}

// Only the last MOV that is executed counts, so the first `when` stands last.
TEST(FlowCode, Transitions) {
  const Flowchart chart = good(R"(task A start
step S
  when X0 goto T
  when X1 end
step T
  when X2 goto S
  when on goto U
  when X3 goto T
step U
step V
)");
  ASSERT_EQ(chart.steps.size(), 4U);
  EXPECT_EQ(code(chart.steps[0]), "LD X1; MOV K-1 next; LD X0; MOV K1 next");
  EXPECT_EQ(code(chart.steps[1]), "LD M8000; MOV K2 next; LD X2; MOV K0 next");
  EXPECT_EQ(code(chart.steps[2]), "LD M8000; MOV K3 next");
  EXPECT_EQ(code(chart.steps[3]), "LD M8000; MOV K-1 next");
  EXPECT_EQ(chart.steps[0].next, (std::vector<std::size_t>{1}));
  EXPECT_EQ(chart.steps[1].next, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(chart.steps[2].next, (std::vector<std::size_t>{3}));
  EXPECT_TRUE(chart.steps[3].next.empty());
}

TEST(FlowCode, StartAndStop) {
  const Flowchart chart = good(R"(task A start
step S
  start B
  stop A if X0
  M0 = running B
  M1 = running A
  when X1 goto S
  when X2 end
  when X3 end
  goto S
task B
step S
)");
  ASSERT_EQ(chart.steps.size(), 2U);
  // A starts with the program: its bit is 1 while it does not run. B is just the other way round.
  EXPECT_EQ(code(chart.steps[0]),
            "LD M8000; MOV K257 task; SET turned1; LD X0; MOV K0 task; SET turned0; "
            "LD turned1; OUT M0; LDI turned0; OUT M1; "
            "LD M8000; MOV K0 next; LD X3; MOV K-1 next; LD X2; MOV K-1 next; LD X1; MOV K0 next; "
            "LD X2; ANI X1; SET turned0; LD X3; ANI X1; ANI X2; SET turned0");
  EXPECT_EQ(code(chart.steps[1]), "LD M8000; MOV K-1 next; RST turned1");
}

TEST(FlowCode, Waits) {
  const Flowchart chart = good(R"(task A start
step S
  wait X0
step T
  Y0 = on
  wait X1
  wait 500 ms
  Y1 = on
  wait 40 s
  when X5 goto S
  wait 1 ms
)");
  ASSERT_EQ(chart.steps.size(), 9U);
  EXPECT_EQ(code(chart.steps[0]), "LD X0; MOV K1 next");
  EXPECT_EQ(code(chart.steps[1]), "LD M8000; SET Y0; MOV K2 next");
  EXPECT_EQ(code(chart.steps[2]), "LD X1; MOV K3 next");
  EXPECT_EQ(code(chart.steps[3]), "LD M8000; MOV ms since0; MOV K4 next");
  EXPECT_EQ(code(chart.steps[4]), "LD M8000; SUB ms since0 t0; LD> t0 K500; MOV K5 next");
  EXPECT_EQ(code(chart.steps[5]), "LD M8000; SET Y1; MOV tenths since0; MOV K6 next");
  EXPECT_EQ(code(chart.steps[6]), "LD M8000; SUB tenths since0 t0; LD> t0 K400; MOV K7 next");
  EXPECT_EQ(code(chart.steps[7]), "LD M8000; MOV ms since0; MOV K8 next; LD X5; MOV K0 next");
  EXPECT_EQ(code(chart.steps[8]), "LD M8000; SUB ms since0 t0; LD> t0 K1; MOV K-1 next");
  for (std::size_t i = 0; i < chart.steps.size(); ++i) {
    EXPECT_EQ(chart.steps[i].added, i > 1) << i;
    EXPECT_EQ(chart.steps[i].name, i == 0 ? "S" : "T");
    EXPECT_EQ(chart.steps[i].text, i == 0 ? "step S" : "step T");
  }
  EXPECT_EQ(chart.steps[4].position, (SourcePosition{7, 3}));
}

// Conditions behind a write are looked at when it is done, in a step that runs once for each write.
TEST(FlowCode, Transfers) {
  const Flowchart chart = good(R"(unit 3
board OWN = unit 3 board 0
board PANEL = unit 3 board 15 panel link exclusive
board FAR = unit 15 board 2 link
task A start
step S
  read D10 count 32 from PANEL at 65504
  M0 = failed
  write R5 to FAR at 0
  when failed goto T
step T
  read D1 from OWN at 7
  write D1 count 2 to FAR at 0
  when X0 goto S
  wait 1 s
step U
  write D1 to OWN at 3
  goto S
)");
  ASSERT_EQ(chart.boards.size(), 3U);
  EXPECT_FALSE(chart.boards[0].over_link);
  EXPECT_TRUE(chart.boards[1].over_link && chart.boards[1].panel && chart.boards[1].exclusive);
  EXPECT_TRUE(chart.boards[2].over_link && !chart.boards[2].panel && !chart.boards[2].exclusive);
  EXPECT_EQ(chart.boards[2].unit, 15);
  ASSERT_EQ(chart.steps.size(), 6U);
  const std::optional<Transfer>& read = chart.steps[0].read;
  ASSERT_TRUE(read);
  EXPECT_EQ(read->board, 1U);
  EXPECT_EQ(read->first, 65504);
  EXPECT_EQ(read->count, 32);
  EXPECT_EQ(read->head, device("D10"));
  ASSERT_TRUE(chart.steps[0].write);
  EXPECT_EQ(chart.steps[0].write->head, device("R5"));
  EXPECT_EQ(chart.steps[0].write->count, 1);
  EXPECT_EQ(code(chart.steps[0]),
            "LD<> status K0; OUT M0; LD<> status K0; OUT failed0; LD M8000; MOV K1 next");
  EXPECT_FALSE(chart.steps[1].read || chart.steps[1].write);
  EXPECT_EQ(code(chart.steps[1]), "LD M8000; MOV K0 next; LD failed0; OR<> status K0; MOV K2 next");
  EXPECT_EQ(code(chart.steps[2]), "LD M8000; MOV K3 next");
  EXPECT_EQ(code(chart.steps[3]), "LD M8000; MOV ms since0; MOV K4 next; LD X0; MOV K0 next");
  EXPECT_EQ(chart.steps[3].next, (std::vector<std::size_t>{0, 4}));
  EXPECT_EQ(code(chart.steps[5]), "LD M8000; MOV K0 next");
}

}  // namespace
}  // namespace rung::flowchart
