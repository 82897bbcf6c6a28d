// SPDX-License-Identifier: Apache-2.0
#include "ldmicro/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "source/text_file.hpp"

namespace rung {
namespace {

// The devices that an element gives a value to, and those that it asks for one. A timer or counter
// does both with its variable.
struct Uses {
  std::vector<Device> given;
  std::vector<Device> asked;
};

void add(std::vector<Device>& devices, const Operand& operand) {
  if (operand.kind == Operand::Kind::Device) devices.push_back(operand.device);
}

Uses uses_of(const Instruction& instruction) {
  Uses uses;
  const auto& operands = instruction.operands;
  switch (instruction.op) {
    case Op::And:
    case Op::Ani:
    case Op::AndCompare:
    case Op::SetPwm:
    case Op::UartSend:
    case Op::FormattedString:
      for (const Operand& operand : operands) add(uses.asked, operand);
      break;
    case Op::Mov:
    case Op::Add:
    case Op::Sub:
    case Op::Mul:
    case Op::Div:
      for (std::size_t i = 0; i + 1 < operands.size(); ++i) add(uses.asked, operands[i]);
      add(uses.given, operands.back());
      break;
    case Op::LookUpTable:
    case Op::PiecewiseLinear:
      add(uses.given, operands[0]);
      add(uses.asked, operands[1]);
      break;
    default:
      for (const Operand& operand : operands) add(uses.given, operand);
      break;
  }
  return uses;
}

class Checks {
 public:
  Checks(const Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics) {}

  void run() {
    for (const Instruction& instruction : program_.instructions) {
      for (const Device device : uses_of(instruction).given) given_.insert(device);
      if (instruction.op != Op::Rto) note_reset(instruction);
    }
    for (const Instruction& instruction : program_.instructions) {
      for (const Device device : uses_of(instruction).asked) check_given(instruction, device);
      check_timer(instruction);
    }
    check_comments();
  }

 private:
  void warn(const Instruction& instruction, std::string what, std::string mend) {
    diagnostics_.warning(program_.file, instruction.position, std::move(what), std::move(mend));
  }

  void note_reset(const Instruction& instruction) {
    for (const Device device : uses_of(instruction).given) reset_.insert(device);
  }

  void check_given(const Instruction& instruction, Device device) {
    if (device.kind == DeviceKind::X || given_.count(device) != 0) return;
    if (!reported_.insert(device).second) return;
    warn(instruction,
         fmt::format("{}: nothing in the program gives {} a value, so that it is always 0",
                     shown(instruction.text), device_name(device, program_)),
         is_word(device) ? "assign to it, with MOVE for instance"
                         : "give it a coil, or another name if it is an input (X)");
  }

  // LDmicro lets a timer's variable be used by no second timer or counter.
  void check_timer(const Instruction& instruction) {
    const bool timer =
        instruction.op == Op::Ton || instruction.op == Op::Tof || instruction.op == Op::Rto;
    const bool counter =
        instruction.op == Op::Ctu || instruction.op == Op::Ctd || instruction.op == Op::Ctc;
    if (!timer && !counter) return;
    const Device device = instruction.operand(0).device;
    const auto [first, is_new] = counting_.try_emplace(device, &instruction);
    if (!is_new && (timer || first->second->op <= Op::Rto)) {
      warn(instruction,
           fmt::format("{}: {} counts in line {} already, and the two disturb each other",
                       shown(instruction.text), device_name(device, program_),
                       first->second->position.line),
           "give each timer a variable of its own");
    }
    if (instruction.op == Op::Rto && reset_.count(device) == 0) {
      warn(instruction,
           fmt::format("{}: nothing resets {}, so that it stays on once it is",
                       shown(instruction.text), device_name(device, program_)),
           fmt::format("put RES {} where it is to begin again", device_name(device, program_)));
    }
  }

  void check_comments() {
    for (const Network& rung : program_.networks) {
      const auto begin =
          program_.instructions.begin() + static_cast<std::ptrdiff_t>(rung.first) + 1;
      const auto end = begin + static_cast<std::ptrdiff_t>(rung.count) - 1;
      const auto comment =
          std::find_if(begin, end, [](const Instruction& each) { return each.op == Op::Comment; });
      if (comment == end || rung.count == 2) continue;
      warn(*comment,
           "COMMENT beside other elements: here it does nothing, but LDmicro 2.3 stops "
           "compiling with an internal error",
           "give it a rung of its own");
    }
  }

  const Program& program_;
  Diagnostics& diagnostics_;
  std::set<Device> given_, reset_, reported_;
  std::map<Device, const Instruction*> counting_;
};

}  // namespace

void check_ld_program(const Program& program, Diagnostics& diagnostics) {
  Checks(program, diagnostics).run();
}

}  // namespace rung
