// SPDX-License-Identifier: Apache-2.0
#include "view/symbol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "rungs/devices.hpp"
#include "rungs/footprint.hpp"
#include "rungs/structure.hpp"

namespace rung::view {
namespace {

constexpr std::array<std::string_view, 19> kSignNames = {
    "contact",  "contact-not", "contact-up", "contact-down", "compare",
    "invert",   "edge-up",     "edge-down",  "coil",         "coil-not",
    "coil-set", "coil-reset",  "coil-up",    "coil-down",    "coil-toggle",
    "box",      "mark",        "short",      "open"};

constexpr std::array<std::string_view, 6> kRelations = {"=", "<>", "<", ">", "<=", ">="};

std::string operand_text(const Operand& operand, const Program& program) {
  const auto name = [&] { return device_name(contact_of(operand.device), program); };
  switch (operand.kind) {
    case Operand::Kind::Device: {
      std::string text = device_name(operand.device, program);
      // In an instruction a timer is T5, whichever part of it is meant.
      if (program.dialect != Dialect::Ldmicro &&
          value_of(operand.device) != contact_of(operand.device)) {
        const std::size_t letter =
            text.find('T') != std::string::npos ? text.find('T') : text.find('C');
        const std::size_t digits = text.find_first_of("0123456789");
        if (letter != std::string::npos && digits != std::string::npos && digits > letter) {
          text = text.substr(0, letter + 1) + text.substr(digits);
        }
      }
      if (operand.index) text += device_name(*operand.index, program);
      return text;
    }
    case Operand::Kind::Digits:
      return fmt::format("K{}{}", operand.digits, name());
    case Operand::Kind::WordBit:
      return fmt::format("{}.{:X}", device_name(operand.device, program), operand.bit);
    case Operand::Kind::Constant:
    case Operand::Kind::Number:
      return std::to_string(operand.value);
  }
  return {};
}

std::string_view ldmicro_word(Op op) {
  switch (op) {
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
    case Op::Osr:
      return "OSR ↑";
    case Op::Osf:
      return "OSF ↓";
    case Op::MasterRelay:
      return "MASTER RLY";
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
      return "SHIFT REG";
    case Op::LookUpTable:
      return "LUT";
    case Op::PiecewiseLinear:
      return "PWL";
    case Op::ReadAdc:
      return "READ ADC";
    case Op::SetPwm:
      return "SET PWM";
    case Op::Persist:
      return "PERSIST";
    case Op::UartSend:
      return "UART SEND";
    case Op::UartRecv:
      return "UART RECV";
    case Op::FormattedString:
      return "STRING";
    default:
      return "?";
  }
}

std::string seconds(std::int64_t us) {
  return us >= 1'000'000 ? fmt::format("{:.6g} s", static_cast<double>(us) / 1e6)
                         : fmt::format("{:.6g} ms", static_cast<double>(us) / 1e3);
}

// An LDmicro element, target first as the program has it: "ADD c = a + b".
std::string ldmicro_text(const Instruction& instruction, const Program& program) {
  const auto at = [&](std::size_t i) { return operand_text(instruction.operand(i), program); };
  const std::string_view word = ldmicro_word(instruction.op);
  const auto sum = [&](char sign) {
    return fmt::format("{} := {} {} {}", at(2), at(0), sign, at(1));
  };
  switch (instruction.op) {
    case Op::Mov:
      return fmt::format("MOV {} := {}", at(1), at(0));
    case Op::Add:
      return "ADD " + sum('+');
    case Op::Sub:
      return "SUB " + sum('-');
    case Op::Mul:
      return "MUL " + sum('*');
    case Op::Div:
      return "DIV " + sum('/');
    case Op::Ton:
    case Op::Tof:
    case Op::Rto:
      return fmt::format("{} {} {}", word, at(0), seconds(instruction.base_us));
    case Op::Ctu:
    case Op::Ctd:
      return fmt::format("{} {} >= {}", word, at(0), at(1));
    case Op::Ctc:
      return fmt::format("{} {} 0..{}", word, at(0), at(1));
    case Op::ShiftRegister:
      return fmt::format("{} {}..{}", word, at(0), instruction.operands.size() - 1);
    case Op::LookUpTable:
    case Op::PiecewiseLinear:
      return fmt::format("{} {} [{}]", word, at(0), at(1));
    case Op::SetPwm:
      return fmt::format("{} {} {} Hz", word, at(0), at(1));
    default:
      return instruction.operands.empty() ? std::string(word) : fmt::format("{} {}", word, at(0));
  }
}

std::string compare_text(const Instruction& instruction, const Program& program) {
  return fmt::format("{}{} {} {}", instruction.width == 32 ? "D " : "",
                     operand_text(instruction.operand(0), program),
                     kRelations[static_cast<std::size_t>(instruction.relation)],
                     operand_text(instruction.operand(1), program));
}

Sign sign_of(const Instruction& instruction, Dialect dialect) {
  switch (instruction.op) {
    case Op::Ld:
    case Op::And:
    case Op::Or:
      return Sign::Contact;
    case Op::Ldi:
    case Op::Ani:
    case Op::Ori:
      return Sign::ContactNot;
    case Op::LdP:
    case Op::AndP:
    case Op::OrP:
      return Sign::ContactUp;
    case Op::LdF:
    case Op::AndF:
    case Op::OrF:
      return Sign::ContactDown;
    case Op::LdCompare:
    case Op::AndCompare:
    case Op::OrCompare:
      return Sign::Compare;
    case Op::Inv:
      return Sign::Invert;
    case Op::Mep:
      return Sign::EdgeUp;
    case Op::Mef:
      return Sign::EdgeDown;
    case Op::Out:
      return Sign::Coil;
    case Op::Outi:
      return Sign::CoilNot;
    case Op::Pls:
      return Sign::CoilUp;
    case Op::Plf:
      return Sign::CoilDown;
    case Op::Short:
      return Sign::Short;
    case Op::Open:
      return Sign::Open;
    case Op::Stl:
      return Sign::Box;
    default:
      break;
  }
  // A coil has one column.
  const bool bit = instruction.operands.size() == 1 && !instruction.pulse &&
                   instruction.operand(0).kind == Operand::Kind::Device &&
                   !instruction.operand(0).index && !is_word(instruction.operand(0).device);
  if (bit && instruction.op == Op::Set) return Sign::CoilSet;
  if (bit && instruction.op == Op::Rst) return Sign::CoilReset;
  if (bit && instruction.op == Op::Alt) return Sign::CoilToggle;
  if (dialect != Dialect::Ldmicro && effect_of(instruction.op) == Effect::Between)
    return Sign::Mark;
  return Sign::Box;
}

// Operands that the instruction writes; of most only one.
std::vector<std::size_t> targets(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::Xch:
    case Op::Zrst:
      return {0, 1};
    case Op::Mov:
    case Op::Cml:
    case Op::Bcd:
    case Op::Bin:
    case Op::Bmov:
    case Op::Fmov:
    case Op::Sftl:
    case Op::Sftr:
    case Op::Wsfl:
    case Op::Wsfr:
    case Op::Mc:
      return {1};
    case Op::Add:
    case Op::Sub:
    case Op::Mul:
    case Op::Div:
    case Op::Wand:
    case Op::Wor:
    case Op::Wxor:
    case Op::Wxnr:
    case Op::Cmp:
      return {2};
    case Op::Zcp:
      return {3};
    case Op::SetPwm:
    case Op::UartSend:
    case Op::FormattedString:
    case Op::Cj:
    case Op::Call:
    case Op::Stl:
      return {};
    case Op::ShiftRegister: {
      std::vector<std::size_t> all;
      for (std::size_t i = 1; i < instruction.operands.size(); ++i) all.push_back(i);
      return all;
    }
    default:
      break;
  }
  if (is_output(instruction.op) || instruction.op >= Op::Ton) return {0};
  return {};
}

}  // namespace

std::string_view sign_name(Sign sign) { return kSignNames.at(static_cast<std::size_t>(sign)); }

Symbol symbol_of(const Instruction& instruction, const Program& program) {
  Symbol symbol;
  symbol.sign = sign_of(instruction, program.dialect);
  for (const Operand& operand : instruction.operands) {
    if (operand.kind == Operand::Kind::Constant || operand.kind == Operand::Kind::Number) continue;
    symbol.devices.push_back(operand.device);
    const Device value = value_of(operand.device);
    if (value != operand.device && (instruction.op == Op::OutT || instruction.op == Op::OutC)) {
      symbol.devices.push_back(value);
    }
    if (operand.index) symbol.devices.push_back(*operand.index);
  }
  switch (symbol.sign) {
    case Sign::Compare:
      symbol.text = compare_text(instruction, program);
      break;
    case Sign::Box:
    case Sign::Mark:
      symbol.text = program.dialect == Dialect::Ldmicro ? ldmicro_text(instruction, program)
                                                        : instruction.text;
      break;
    default:
      if (!instruction.operands.empty())
        symbol.text = operand_text(instruction.operand(0), program);
  }
  return symbol;
}

std::vector<Device> written_devices(const Instruction& instruction, Dialect dialect) {
  std::vector<Device> written;
  const std::vector<std::size_t> which = targets(instruction);
  if (which.empty()) return written;
  const auto is_target = [&](Device device) {
    return std::any_of(which.begin(), which.end(), [&](std::size_t i) {
      const Operand& operand = instruction.operand(i);
      const bool named = operand.kind == Operand::Kind::Device ||
                         operand.kind == Operand::Kind::Digits ||
                         operand.kind == Operand::Kind::WordBit;
      if (!named) return false;
      if (operand.device == device || value_of(operand.device) == device ||
          contact_of(operand.device) == device) {
        return true;
      }
      // Second words, digit groups and ranges follow their head.
      const bool several = operand.kind == Operand::Kind::Digits || instruction.width == 32 ||
                           instruction.double_width || instruction.op == Op::Zrst ||
                           (instruction.op >= Op::Sft && instruction.op <= Op::Bsfr) ||
                           instruction.op == Op::Bmov || instruction.op == Op::Fmov ||
                           (instruction.op >= Op::Wsfl && instruction.op <= Op::Dsfr) ||
                           instruction.op == Op::Cmp || instruction.op == Op::Zcp;
      return several && device.kind == operand.device.kind && device > operand.device;
    });
  };
  for (const Device device : footprint(instruction, dialect)) {
    if (is_target(device)) written.push_back(device);
  }
  std::sort(written.begin(), written.end());
  written.erase(std::unique(written.begin(), written.end()), written.end());
  return written;
}

}  // namespace rung::view
