// SPDX-License-Identifier: Apache-2.0
#include "bytecode/code.hpp"

#include <utility>

#include "bytecode/opcodes.hpp"

namespace rung::bytecode {
namespace {

using core::Op;

// What one IF guards at most, so that its distance has 15 bits whatever instruction comes last.
constexpr std::size_t kLongestGuarded = 30000;

// The instruction of the same kind; of the contacts those that do not push.
Code code_of(Op op) {
  switch (op) {
    case Op::Ld:
      return Code::LD;
    case Op::Ldi:
      return Code::LDI;
    case Op::And:
      return Code::AND;
    case Op::Ani:
      return Code::ANI;
    case Op::Or:
      return Code::OR;
    case Op::Ori:
      return Code::ORI;
    case Op::Anb:
      return Code::ANB;
    case Op::Orb:
      return Code::ORB;
    case Op::Inv:
      return Code::INV;
    case Op::Pop:
      return Code::POP;
    case Op::Mps:
      return Code::MPS;
    case Op::Mrd:
      return Code::MRD;
    case Op::Mpp:
      return Code::MPP;
    case Op::Out:
      return Code::OUT;
    case Op::Set:
      return Code::SET;
    case Op::Rst:
      return Code::RST;
    case Op::Mov:
      return Code::MOV;
    case Op::Add:
      return Code::ADD;
    case Op::Sub:
      return Code::SUB;
    case Op::Wand:
      return Code::WAND;
    case Op::Wor:
      return Code::WOR;
    case Op::Wxor:
      return Code::WXOR;
    case Op::Rol:
      return Code::ROL;
    case Op::Minu:
      return Code::MINU;
    case Op::Add32:
      return Code::ADD32;
    case Op::Sub32:
      return Code::SUB32;
    case Op::Mul:
      return Code::MUL;
    case Op::Div:
      return Code::DIV;
    case Op::Mul32:
      return Code::MUL32;
    case Op::Div32:
      return Code::DIV32;
    case Op::Eq:
      return Code::EQ;
    case Op::Lt:
      return Code::LT;
    case Op::Ltu:
      return Code::LTU;
    case Op::Lt32:
      return Code::LT32;
    case Op::Tb:
      return Code::TB;
    case Op::Gather:
      return Code::GATHER;
    case Op::LoadWord:
      return Code::LOADW;
    case Op::StoreWord:
      return Code::STOREW;
    case Op::LoadBit:
      return Code::LOADB;
    case Op::SetBit:
      return Code::SETB;
    case Op::RstBit:
      return Code::RSTB;
    case Op::Nop:
      break;
  }
  return Code::END;
}

// Only done when the result is 1, by an instruction that knows nothing of the result.
bool is_guarded(const core::Instruction& instruction) {
  return core::is_output(instruction.op) && instruction.op != Op::Out &&
         instruction.op != Op::LoadBit && !instruction.always;
}

class Encoder {
 public:
  Encoder(const core::Program& program, const Layout& layout, const StackPlan& plan)
      : program_(program), layout_(layout), plan_(plan) {}

  std::string run() {
    const std::size_t count = program_.instructions.size();
    for (std::size_t i = 0; i < count;) {
      if (!is_guarded(program_.instructions[i])) {
        one(i++);
        continue;
      }
      std::size_t end = i;
      bool only_coils = true;
      for (; end < count && is_guarded(program_.instructions[end]); ++end) {
        only_coils = only_coils && core::is_coil(program_.instructions[end].op);
      }
      if (only_coils) {
        for (; i < end; ++i) bit(code_of(program_.instructions[i].op), i);
      } else {
        i = guarded(i, end);
      }
    }
    put(Code::END);
    return std::move(code_);
  }

 private:
  void put(Code code) { code_ += static_cast<char>(code); }
  void byte(std::size_t value) { code_ += static_cast<char>(value); }
  void number(int value) {
    if (value >= 0x80) code_ += static_cast<char>(0x80 | value >> 8);
    code_ += static_cast<char>(value & 0xFF);
  }
  void bit(Code code, std::size_t i) {
    put(code);
    number(layout_.number(program_.instructions[i].targets.at(0)));
  }

  // IF in front of as many of the instructions from `begin` to `end` as it can guard.
  std::size_t guarded(std::size_t begin, std::size_t end) {
    std::string before = std::move(code_);
    code_.clear();
    for (; begin < end && code_.size() < kLongestGuarded; ++begin) one(begin);
    const std::string body = std::exchange(code_, std::move(before));
    put(Code::IF);
    number(static_cast<int>(body.size()));
    code_ += body;
    return begin;
  }

  // An instruction that runs whatever the result is, or uses it by its nature.
  void one(std::size_t i) {
    const core::Instruction& instruction = program_.instructions[i];
    switch (instruction.op) {
      case Op::Nop:
        return;
      case Op::Ld:
        return bit(plan_.pushes[i] ? Code::BLD : Code::LD, i);
      case Op::Ldi:
        return bit(plan_.pushes[i] ? Code::BLDI : Code::LDI, i);
      case Op::Pop:
        if (!plan_.dropped[i]) put(Code::POP);
        return;
      case Op::Set:
        return bit(Code::ON, i);
      case Op::Rst:
        return bit(Code::OFF, i);
      default:
        break;
    }
    if (core::is_output(instruction.op) && instruction.op != Op::Out) return output(instruction);
    if (core::is_contact(instruction.op) || instruction.op == Op::Out) {
      return bit(code_of(instruction.op), i);
    }
    put(code_of(instruction.op));
  }

  void output(const core::Instruction& instruction) {
    put(code_of(instruction.op));
    const std::vector<core::WordSource>& sources = instruction.sources;
    if (instruction.op == Op::Gather) {
      byte(instruction.reads.size());
      for (const Device device : instruction.reads) number(layout_.number(device));
    } else if (core::is_indexed(instruction.op)) {
      indexed(instruction);
    } else if (instruction.op == Op::Tb) {
      number(layout_.number(sources.at(0)));
      byte(static_cast<std::size_t>(sources.at(1).value & 15));
    } else {
      for (const core::WordSource& source : sources) number(layout_.number(source));
    }
    if (core::is_muldiv(instruction.op)) byte(instruction.targets.size());
    // What an index leads to are no targets of their own.
    const bool window = instruction.op == Op::StoreWord || instruction.op == Op::SetBit ||
                        instruction.op == Op::RstBit;
    if (window) return;
    for (const Device device : instruction.targets) number(layout_.number(device));
  }

  void indexed(const core::Instruction& instruction) {
    const bool loads = instruction.op == Op::LoadWord || instruction.op == Op::LoadBit;
    const std::vector<Device>& window = loads ? instruction.reads : instruction.targets;
    number(layout_.number(instruction.sources.at(0)));
    number(layout_.number(instruction.head));
    number(static_cast<int>(window.size()));
    if (instruction.op == Op::StoreWord) number(layout_.number(instruction.sources.at(1)));
  }

  const core::Program& program_;
  const Layout& layout_;
  const StackPlan& plan_;
  std::string code_;
};

}  // namespace

std::string encode(const core::Program& program, const Layout& layout, const StackPlan& plan) {
  return Encoder(program, layout, plan).run();
}

}  // namespace rung::bytecode
