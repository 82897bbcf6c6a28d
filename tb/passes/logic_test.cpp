// SPDX-License-Identifier: Apache-2.0
#include "logic/logic.hpp"

#include "passes/support.hpp"

namespace rung::logic {
namespace {

std::string dump_of(const std::string& text) {
  const core::Program program = lowered(text);
  return dump(build(program), program, Dialect::Fx);
}

TEST(Logic, ContactsAndBlocksBecomeNodes) {
  EXPECT_EQ(dump_of("LD X0\nOR M0\nLDI X1\nANB\nOUT M0\nEND\n"),
            "n0 = X0@start\nn1 = M0@start\nn2 = n0 or n1\nn3 = X1@start\nn4 = not n3\n"
            "n5 = n2 and n4\na0: if n5: OUT M0\n");
}

TEST(Logic, AContactBehindACoilIsAnotherLeaf) {
  EXPECT_EQ(dump_of("LD M0\nOUT M0\nAND M0\nOUT Y0\nLD M0\nOUT Y1\nEND\n"),
            "n0 = M0@start\nn1 = M0@a0\nn2 = n0 and n1\nn3 = M0@a0\n"
            "a0: if n0: OUT M0\na1: if n2: OUT Y0\na2: if n3: OUT Y1\n");
}

TEST(Logic, BranchesShareTheirNode) {
  EXPECT_EQ(dump_of("LD X0\nMPS\nAND X1\nOUT Y0\nMRD\nOUT Y1\nMPP\nANI X2\nOUT Y2\nEND\n"),
            "n0 = X0@start\nn1 = X1@start\nn2 = n0 and n1\nn3 = X2@start\nn4 = not n3\n"
            "n5 = n0 and n4\na0: if n2: OUT Y0\na1: if n0: OUT Y1\na2: if n5: OUT Y2\n");
}

TEST(Logic, CurrentAndOverwritten) {
  const core::Program program = lowered("LD X0\nOUT M0\nOUT Y0\nSET M0\nEND\n");
  const Logic logic = build(program);
  const Device m0{DeviceKind::M, 0};
  EXPECT_EQ(logic.current(m0, 0), kStart);
  EXPECT_EQ(logic.current(m0, 1), 0);
  EXPECT_EQ(logic.current(m0, 2), 0);
  EXPECT_EQ(logic.current(m0, 3), 2);
  EXPECT_EQ(logic.overwritten(m0, kStart), 0);
  EXPECT_EQ(logic.overwritten(m0, 0), 2);
  EXPECT_EQ(logic.overwritten(m0, 2), kNever);
}

}  // namespace
}  // namespace rung::logic
