// SPDX-License-Identifier: Apache-2.0
#include "backends/list_writer.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "melsec/instructions.hpp"

namespace rung {
namespace {

std::string operand(const WordSource& source, Dialect dialect) {
  return source.constant ? fmt::format("K{}", source.value) : device_name(source.device, dialect);
}

}  // namespace

std::string to_list(const Instruction& instruction, Dialect dialect) {
  const std::string_view name = instruction_name(instruction.op, dialect);
  if (instruction.op == Op::Nop || (instruction.op >= Op::Anb && instruction.op <= Op::Mpp)) {
    return std::string(name);
  }
  std::vector<std::string> words{std::string(name)};
  if (instruction.op >= Op::Mov) {
    if (!instruction.two_operand) words.push_back(operand(instruction.sources[0], dialect));
    if (instruction.op != Op::Mov) words.push_back(operand(instruction.sources[1], dialect));
  }
  words.push_back(device_name(instruction.device, dialect));
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
