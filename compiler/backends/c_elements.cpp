// SPDX-License-Identifier: Apache-2.0
// The elements of an LDmicro program's rungs: those that only change the condition, timers,
// counters.
#include <algorithm>

#include "backends/c_routine.hpp"

namespace rung {
namespace {

// `helper(&value, s, count)`, which gives the output.
void timer(CUnit& unit, const Instruction& instruction, const std::string& s, CHelper helper) {
  unit.body.line("{0} = {1}(&{2}, {0}, {3});", s, unit.helpers.use(helper),
                 unit.layout.place(instruction.operand(0).device), instruction.operand(1).value);
}

void counter(CUnit& unit, const Instruction& instruction, const std::string& s) {
  const std::string value = unit.layout.place(instruction.operand(0).device);
  const std::string rises =
      fmt::format("{}(&{}, {})", unit.helpers.use(CHelper::Rise), unit.edge(instruction), s);
  const std::string word = unit.helpers.use(CHelper::Word);
  const std::string compare = unit.helpers.use(CHelper::Compare);
  const std::int32_t limit = instruction.operand(1).value;
  if (instruction.op != Op::Ctc) {
    unit.body.line("if ({0}) {1} = {2}((uint32_t){1} {3} 1u);", rises, value, word,
                   instruction.op == Op::Ctu ? '+' : '-');
    return unit.body.line("{} = {}({}, {}) >= 0;", s, compare, value, limit);
  }
  unit.body.open("if ({}) {{", rises);
  unit.body.line("{0} = {1}((uint32_t){0} + 1u);", value, word);
  unit.body.line("if ({0}({1}, {2}) >= 0) {1} = 0;", compare, value,
                 static_cast<std::int16_t>(static_cast<std::uint16_t>(limit + 1)));
  unit.body.close();
}

}  // namespace

// What MASTER_RELAY lets through.
void CRoutine::begin_rungs() {
  const auto& instructions = unit_.program.instructions;
  if (std::any_of(instructions.begin(), instructions.end(),
                  [](const Instruction& each) { return each.op == Op::MasterRelay; })) {
    unit_.body.line("{} = 1;", local("relay", true));
  }
}

bool CRoutine::element(const Instruction& instruction) {
  CSource& body = unit_.body;
  const auto branch = [&](std::string_view what, int depth, bool reads = true) {
    return local(fmt::format("{}{}", what, depth), reads);
  };
  switch (instruction.op) {
    case Op::Rung:
      body.line("{} = {};", top(), locals_.contains("relay") ? "relay" : "1");
      return true;
    case Op::Parallel:
      // Only a second branch reads it.
      body.line("{} = {};", branch("in", parallels_, false), top());
      body.line("{} = 0;", branch("any", parallels_));
      ++parallels_;
      return true;
    case Op::Branch:
      body.line("{} |= {};", branch("any", parallels_ - 1), top());
      body.line("{} = {};", top(), branch("in", parallels_ - 1));
      return true;
    case Op::Join:
      --parallels_;
      body.line("{} |= {};", top(), branch("any", parallels_));
      return true;
    case Op::Comment:
    case Op::Short:
      return true;
    case Op::Open:
      body.line("{} = 0;", top());
      return true;
    case Op::Osr:
      body.line("{0} = {1}(&{2}, {0});", top(), unit_.helpers.use(CHelper::Rise),
                unit_.edge(instruction));
      return true;
    case Op::Osf:
      body.open("{{");
      body.line("const unsigned x = {};", top());
      body.line("{} = (x ^ 1u) & {};", top(), unit_.edge(instruction));
      body.line("{} = (uint8_t)x;", unit_.edge(instruction));
      body.close();
      return true;
    case Op::MasterRelay:
      body.line("relay = (relay ^ 1u) | {};", top());
      return true;
    default:
      break;
  }
  for (const auto writer : {write_counts, write_tables, write_peripherals}) {
    if (writer(unit_, instruction, top())) return true;
  }
  return false;
}

bool write_counts(CUnit& unit, const Instruction& instruction, const std::string& s) {
  switch (instruction.op) {
    case Op::Ton:
      timer(unit, instruction, s, CHelper::Ton);
      return true;
    case Op::Tof:
      unit.has_tof = true;
      unit.body.line("if (!@.running) {} = {};", unit.layout.place(instruction.operand(0).device),
                     instruction.operand(1).value);
      timer(unit, instruction, s, CHelper::Tof);
      return true;
    case Op::Rto:
      timer(unit, instruction, s, CHelper::Rto);
      return true;
    case Op::Res:
      unit.body.line("if ({}) {} = 0;", s, unit.layout.place(instruction.operand(0).device));
      return true;
    case Op::Ctu:
    case Op::Ctd:
    case Op::Ctc:
      counter(unit, instruction, s);
      return true;
    default:
      return false;
  }
}

}  // namespace rung
