// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "flowchart/rung_writer.hpp"

namespace rung::flowchart {
namespace {

std::string_view relation_text(Relation relation) {
  switch (relation) {
    case Relation::Equal:
      return "=";
    case Relation::NotEqual:
      return "<>";
    case Relation::Less:
      return "<";
    case Relation::Greater:
      return ">";
    case Relation::LessEqual:
      return "<=";
    case Relation::GreaterEqual:
      break;
  }
  return ">=";
}

// Of what a step has; FX's names, whatever the dialect calls it.
std::string_view name_of(Op op) {
  switch (op) {
    case Op::Ld:
      return "LD";
    case Op::Ldi:
      return "LDI";
    case Op::And:
      return "AND";
    case Op::Ani:
      return "ANI";
    case Op::Or:
      return "OR";
    case Op::Ori:
      return "ORI";
    case Op::LdCompare:
      return "LD";
    case Op::AndCompare:
      return "AND";
    case Op::OrCompare:
      return "OR";
    case Op::Anb:
      return "ANB";
    case Op::Orb:
      return "ORB";
    case Op::Out:
      return "OUT";
    case Op::Set:
      return "SET";
    case Op::Rst:
      return "RST";
    case Op::Mov:
      return "MOV";
    case Op::Add:
      return "ADD";
    case Op::Sub:
      return "SUB";
    case Op::Mul:
      return "MUL";
    case Op::Div:
      return "DIV";
    case Op::Wand:
      return "WAND";
    case Op::Wor:
      return "WOR";
    case Op::Wxor:
      return "WXOR";
    default:
      return "NOP";
  }
}

std::string hidden_name(Device device) {
  if (device == kNextStep) return "next";
  if (device == kTaskCommand) return "task";
  if (device == kStatus) return "status";
  if (device == kMilliseconds) return "ms";
  if (device == kTenths) return "tenths";
  const std::uint32_t n = device.number - kFirstFlowWord;
  if (device.kind == DeviceKind::HB) {
    if (device == kNever) return "never";
    return n < 0x100 ? fmt::format("turned{}", n) : fmt::format("failed{}", n - 0x100);
  }
  return n < 0x200 ? fmt::format("since{}", n - 0x100) : fmt::format("t{}", n - 0x200);
}

std::string operand_text(const Operand& operand, Dialect dialect) {
  switch (operand.kind) {
    case Operand::Kind::Constant:
      return fmt::format("K{}", operand.value);
    case Operand::Kind::Digits:
      return fmt::format("K{}{}", operand.digits, device_name(operand.device, dialect));
    case Operand::Kind::WordBit:
      return fmt::format("{}.{:X}", device_name(operand.device, dialect), operand.bit);
    default:
      break;
  }
  return is_hidden(operand.device.kind) ? hidden_name(operand.device)
                                        : device_name(operand.device, dialect);
}

}  // namespace

std::string instruction_text(const Instruction& instruction, Dialect dialect) {
  std::string text(name_of(instruction.op));
  if (instruction.op >= Op::LdCompare && instruction.op <= Op::OrCompare) {
    text += relation_text(instruction.relation);
  }
  for (const Operand& operand : instruction.operands) {
    text += ' ';
    text += operand_text(operand, dialect);
  }
  return text;
}

}  // namespace rung::flowchart
