// SPDX-License-Identifier: Apache-2.0
// The tables of instruction names, and the structure checks against a second way to check them.
#include "rungs/structure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "melsec/instructions.hpp"
#include "melsec/unsupported.hpp"
#include "programs/random_source.hpp"
#include "support.hpp"

namespace rung {
namespace {

TEST(Instructions, NamesDoNotOverlap) {
  for (const std::string_view name : instruction_names()) {
    EXPECT_FALSE(unsupported_instruction(name)) << name;
    EXPECT_FALSE(is_label(name)) << name;
    // In one dialect a name is one instruction, but for OUT.
    for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q}) {
      int forms = 0;
      for (const InstructionForm& form : find_instruction(name)) {
        forms += (form.row->dialects & dialect_bit(dialect)) != 0 ? 1 : 0;
      }
      EXPECT_LE(forms, name == "OUT" ? 3 : 1) << name;
    }
  }
  std::set<std::string_view> names;
  for (const std::string_view name : unsupported_names()) {
    EXPECT_TRUE(names.insert(name).second) << name << " stands twice";
    EXPECT_TRUE(find_instruction(name).empty()) << name;
    ASSERT_TRUE(unsupported_instruction(name)) << name;
    EXPECT_FALSE(unsupported_instruction(name)->reason.empty()) << name;
  }
}

TEST(Instructions, EveryFormIsCalledByANameThatFindsIt) {
  for (const std::string_view name : instruction_names()) {
    for (const InstructionForm& form : find_instruction(name)) {
      Instruction instruction;
      instruction.op = form.row->op;
      instruction.width = form.width;
      instruction.pulse = form.pulse;
      instruction.relation = form.row->relation;
      for (const Dialect dialect : {Dialect::Paper, Dialect::Fx, Dialect::Q}) {
        if ((form.row->dialects & dialect_bit(dialect)) == 0) continue;
        const std::string_view written = instruction_name(instruction, dialect);
        const auto found = find_instruction(written);
        EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                                [&](const InstructionForm& each) {
                                  return each.row->op == form.row->op && each.width == form.width &&
                                         each.pulse == form.pulse &&
                                         each.row->relation == form.row->relation &&
                                         (each.row->dialects & dialect_bit(dialect)) != 0;
                                }))
            << name << " is written " << written;
      }
    }
  }
}

TEST(Instructions, EveryOperationHasAName) {
  for (int op = 0; op <= static_cast<int>(Op::Next); ++op) {
    if (static_cast<Op>(op) == Op::Label) continue;
    const auto rows = source_instructions();
    EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [&](const SourceInstruction& row) {
      return row.op == static_cast<Op>(op);
    })) << op;
  }
}

TEST(Instructions, NamesOfForms) {
  struct Form {
    const char* name;
    Op op;
    int width;
    bool pulse;
    Relation relation;
  };
  const Form kForms[] = {{"DMOVP", Op::Mov, 32, true, Relation::Equal},
                         {"D+P", Op::Add, 32, true, Relation::Equal},
                         {"D/", Op::Div, 32, false, Relation::Equal},
                         {"/P", Op::Div, 16, true, Relation::Equal},
                         {"LDD>=", Op::LdCompare, 32, false, Relation::GreaterEqual},
                         {"ANDD<>", Op::AndCompare, 32, false, Relation::NotEqual},
                         {"OR<", Op::OrCompare, 16, false, Relation::Less},
                         {"DANDP", Op::Wand, 32, true, Relation::Equal},
                         {"FF", Op::Alt, 16, true, Relation::Equal},
                         {"ALT", Op::Alt, 16, false, Relation::Equal},
                         {"DSFLP", Op::Dsfl, 16, true, Relation::Equal},
                         {"CALLP", Op::Call, 16, true, Relation::Equal}};
  for (const Form& form : kForms) {
    const auto found = find_instruction(form.name);
    ASSERT_EQ(found.size(), 1U) << form.name;
    EXPECT_EQ(found[0].row->op, form.op) << form.name;
    EXPECT_EQ(found[0].width, form.width) << form.name;
    EXPECT_EQ(found[0].pulse, form.pulse) << form.name;
    EXPECT_EQ(found[0].row->relation, form.relation) << form.name;
  }
}

// A plain machine for the rules: true if `ops` is a program. It splits into networks with its own
// eyes and then runs each with counters alone.
bool is_program(const std::vector<Op>& ops) {
  int blocks = 0;
  std::vector<int> branches;
  bool output_last = true;
  bool state_last = false;
  for (const Op op : ops) {
    const bool loads = op == Op::Ld || op == Op::LdP || op == Op::LdCompare;
    if (op == Op::Nop) continue;
    if (op == Op::Mcr || op == Op::Next || op == Op::Stl) {
      if (!output_last || !branches.empty()) return false;
      state_last = op == Op::Stl;
      blocks = state_last ? 1 : 0;
      continue;
    }
    if (state_last && !loads && !is_output(op)) return false;
    state_last = false;
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
  constexpr Op kOps[] = {Op::Nop,       Op::Ld,  Op::And, Op::Anb, Op::Mps, Op::Mrd,
                         Op::Mpp,       Op::Out, Op::Out, Op::LdP, Op::Inv, Op::Mcr,
                         Op::LdCompare, Op::Stl, Op::Mc,  Op::Mef, Op::Orb, Op::Next};
  RandomSource random(1);
  int good = 0;
  for (int round = 0; round < 60000; ++round) {
    std::vector<Op> ops;
    std::vector<StructureItem> items;
    const int length = 1 + random.below(9);
    for (int i = 0; i < length; ++i) {
      // Mostly what may follow, so that enough of them are good.
      const Op op =
          i == 0 && random.percent(80) ? Op::Ld
          : i + 1 == length && random.percent(80)
              ? Op::Out
              : kOps[static_cast<std::size_t>(random.below(static_cast<int>(std::size(kOps))))];
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
