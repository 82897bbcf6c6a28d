// SPDX-License-Identifier: Apache-2.0
#include "backends/list_writer.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "melsec/instructions.hpp"
#include "melsec/operands.hpp"

namespace rung {
namespace {

std::string operand_text(const Operand& operand, Op op, Dialect dialect) {
  switch (operand.kind) {
    case Operand::Kind::Constant:
      return fmt::format("K{}", operand.value);
    case Operand::Kind::Digits:
      return fmt::format("K{}{}", operand.digits, source_name(operand.device, dialect));
    case Operand::Kind::WordBit:
      return fmt::format("{}.{:X}", source_name(operand.device, dialect), operand.bit);
    case Operand::Kind::Number:
      return fmt::format("{}{}", op == Op::Mc || op == Op::Mcr ? 'N' : 'P', operand.value);
    case Operand::Kind::Device:
      break;
  }
  std::string text = source_name(operand.device, dialect);
  if (operand.index) text += device_name(*operand.index, dialect);
  return text;
}

}  // namespace

std::string to_list(const Instruction& instruction, Dialect dialect) {
  std::vector<std::string> words;
  if (instruction.op != Op::Label) words.emplace_back(instruction_name(instruction, dialect));
  // The first of three operands written as two is the last of them again.
  const std::size_t first = instruction.two_operand ? 1 : 0;
  for (std::size_t i = first; i < instruction.operands.size(); ++i) {
    words.push_back(operand_text(instruction.operands[i], instruction.op, dialect));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

std::string to_list(const Program& program) {
  std::string text =
      fmt::format("; dialect {0}: read it with --dialect {0}\n", dialect_name(program.dialect));
  for (const Network& network : program.networks) {
    if (network.first != 0) text += '\n';
    for (std::size_t i = network.first; i < network.first + network.count; ++i) {
      text += to_list(program.instructions[i], program.dialect) + '\n';
    }
  }
  return text + "END\n";
}

}  // namespace rung
