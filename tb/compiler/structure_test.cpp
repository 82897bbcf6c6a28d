// SPDX-License-Identifier: Apache-2.0
// The tables of instruction names, and the structure checks against a second way to check them.
#include "rungs/structure.hpp"

#include <gtest/gtest.h>

#include <set>

#include "melsec/instructions.hpp"
#include "melsec/unsupported.hpp"
#include "programs/random_source.hpp"
#include "support.hpp"

namespace rung {
namespace {

TEST(Instructions, NamesDoNotOverlap) {
  std::set<std::string_view> names;
  for (const SourceInstruction& instruction : source_instructions()) {
    EXPECT_TRUE(names.insert(instruction.name).second) << instruction.name;
    EXPECT_NE(instruction.dialects, 0);
    EXPECT_FALSE(unsupported_instruction(instruction.name)) << instruction.name;
  }
  for (const std::string_view name : unsupported_names()) {
    EXPECT_TRUE(names.insert(name).second) << name << " stands twice";
    ASSERT_TRUE(unsupported_instruction(name)) << name;
    EXPECT_FALSE(unsupported_instruction(name)->reason.empty()) << name;
  }
}

TEST(Instructions, EveryOperationHasANameInEveryDialect) {
  for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q}) {
    for (int op = 0; op <= static_cast<int>(Op::Div); ++op) {
      const std::string_view name = instruction_name(static_cast<Op>(op), dialect);
      ASSERT_NE(find_instruction(name), nullptr);
      EXPECT_EQ(find_instruction(name)->op, static_cast<Op>(op));
      EXPECT_NE(find_instruction(name)->dialects & dialect_bit(dialect), 0);
    }
  }
}

// A plain machine for the rules: true if `ops` is a program. It splits into networks with its own
// eyes and then runs each with counters alone.
bool is_program(const std::vector<Op>& ops) {
  int blocks = 0;
  std::vector<int> branches;
  bool output_last = true;
  for (const Op op : ops) {
    const bool loads = op == Op::Ld || op == Op::Ldi;
    if (op == Op::Nop) continue;
    if (loads && output_last && blocks == 1 && branches.empty()) blocks = 0;
    if (!loads && blocks == 0) return false;
    if (loads && ++blocks > 8) return false;
    if ((op == Op::Anb || op == Op::Orb) && --blocks == 0) return false;
    if (op == Op::Mps) {
      branches.push_back(blocks);
      if (branches.size() > 11) return false;
    }
    if (op == Op::Mrd || op == Op::Mpp) {
      if (branches.empty() || branches.back() != blocks) return false;
      if (op == Op::Mpp) branches.pop_back();
    }
    if (is_output(op) && blocks != 1) return false;
    output_last = is_output(op);
  }
  return output_last && branches.empty();
}

TEST(Structure, AgreesWithAPlainMachineOnShortPrograms) {
  constexpr Op kOps[] = {Op::Nop, Op::Ld, Op::And, Op::Anb, Op::Mps, Op::Mrd, Op::Mpp, Op::Out};
  RandomSource random(1);
  int good = 0;
  for (int round = 0; round < 60000; ++round) {
    std::vector<Op> ops;
    std::vector<StructureItem> items;
    const int length = 1 + random.below(9);
    for (int i = 0; i < length; ++i) {
      // Mostly what may follow, so that enough of them are good.
      const Op op = i == 0 && random.percent(80) ? Op::Ld
                    : i + 1 == length && random.percent(80)
                        ? Op::Out
                        : kOps[static_cast<std::size_t>(random.below(8))];
      ops.push_back(op);
      items.push_back({effect_of(op), "X", {i + 1, 1}});
    }
    Diagnostics diagnostics;
    check_structure("t", Dialect::Fx, items, diagnostics);
    ASSERT_EQ(!diagnostics.has_errors(), is_program(ops)) << "round " << round << "\n"
                                                          << printed(diagnostics);
    good += diagnostics.has_errors() ? 0 : 1;
  }
  EXPECT_GT(good, 3000);
}

}  // namespace
}  // namespace rung
