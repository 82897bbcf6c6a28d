// SPDX-License-Identifier: Apache-2.0
// Moves, exchanges, logic and compares of words.
#include "backends/c_instructions.hpp"
#include "rungs/footprint.hpp"

namespace rung {
namespace {

using Kind = Operand::Kind;

// Whether a C assignment says it all.
bool plain_move(const Instruction& instruction, bool indexed) {
  const auto plain = [&](const Operand& operand) {
    return operand.kind == Kind::Constant || operand.kind == Kind::Device;
  };
  return instruction.width == 16 && !indexed && plain(instruction.operand(0)) &&
         plain(instruction.operand(1));
}

void move(CUnit& unit, const Instruction& instruction, const COperands& operands,
          const CCondition& condition) {
  if (plain_move(instruction, operands.indexed())) {
    return unit.body.line("if ({}) {} = {};", bare(condition.executed), operands.place(1),
                          operands.value(0));
  }
  write_guarded(unit, operands, condition.executed, [&] {
    unit.body.line("const uint32_t v = (uint32_t){};", operands.value(0));
    operands.store(1, instruction.width, "v");
  });
}

// Gives the new value of the target, the last operand, from the sources a and b.
void compute(CUnit& unit, const Instruction& instruction, const COperands& operands,
             const CCondition& condition, std::string_view expression) {
  const std::size_t target = instruction.operands.size() - 1;
  write_guarded(unit, operands, condition.executed, [&] {
    unit.body.line("const uint32_t a = (uint32_t){};", operands.value(0));
    if (target == 2) unit.body.line("const uint32_t b = (uint32_t){};", operands.value(1));
    unit.body.line("const uint32_t v = {};", expression);
    operands.store(target, instruction.width, "v");
  });
}

void exchange(CUnit& unit, const Instruction& instruction, const COperands& operands,
              const CCondition& condition) {
  const Operand& first = instruction.operand(0);
  const Operand& second = instruction.operand(1);
  const int width = instruction.width;
  const auto store = [&](bool first_is_lower) {
    operands.store(first_is_lower ? 0 : 1, width, first_is_lower ? "b" : "a");
    operands.store(first_is_lower ? 1 : 0, width, first_is_lower ? "a" : "b");
  };
  write_guarded(unit, operands, condition.executed, [&] {
    unit.body.line("const uint32_t a = (uint32_t){};", operands.value(0));
    unit.body.line("const uint32_t b = (uint32_t){};", operands.value(1));
    // Where they overlap, the higher one is written last.
    if (width == 32 && operands.indexed() && first.device.kind == second.device.kind) {
      const auto number = [&](std::size_t i) {
        return instruction.operand(i).index ? fmt::format("i{}", i)
                                            : unit.layout.number(instruction.operand(i).device);
      };
      unit.body.open("if ({} <= {}) {{", number(0), number(1));
      store(true);
      unit.body.otherwise();
      store(false);
      unit.body.close();
    } else {
      store(first.device <= second.device);
    }
  });
}

// CMP and ZCP: three bits say how the value compares.
void compare(CUnit& unit, const Instruction& instruction, const COperands& operands,
             const CCondition& condition) {
  const bool zone = instruction.op == Op::Zcp;
  const std::size_t head = zone ? 3 : 2;
  Instruction bits = instruction;
  bits.operands.resize(head);
  for (int i = 0; i < 3; ++i) bits.operands.push_back(element(instruction.operand(head), i, 16));
  const COperands targets(unit, bits);
  write_guarded(unit, operands, condition.executed, [&] {
    unit.body.line("const int32_t a = {};", operands.value(0));
    unit.body.line("const int32_t b = {};", operands.value(1));
    if (zone) unit.body.line("const int32_t s = {};", operands.value(2));
    unit.body.code(targets.set_bit(head, zone ? "s < a" : "a > b"));
    unit.body.code(targets.set_bit(head + 1, zone ? "a <= s && s <= b" : "a == b"));
    unit.body.code(targets.set_bit(head + 2, zone ? "s > b" : "a < b"));
  });
}

// BCD and BIN, which not every value allows.
void convert(CUnit& unit, const Instruction& instruction, const COperands& operands,
             const CCondition& condition) {
  const bool wide = instruction.width == 32;
  write_guarded(unit, operands, condition.executed, [&] {
    if (instruction.op == Op::Bcd) {
      unit.body.line("const int32_t a = {};", operands.value(0));
      unit.body.open("if (a < 0 || a > {}) {{", wide ? 99999999 : 9999);
    } else {
      unit.body.line("const uint32_t v = {}((uint32_t){}{});", unit.helpers.use(CHelper::FromBcd),
                     operands.value(0), wide ? "" : " & 0xFFFFu");
      unit.body.open("if (v == 0xFFFFFFFFu) {{");
    }
    unit.body.line("{}();", unit.helpers.use(CHelper::Fault));
    unit.body.otherwise();
    if (instruction.op == Op::Bcd) {
      unit.body.line("const uint32_t v = {}((uint32_t)a);", unit.helpers.use(CHelper::ToBcd));
    }
    operands.store(1, instruction.width, "v");
    unit.body.close();
  });
}

}  // namespace

bool write_words(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  const COperands operands(unit, instruction);
  const auto result = [&](std::string_view expression) {
    compute(unit, instruction, operands, condition, expression);
    return true;
  };
  switch (instruction.op) {
    case Op::Rst: {
      if (instruction.operand(0).kind != Kind::Device || !is_word(instruction.operand(0).device)) {
        return false;
      }
      write_guarded(unit, operands, condition.executed,
                    [&] { unit.body.line("{} = 0;", operands.place(0)); });
      return true;
    }
    case Op::Mov:
      move(unit, instruction, operands, condition);
      return true;
    case Op::Cml:
      return result("~a");
    case Op::Inc:
      return result("a + 1u");
    case Op::Dec:
      return result("a - 1u");
    case Op::Neg:
      return result("0u - a");
    case Op::Swap:
      return result("(a >> 8 & 0x00FF00FFu) | (a & 0x00FF00FFu) << 8");
    case Op::Wand:
      return result("a & b");
    case Op::Wor:
      return result("a | b");
    case Op::Wxor:
      return result("a ^ b");
    case Op::Wxnr:
      return result("~(a ^ b)");
    case Op::Xch:
      exchange(unit, instruction, operands, condition);
      return true;
    case Op::Bcd:
    case Op::Bin:
      convert(unit, instruction, operands, condition);
      return true;
    case Op::Cmp:
    case Op::Zcp:
      compare(unit, instruction, operands, condition);
      return true;
    default:
      return false;
  }
}

}  // namespace rung
