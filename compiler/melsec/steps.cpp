// SPDX-License-Identifier: Apache-2.0
#include "melsec/steps.hpp"

#include <utf8.h>

#include <algorithm>

#include "rungs/devices.hpp"
#include "rungs/special.hpp"

namespace rung {
namespace {

bool is_special(Device device, Dialect dialect) { return find_special(device, dialect) != nullptr; }

// What an FX's operand costs a contact or coil beyond the first step: relays with large numbers,
// indexes and bits of words do not fit into one.
int extra_steps(const Operand& operand, Dialect dialect) {
  if (operand.index || operand.kind == Operand::Kind::WordBit) return 2;
  const Device device = operand.device;
  if (device.kind != DeviceKind::M || is_special(device, dialect)) return 0;
  return device.number >= 3584 ? 2 : device.number >= 1536 ? 1 : 0;
}

int fx_coil(const Instruction& coil, Dialect dialect) {
  const Device device = coil.operand(0).device;
  if (coil.op == Op::Rst && (is_timer(device.kind) || is_counter(device.kind))) return 2;
  if (coil.op == Op::Rst && is_word(device) && coil.operand(0).kind == Operand::Kind::Device) {
    return 3;
  }
  const bool two = device.kind == DeviceKind::S || is_special(device, dialect);
  return (two ? 2 : 1) + extra_steps(coil.operand(0), dialect);
}

int fx_steps(const Instruction& instruction, Dialect dialect) {
  const auto operands = static_cast<int>(instruction.operands.size());
  switch (instruction.op) {
    case Op::LdP:
    case Op::LdF:
    case Op::AndP:
    case Op::AndF:
    case Op::OrP:
    case Op::OrF:
      return std::max(2, 1 + extra_steps(instruction.operand(0), dialect));
    case Op::Out:
    case Op::Outi:
    case Op::Set:
    case Op::Rst:
      return fx_coil(instruction, dialect);
    case Op::Label:
    case Op::Stl:
      return 1;
    case Op::Pls:
    case Op::Plf:
      return 2 + (extra_steps(instruction.operand(0), dialect) > 1 ? 1 : 0);
    case Op::Mc:
      return 3 + (extra_steps(instruction.operand(1), dialect) > 1 ? 1 : 0);
    case Op::Mcr:
      return 2;
    case Op::OutT:
    case Op::OutC:
      return instruction.width == 32 ? 5 : 3;
    default:
      break;
  }
  const bool compare = instruction.op >= Op::LdCompare && instruction.op <= Op::OrCompare;
  if (is_contact(instruction.op) && !compare) {
    return 1 + extra_steps(instruction.operand(0), dialect);
  }
  // Application instructions: each operand takes its words and as many for its kind.
  return 1 + operands * (instruction.width == 32 ? 4 : 2);
}

int q_steps(const Instruction& instruction) {
  const auto written =
      static_cast<int>(instruction.operands.size()) - (instruction.two_operand ? 1 : 0);
  switch (instruction.op) {
    case Op::Out:
    case Op::Outi:
    case Op::Set:
    case Op::Mcr:
    case Op::Label:
      return 1;
    case Op::Rst:
      return is_word(instruction.operand(0).device) &&
                     instruction.operand(0).kind == Operand::Kind::Device
                 ? 2
                 : 1;
    case Op::Mc:
    case Op::Mov:
      return 2;
    case Op::OutT:
    case Op::OutC:
      return 4;
    default:
      break;
  }
  const bool edge_or_compare = instruction.op >= Op::LdP && instruction.op <= Op::OrCompare;
  if (is_contact(instruction.op) && !edge_or_compare) return 1;
  return 1 + written;
}

}  // namespace

int program_steps(const Instruction& instruction, Dialect dialect) {
  return dialect == Dialect::Q ? q_steps(instruction) : fx_steps(instruction, dialect);
}

int text_steps(std::string_view text) {
  // Two steps say how long the text is; Shift-JIS has one byte for ASCII and half-width kana.
  int bytes = 0;
  for (auto at = text.begin(); at != text.end();) {
    const char32_t c = utf8::unchecked::next(at);
    bytes += c < 0x80 || (c >= 0xFF61 && c <= 0xFF9F) ? 1 : 2;
  }
  return 2 + (bytes + 1) / 2;
}

std::vector<int> step_numbers(const Program& program, const CsvProgram* csv) {
  std::vector<int> numbers;
  int step = 0;
  std::size_t text = 0;
  for (std::size_t i = 0; i <= program.instructions.size(); ++i) {
    for (; csv != nullptr && text < csv->texts.size() && csv->texts[text].before <= i; ++text) {
      step += text_steps(csv->texts[text].text);
    }
    numbers.push_back(step);
    if (i < program.instructions.size()) {
      step += program_steps(program.instructions[i], program.dialect);
    }
  }
  return numbers;
}

}  // namespace rung
