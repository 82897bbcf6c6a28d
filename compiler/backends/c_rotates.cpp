// SPDX-License-Identifier: Apache-2.0
// Rotates and shifts within one word.
#include "backends/c_instructions.hpp"

namespace rung {
namespace {

bool is_shift(Op op) { return op == Op::Sfl || op == Op::Sfr; }

// The loop that turns v, by one bit each time; `left` takes the bit that left.
void turn(CSource& body, Op op, int width, int count, bool keeps_left) {
  const bool up = op == Op::Rol || op == Op::Rcl || op == Op::Sfl;
  const std::string out = up ? fmt::format("v >> {} & 1u", width - 1) : "v & 1u";
  const std::string turned = up ? "v << 1 | left" : fmt::format("v >> 1 | left << {}", width - 1);
  body.line("unsigned i;");
  body.open("for (i = 0; i < {}; ++i) {{", count);
  if (op == Op::Rcl || op == Op::Rcr) {
    body.line("const uint32_t out = {};", out);
    body.line("v = {};", turned);
    body.line("left = out;");
  } else {
    if (keeps_left) body.line("left = {};", out);
    body.line("v = {};", is_shift(op) ? (up ? "v << 1" : "v >> 1") : turned);
  }
  body.close();
}

}  // namespace

bool write_rotates(CUnit& unit, const Instruction& instruction, const CCondition& condition) {
  if (instruction.op < Op::Rol || instruction.op > Op::Sfr) return false;
  const Op op = instruction.op;
  const bool shift = is_shift(op);
  const int width = instruction.width;
  const std::vector<Device> carries = unit.layout.of_role(SpecialRole::Carry);
  const COperands operands(unit, instruction);
  write_guarded(unit, operands, condition.executed, [&] {
    CSource& body = unit.body;
    body.line("uint32_t v = (uint32_t){}{};", operands.value(0), width == 16 ? " & 0xFFFFu" : "");
    // The bit that left last. Without a turn a rotate leaves the carry as it was.
    const int count = instruction.operand(1).value;
    const bool keeps_left = (!shift && count > 0) || !carries.empty();
    if (keeps_left) {
      body.line("uint32_t left = {};",
                shift || carries.empty() ? "0" : unit.layout.place(carries[0]));
    }
    // Compilers warn of a loop that is never gone through.
    if (count > 0) turn(body, op, width, count, keeps_left);
    operands.store(0, width, "v");
    write_flag(unit, SpecialRole::Carry, "left");
  });
  return true;
}

}  // namespace rung
