// SPDX-License-Identifier: Apache-2.0
#include "mapping/mapping.hpp"

#include "passes/support.hpp"

namespace rung::mapping {
namespace {

int lookups(const Mapping& mapping) {
  int count = 0;
  for (const MappedOp& op : mapping.ops) count += is_lookup(op.opcode) ? 1 : 0;
  return count;
}

struct Case {
  const char* text;
  int lookups;
  int operations;
};

// What the mapping makes of typical rungs; operations are steps of MPU2.
TEST(Mapping, LookupsOfTypicalRungs) {
  const Case cases[] = {
      {"LD X0\nOUT Y0\n", 1, 1},
      {"LD X0\nOR Y0\nANI X1\nOUT Y0\n", 1, 1},          // the coil is one of its contacts
      {"LD X0\nOR X1\nANI X2\nOUT Y0\n", 1, 2},          // three other contacts: no free port
      {"LD X0\nAND X1\nOR X2\nAND X3\nOUT Y0\n", 2, 2},  // four contacts: two look-ups
      {"LD X0\nLD X1\nOR X2\nANB\nOUT Y0\n", 1, 2},      // a block of two in three contacts
      {"LD X0\nOR X1\nLD X2\nOR X3\nANB\nOUT Y0\n", 2, 2},
      {"LD X0\nAND X0\nOR X0\nOUT Y0\n", 1, 1},   // one contact, said three times
      {"LD X0\nANI X0\nOR X1\nOUT Y0\n", 1, 1},   // X1
      {"LD X0\nSET M0\nRST M1\nOUT M2\n", 1, 3},  // one condition, three coils
      {"LD X0\nMPS\nOUT Y0\nMRD\nAND X1\nOUT Y1\nMPP\nOUT Y2\n", 2, 3},
      {"LD X0\nAND X1\nMOV K1 D0\nMOV K2 D1\n", 1, 3},
      {"LD X0\nMUL D0 D1 D2\n", 1, 4},      // MULS, MVL, MVH
      {"LD X0\nMUL K300 K300 D2\n", 1, 3},  // two constants: two MV
  };
  for (const Case& one : cases) {
    const core::Program program = lowered(std::string(one.text) + "END\n");
    const logic::Logic logic = logic::build(program);
    const Mapping mapping = map_logic(logic, program, {});
    EXPECT_EQ(verify(mapping, logic, program), "") << one.text;
    EXPECT_EQ(lookups(mapping), one.lookups) << one.text << dump(mapping, Dialect::Fx);
    EXPECT_EQ(mapping.ops.size(), static_cast<std::size_t>(one.operations))
        << one.text << dump(mapping, Dialect::Fx);
  }
}

// Exhaustive: every rung of four contacts in a row, each one of three inputs or its inverse.
TEST(Mapping, EveryRungOfFourContacts) {
  static constexpr const char* kOps[] = {"AND", "ANI", "OR", "ORI"};
  int checked = 0;
  for (int code = 0; code < 2 * 64 * 27; ++code) {
    int rest = code;
    const auto next = [&](int n) {
      const int digit = rest % n;
      rest /= n;
      return digit;
    };
    std::string text = next(2) ? "LDI X0\n" : "LD X0\n";
    for (int i = 0; i < 3; ++i) {
      text += kOps[next(4)];
      text += " X" + std::to_string(next(3)) + "\n";
    }
    const core::Program program = lowered(text + "OUT Y0\nEND\n");
    const logic::Logic logic = logic::build(program);
    const Mapping mapping = map_logic(logic, program, {});
    ASSERT_EQ(verify(mapping, logic, program), "") << text;
    ASSERT_EQ(lookups(mapping), 1) << text;  // three devices at most
    ++checked;
  }
  EXPECT_EQ(checked, 3456);
}

TEST(Mapping, FormulaOfTheRun) {
  for (int n = 1; n <= 40; ++n) {
    for (int m = 2; m <= 4; ++m) {
      const int expected = n <= m ? 1 : (n - m + m - 2) / (m - 1) + 1;
      EXPECT_EQ(run_lookups(n, m), expected);
    }
  }
  EXPECT_EQ(run_lookups(0), 0);
}

TEST(Mapping, BoundOfARung) {
  const core::Program program = lowered(
      "LD X0\nAND X1\nAND X2\nLD X3\nORB\nAND X4\nAND X5\nOUT Y0\nAND X6\nAND X7\nAND X10\n"
      "OUT Y1\nEND\n");
  // 1 + 1, one for ORB, [X4 X5] has its place behind the block: 1, [N0 X6 X7 X10]: 2
  EXPECT_EQ(lookup_bound(program, program.networks[0]), 6);
}

// The check finds every kind of fault that a mapping could have.
TEST(Mapping, VerifyFindsInjectedFaults) {
  const core::Program program =
      lowered("LD X0\nOR X1\nANI X2\nAND X3\nOUT M0\nAND X4\nSET M1\nLD M0\nMOV K1 D0\nEND\n");
  const logic::Logic logic = logic::build(program);
  const Mapping good = map_logic(logic, program, {});
  ASSERT_EQ(verify(good, logic, program), "");
  int faults = 0;
  for (std::size_t i = 0; i < good.ops.size(); ++i) {
    if (is_lookup(good.ops[i].opcode)) {
      for (int bit = 0; bit < 8; ++bit) {
        Mapping bad = good;
        bad.ops[i].function ^= static_cast<std::uint8_t>(1 << bit);
        EXPECT_NE(verify(bad, logic, program), "") << "op " << i << ", function bit " << bit;
        ++faults;
      }
    }
    if (good.ops[i].destination.kind == Destination::Kind::Device) {
      Mapping bad = good;
      bad.ops[i].destination = {};
      EXPECT_NE(verify(bad, logic, program), "") << "op " << i << " does not write";
      ++faults;
    }
    if (good.ops[i].condition != kNoOp) {
      Mapping bad = good;
      bad.ops[i].condition = kNoOp;
      EXPECT_NE(verify(bad, logic, program), "") << "op " << i << " has no condition";
      ++faults;
    }
  }
  Mapping lost = good;
  lost.units.pop_back();
  EXPECT_NE(verify(lost, logic, program), "");
  EXPECT_GT(faults, 30);
}

TEST(Mapping, VerifyFindsMoreLookupsThanTheFormula) {
  const core::Program program = lowered("LD X0\nOUT Y0\nEND\n");
  const logic::Logic logic = logic::build(program);
  Mapping mapping = map_logic(logic, program, {});
  MappedOp extra = mapping.ops[0];
  extra.opcode = isa::Opcode::Lut;
  extra.destination = {};
  extra.action = -1;
  mapping.ops.push_back(extra);
  Unit unit;
  unit.ops.push_back(static_cast<OpId>(mapping.ops.size()) - 1);
  mapping.units.push_back(unit);
  EXPECT_NE(verify(mapping, logic, program).find("formula"), std::string::npos);
}

}  // namespace
}  // namespace rung::mapping
