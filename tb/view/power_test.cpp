// SPDX-License-Identifier: Apache-2.0
// The drawing of a program is its logic: in every scan the power that the drawn wires bring to an
// output is the condition under which the reference executes it. Random programs of all
// instructions; the reference computes its results on stacks and knows nothing of drawings.
//
// RUNG_SEED=N runs program N alone, RUNG_COUNT=N that many (1,000 if not given).
#include <gtest/gtest.h>

#include <cstdlib>

#include "agree/case.hpp"
#include "agree/ldmicro_case.hpp"
#include "rungs/structure.hpp"
#include "view/engine.hpp"
#include "view/program_view.hpp"

namespace rung::tb {
namespace {

std::uint64_t number_of(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

bool is_coil(Op op) { return op == Op::Out || op == Op::Outi || op == Op::Set || op == Op::Rst; }

struct Count {
  std::uint64_t outputs = 0, powered = 0;
};

// The first output of a scan that does not have the power that it should have.
std::string wrong_output(const view::ProgramView& view, const std::vector<Conduction>& seen,
                         Count& count) {
  const Program& program = view.program();
  const std::vector<bool> power = view.power(seen);
  for (const view::RungView& rung : view.rungs()) {
    for (const view::Placed& each : rung.grid.elements) {
      const Instruction& instruction = program.instructions[each.instruction];
      const bool ladder = program.dialect == Dialect::Ldmicro;
      if (ladder ? !is_coil(instruction.op) : effect_of(instruction.op) != Effect::Output) continue;
      const Conduction& done = seen[each.instruction];
      const bool expected = done.executed && done.conducts && (ladder || done.rail);
      ++count.outputs;
      count.powered += expected ? 1 : 0;
      if (power[static_cast<std::size_t>(each.in)] != expected) {
        return "line " + std::to_string(instruction.position.line) + ": " + instruction.text +
               (expected ? " has no power" : " has power");
      }
    }
  }
  return {};
}

template <typename MakeCase>
void check(MakeCase make, const char* which) {
  const std::uint64_t alone = number_of("RUNG_SEED", 0);
  const std::uint64_t last = alone != 0 ? alone : number_of("RUNG_COUNT", 1000);
  Count count;
  for (std::uint64_t seed = alone != 0 ? alone : 1; seed <= last; ++seed) {
    std::string messages;
    const std::optional<Case> one = make(seed, messages);
    ASSERT_TRUE(one) << messages;
    const view::ProgramView view(one->program, {}, seed % 2 == 0 ? 12 : 6);
    const auto engine = view::make_reference_engine(one->program, one->tick_us);
    for (std::size_t scan = 0; scan < one->events.size(); ++scan) {
      engine->scan(one->events[scan]);
      ASSERT_EQ(wrong_output(view, engine->seen(), count), "")
          << "scan " << scan << "\nreplay: RUNG_SEED=" << seed
          << " build/test/tb/view/view_power --gtest_filter=*" << which << "\n"
          << one->text;
    }
  }
  // Both happen, and often.
  EXPECT_GT(count.powered, count.outputs / 20);
  EXPECT_LT(count.powered, count.outputs);
}

TEST(Power, IsTheConditionOfOutputs) {
  check([](std::uint64_t seed,
           std::string& messages) { return make_case(seed, text_of(seed, {}), messages); },
        "IsTheConditionOfOutputs");
}

TEST(Power, IsTheConditionOfLdmicroCoils) {
  check(
      [](std::uint64_t seed, std::string& messages) {
        return make_ldmicro_case(seed, ldmicro_text_of(seed), messages);
      },
      "IsTheConditionOfLdmicroCoils");
}

// No two elements and no wire lie on each other, all of them within the grid.
TEST(Grid, HasRoomForEverything) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    std::string messages;
    const std::optional<Case> one = seed % 2 == 0
                                        ? make_case(seed, text_of(seed, {}), messages)
                                        : make_ldmicro_case(seed, ldmicro_text_of(seed), messages);
    ASSERT_TRUE(one) << messages;
    const view::ProgramView view(one->program, {}, 8);
    for (const view::RungView& rung : view.rungs()) {
      std::vector<std::vector<int>> used(static_cast<std::size_t>(rung.grid.rows),
                                         std::vector<int>(rung.grid.columns));
      const auto take = [&](int row, int from, int to) {
        ASSERT_GE(row, 0);
        ASSERT_LT(row, rung.grid.rows);
        ASSERT_GE(from, 0);
        ASSERT_LE(to, rung.grid.columns);
        for (int column = from; column < to; ++column) {
          ASSERT_EQ(used[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]++, 0)
              << "seed " << seed << ", line " << rung.line << ", row " << row << ", column "
              << column << "\n"
              << one->text;
        }
      };
      for (const view::Placed& each : rung.grid.elements) {
        take(each.row, each.column, each.column + each.width);
      }
      for (const view::Wire& each : rung.grid.wires) take(each.row, each.from, each.to);
      for (const view::Upright& each : rung.grid.uprights) {
        EXPECT_LE(each.from, each.to);
        EXPECT_LT(each.to, rung.grid.rows);
        EXPECT_LE(each.column, rung.grid.columns);
      }
    }
  }
}

}  // namespace
}  // namespace rung::tb
