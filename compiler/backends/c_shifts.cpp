// SPDX-License-Identifier: Apache-2.0
// Shifts along devices.
#include "backends/c_instructions.hpp"
#include "rungs/footprint.hpp"

namespace rung {
namespace {

// A row of bits or words from an operand on.
struct Row {
  const Operand& head;
  std::uint32_t count;

  bool words() const { return head.kind == Operand::Kind::Digits || is_word(head.device); }
  std::string type() const { return words() ? "int16_t" : "uint8_t"; }
};

class ShiftWriter {
 public:
  ShiftWriter(CUnit& unit, const Instruction& instruction)
      : unit_(unit), operands_(unit, instruction) {}

  // Declares `name`, a copy of the row.
  void copy(const Row& row, std::string_view name) {
    CSource& body = unit_.body;
    body.line("{} {}[{}];", row.type(), name, row.count);
    if (run(row)) {
      body.open("{{");
      body.line("uint32_t i;");
      body.line("for (i = 0; i < {}u; ++i) {}[i] = ({})[i];", row.count, name, *run(row));
      body.close();
      return;
    }
    for (std::uint32_t i = 0; i < row.count; ++i) {
      const Operand each = element(row.head, static_cast<int>(i), 16);
      if (row.words()) {
        body.line("{}[{}] = (int16_t){};", name, i, operands_.value(each, 16));
      } else {
        body.line("{}[{}] = {};", name, i, unit_.layout.place(each.device));
      }
    }
  }

  // Shifts `target` by `count`; what moves in is in the array `source`.
  void shift(const Row& target, bool up, std::uint32_t count, std::string_view source) {
    const CHelper helper = target.words() ? (up ? CHelper::RiseWords : CHelper::FallWords)
                                          : (up ? CHelper::RiseBits : CHelper::FallBits);
    const std::string name = unit_.helpers.use(helper);
    if (run(target)) {
      unit_.body.line("{}({}, {}, {}u, {}u);", name, *run(target), source, target.count, count);
      return;
    }
    copy(target, "target");
    unit_.body.line("{}(target, {}, {}u, {}u);", name, source, target.count, count);
    for (std::uint32_t i = 0; i < target.count; ++i) {
      const Operand each = element(target.head, static_cast<int>(i), 16);
      if (target.words()) {
        unit_.body.open("{{");
        unit_.body.line("const uint32_t v = (uint32_t)target[{}];", i);
        operands_.store(each, 16, "v");
        unit_.body.close();
      } else {
        unit_.body.line("{} = target[{}];", unit_.layout.place(each.device), i);
      }
    }
  }

 private:
  std::optional<std::string> run(const Row& row) const {
    if (row.head.kind == Operand::Kind::Digits) return std::nullopt;
    return unit_.layout.run(row.head.device, row.count);
  }

  CUnit& unit_;
  COperands operands_;
};

std::uint32_t count_of(const Operand& operand) { return static_cast<std::uint32_t>(operand.value); }

// SFTL SFTR WSFL WSFR.
void shift_in(CUnit& unit, const Instruction& instruction, const CCondition& condition, bool up) {
  const std::uint32_t count = count_of(instruction.operand(3));
  const Row source{instruction.operand(0), count};
  const Row target{instruction.operand(1), count_of(instruction.operand(2))};
  if (count == 0 || target.count == 0) return;
  write_guarded(unit, COperands(unit, instruction), condition.executed, [&] {
    ShiftWriter writer(unit, instruction);
    writer.copy(source, "source");
    writer.shift(target, up, count, "source");
  });
}

// BSFL BSFR DSFL DSFR: by one, 0 moves in; of bits the carry takes what moves out.
void shift_by_one(CUnit& unit, const Instruction& instruction, const CCondition& condition,
                  bool up) {
  const Row target{instruction.operand(0), count_of(instruction.operand(1))};
  if (target.count == 0) return;
  const bool carry = !target.words() && !unit.layout.of_role(SpecialRole::Carry).empty();
  write_guarded(unit, COperands(unit, instruction), condition.executed, [&] {
    unit.body.line("static const {} source[1] = {{0}};", target.type());
    if (carry) {
      const int last = up ? static_cast<int>(target.count) - 1 : 0;
      unit.body.line("const uint8_t left = {};",
                     unit.layout.place(element(target.head, last, 16).device));
    }
    ShiftWriter(unit, instruction).shift(target, up, 1, "source");
    if (carry) write_flag(unit, SpecialRole::Carry, "left");
  });
}

}  // namespace

bool write_shifts(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  switch (instruction.op) {
    case Op::Sftl:
    case Op::Wsfl:
      shift_in(unit, instruction, condition, true);
      return true;
    case Op::Sftr:
    case Op::Wsfr:
      shift_in(unit, instruction, condition, false);
      return true;
    case Op::Bsfl:
    case Op::Dsfl:
      shift_by_one(unit, instruction, condition, true);
      return true;
    case Op::Bsfr:
    case Op::Dsfr:
      shift_by_one(unit, instruction, condition, false);
      return true;
    default:
      return false;
  }
}

}  // namespace rung
