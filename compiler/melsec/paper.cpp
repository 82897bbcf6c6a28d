// SPDX-License-Identifier: Apache-2.0
#include "melsec/paper.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "melsec/instructions.hpp"

namespace rung {
namespace {

bool in_table_4(const Instruction& instruction) {
  if (instruction.width != 16 || instruction.pulse) return false;
  switch (instruction.op) {
    case Op::Nop:
    case Op::Ld:
    case Op::Ldi:
    case Op::And:
    case Op::Ani:
    case Op::Or:
    case Op::Ori:
    case Op::Out:
    case Op::Mov:
    case Op::Add:
    case Op::Sub:
    case Op::Mul:
    case Op::Div:
      break;
    default:
      return false;
  }
  // Its operands are bits, words and constants.
  return std::all_of(
      instruction.operands.begin(), instruction.operands.end(), [](const Operand& operand) {
        return (operand.kind == Operand::Kind::Device || operand.kind == Operand::Kind::Constant) &&
               !operand.index;
      });
}

}  // namespace

bool check_paper(const Program& program, Diagnostics& diagnostics) {
  bool good = true;
  for (const Instruction& instruction : program.instructions) {
    const std::string_view name = instruction.op == Op::Label
                                      ? std::string_view(instruction.text)
                                      : instruction_name(instruction, program.dialect);
    if (!in_table_4(instruction)) {
      diagnostics.error(program.file, instruction.position,
                        fmt::format("{}: not among the paper's instructions (its Table 4)", name),
                        "compile without --paper, or write it with LD, AND, OR and OUT");
      good = false;
    } else if (instruction.double_width) {
      diagnostics.error(program.file, instruction.position,
                        fmt::format("{}: writes two words, the paper's writes one", name),
                        "use --dialect paper");
      good = false;
    }
  }
  return good;
}

}  // namespace rung
