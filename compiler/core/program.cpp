// SPDX-License-Identifier: Apache-2.0
#include "core/program.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>

namespace rung::core {
namespace {

constexpr std::string_view kNames[] = {
    "NOP", "LD",   "LDI",  "AND",    "ANI",   "OR",     "ORI",   "ANB",   "ORB",   "INV", "POP",
    "MPS", "MRD",  "MPP",  "OUT",    "SET",   "RST",    "MOV",   "ADD",   "SUB",   "AND", "OR",
    "XOR", "ROL",  "MINU", "ADD32",  "SUB32", "MUL",    "DIV",   "MUL32", "DIV32", "EQ",  "LT",
    "LTU", "LT32", "TB",   "GATHER", "LOADW", "STOREW", "LOADB", "SETB",  "RSTB"};
static_assert(std::size(kNames) == static_cast<std::size_t>(Op::RstBit) + 1);

}  // namespace

std::vector<Device> devices(const Program& program) {
  std::set<Device> all;
  for (const Instruction& instruction : program.instructions) {
    all.insert(instruction.targets.begin(), instruction.targets.end());
    all.insert(instruction.reads.begin(), instruction.reads.end());
    for (const WordSource& source : instruction.sources) {
      if (!source.constant) all.insert(source.device);
    }
  }
  return {all.begin(), all.end()};
}

std::string to_string(const Instruction& instruction, Dialect dialect) {
  std::string text(kNames[static_cast<std::size_t>(instruction.op)]);
  if (is_indexed(instruction.op)) text += " " + device_name(instruction.head, dialect) + "+";
  for (const WordSource& source : instruction.sources) {
    text += source.constant ? fmt::format(" K{}", source.value)
                            : " " + device_name(source.device, dialect);
  }
  const char* mark = is_contact(instruction.op) || is_coil(instruction.op) ? " " : " -> ";
  for (const Device device : instruction.targets) {
    text += mark + device_name(device, dialect);
    mark = " ";
  }
  if (instruction.always) text += " (always)";
  return text;
}

}  // namespace rung::core
