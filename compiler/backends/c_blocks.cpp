// SPDX-License-Identifier: Apache-2.0
// BMOV, FMOV, ZRST.
#include <algorithm>

#include "backends/c_instructions.hpp"
#include "rungs/devices.hpp"
#include "rungs/footprint.hpp"

namespace rung {
namespace {

bool is_row(const Operand& head) { return head.kind == Operand::Kind::Device; }

void block_move(CUnit& unit, const Instruction& instruction, const COperands& operands) {
  const Operand& source = instruction.operand(0);
  const Operand& target = instruction.operand(1);
  const int count = instruction.operand(2).value;
  const int width = instruction.width;
  if (is_row(source) && is_row(target)) {
    const int size = count * width / 16;
    unit.body.line("const int16_t *const s = {};", unit.layout.pointer(source.device));
    unit.body.line("int16_t *const d = {};", unit.layout.pointer(target.device));
    unit.body.line("uint32_t i;");
    // Where they overlap, what is still to be read must not be written before.
    const bool descending = source.device < target.device;
    unit.body.code(descending ? fmt::format("for (i = {}u; i-- > 0;) d[i] = s[i];", size)
                              : fmt::format("for (i = 0; i < {}u; ++i) d[i] = s[i];", size));
    return;
  }
  unit.body.line("uint32_t v[{}];", count);
  for (int i = 0; i < count; ++i) {
    unit.body.line("v[{}] = (uint32_t){};", i, operands.value(element(source, i, width), width));
  }
  for (int i = 0; i < count; ++i) {
    operands.store(element(target, i, width), width, fmt::format("v[{}]", i));
  }
}

void fill_move(CUnit& unit, const Instruction& instruction, const COperands& operands) {
  const Operand& target = instruction.operand(1);
  const int count = instruction.operand(2).value;
  const int width = instruction.width;
  if (is_row(target) && width == 16) {
    unit.body.line("const int16_t v = (int16_t){};", operands.value(0));
    unit.body.line("int16_t *const d = {};", unit.layout.pointer(target.device));
    unit.body.line("uint32_t i;");
    unit.body.line("for (i = 0; i < {}u; ++i) d[i] = v;", count);
    return;
  }
  unit.body.line("const uint32_t v = (uint32_t){};", operands.value(0));
  for (int i = 0; i < count; ++i) operands.store(element(target, i, width), width, "v");
}

void clear(CUnit& unit, Device first, std::uint32_t count) {
  if (count == 1) return unit.body.line("{} = 0;", unit.layout.place(first));
  unit.body.open("{{");
  unit.body.line("{} *const d = {};", CLayout::type(first.kind), unit.layout.pointer(first));
  unit.body.line("uint32_t i;");
  unit.body.line("for (i = 0; i < {}u; ++i) d[i] = 0;", count);
  unit.body.close();
}

void reset_range(CUnit& unit, Device first, Device last) {
  const std::uint32_t count = std::max(first.number, last.number) - first.number + 1;
  if (!is_timer(first.kind) && !is_counter(first.kind)) return clear(unit, first, count);
  const Device contact = contact_of(first);
  const Device value = value_of(contact);
  clear(unit, contact, count);
  clear(unit, value, count);
  // All of them are of one width.
  if (is_32_bit_counter(contact, unit.program.dialect)) {
    clear(unit, high_word(value, unit.program.dialect), count);
  }
}

}  // namespace

bool write_blocks(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  const COperands operands(unit, instruction);
  const auto guarded = [&](const std::function<void()>& lines) {
    write_guarded(unit, operands, condition.executed, lines);
    return true;
  };
  switch (instruction.op) {
    case Op::Bmov:
    case Op::Fmov:
      if (instruction.operand(2).value <= 0) return true;
      return guarded([&] {
        if (instruction.op == Op::Bmov) {
          block_move(unit, instruction, operands);
        } else {
          fill_move(unit, instruction, operands);
        }
      });
    case Op::Zrst:
      return guarded(
          [&] { reset_range(unit, instruction.operand(0).device, instruction.operand(1).device); });
    default:
      return false;
  }
}

}  // namespace rung
