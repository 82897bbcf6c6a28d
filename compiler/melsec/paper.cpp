// SPDX-License-Identifier: Apache-2.0
#include "melsec/paper.hpp"

#include <fmt/format.h>

#include "melsec/instructions.hpp"

namespace rung {
namespace {

bool in_table_4(Op op) {
  switch (op) {
    case Op::Anb:
    case Op::Orb:
    case Op::Mps:
    case Op::Mrd:
    case Op::Mpp:
    case Op::Set:
    case Op::Rst:
      return false;
    default:
      return true;
  }
}

}  // namespace

bool check_paper(const Program& program, Diagnostics& diagnostics) {
  bool good = true;
  for (const Instruction& instruction : program.instructions) {
    const std::string_view name = instruction_name(instruction.op, program.dialect);
    if (!in_table_4(instruction.op)) {
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
