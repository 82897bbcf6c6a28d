// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "backends/ld_writer.hpp"

namespace rung {
namespace {

// In the order of Relation.
constexpr std::string_view kRelations[] = {"EQU", "NEQ", "LES", "GRT", "LEQ", "GEQ"};

std::string_view keyword(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::And:
    case Op::Ani:
      return "CONTACTS";
    case Op::AndCompare:
      return kRelations[static_cast<std::size_t>(instruction.relation)];
    case Op::Out:
    case Op::Outi:
    case Op::Set:
    case Op::Rst:
      return "COIL";
    case Op::Mov:
      return "MOVE";
    case Op::Add:
      return "ADD";
    case Op::Sub:
      return "SUB";
    case Op::Mul:
      return "MUL";
    case Op::Div:
      return "DIV";
    case Op::Short:
      return "SHORT";
    case Op::Open:
      return "OPEN";
    case Op::Osr:
      return "OSR";
    case Op::Osf:
      return "OSF";
    case Op::MasterRelay:
      return "MASTER_RELAY";
    case Op::Ton:
      return "TON";
    case Op::Tof:
      return "TOF";
    case Op::Rto:
      return "RTO";
    case Op::Res:
      return "RES";
    case Op::Ctu:
      return "CTU";
    case Op::Ctd:
      return "CTD";
    case Op::Ctc:
      return "CTC";
    case Op::ShiftRegister:
      return "SHIFT_REGISTER";
    case Op::LookUpTable:
      return "LOOK_UP_TABLE";
    case Op::PiecewiseLinear:
      return "PIECEWISE_LINEAR";
    case Op::ReadAdc:
      return "READ_ADC";
    case Op::SetPwm:
      return "SET_PWM";
    case Op::Persist:
      return "PERSIST";
    case Op::UartSend:
      return "UART_SEND";
    case Op::UartRecv:
      return "UART_RECV";
    default:
      return "FORMATTED_STRING";
  }
}

// The file's name: in traces a variable that shares its name with a bit has an ending.
std::string file_name(Device device, const Program& program) {
  std::string name = device_name(device, program);
  if (name.ends_with(":w")) name.resize(name.size() - 2);
  return name;
}

std::string operand_text(const Operand& operand, const Program& program) {
  if (operand.kind == Operand::Kind::Device) return file_name(operand.device, program);
  return fmt::format("{}", operand.value);
}

// What stands behind the keyword and the operands that are devices or plain numbers.
class ElementText {
 public:
  ElementText(const Instruction& instruction, const Program& program)
      : instruction_(instruction), program_(program) {
    words_.emplace_back(keyword(instruction));
  }

  std::string text() {
    add_operands();
    return fmt::format("{}", fmt::join(words_, " "));
  }

 private:
  void add(std::string word) { words_.push_back(std::move(word)); }
  void add_operand(std::size_t i) { add(operand_text(instruction_.operand(i), program_)); }
  void add_number(std::int64_t number) { add(fmt::format("{}", number)); }
  void add_table() {
    for (const std::int32_t value : instruction_.table) add_number(value);
  }

  void add_operands() {
    const std::size_t count = instruction_.operands.size();
    switch (instruction_.op) {
      case Op::And:
      case Op::Ani:
        add_operand(0);
        return add_number(instruction_.op == Op::Ani ? 1 : 0);
      case Op::Out:
      case Op::Outi:
      case Op::Set:
      case Op::Rst:
        add_operand(0);
        for (const Op mark : {Op::Outi, Op::Set, Op::Rst}) {
          add_number(instruction_.op == mark ? 1 : 0);
        }
        return;
      case Op::Mov:
      case Op::Add:
      case Op::Sub:
      case Op::Mul:
      case Op::Div:  // the target first
        add_operand(count - 1);
        for (std::size_t i = 0; i + 1 < count; ++i) add_operand(i);
        return;
      case Op::Ton:
      case Op::Tof:
      case Op::Rto:
        add_operand(0);
        return add_number(instruction_.base_us);
      case Op::ReadAdc:
      case Op::Persist:  // their numbers follow from their order
        return add_operand(0);
      case Op::ShiftRegister: {
        std::string name = operand_text(instruction_.operand(0), program_);
        name.pop_back();  // the 0 of the first stage
        add(name);
        return add_number(static_cast<std::int64_t>(count));
      }
      case Op::LookUpTable:
        add_operand(0);
        add_operand(1);
        add_number(static_cast<std::int64_t>(instruction_.table.size()));
        add_operand(2);
        return add_table();
      case Op::PiecewiseLinear:
        add_operand(0);
        add_operand(1);
        add_number(static_cast<std::int64_t>(instruction_.table.size() / 2));
        return add_table();
      case Op::FormattedString:
        add(count == 0 ? "(none)" : operand_text(instruction_.operand(0), program_));
        add_number(static_cast<std::int64_t>(instruction_.table.size()));
        return add_table();
      default:
        for (std::size_t i = 0; i < count; ++i) add_operand(i);
        return;
    }
  }

  const Instruction& instruction_;
  const Program& program_;
  std::vector<std::string> words_;
};

}  // namespace

std::string to_ld(const Instruction& instruction, const Program& program) {
  return ElementText(instruction, program).text();
}

}  // namespace rung
