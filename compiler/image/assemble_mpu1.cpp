// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include "image/frame.hpp"

namespace rung::image {
namespace {

using core::Op;
using core::WordSource;
using isa::Opcode;
using isa::SlotInstruction;

// Instructions that MPU1 has as they are.
Opcode plain_opcode(Op op) {
  switch (op) {
    case Op::Ld:
      return Opcode::Ld;
    case Op::Ldi:
      return Opcode::Ldi;
    case Op::And:
      return Opcode::And;
    case Op::Ani:
      return Opcode::Ani;
    case Op::Or:
      return Opcode::Or;
    case Op::Ori:
      return Opcode::Ori;
    case Op::Anb:
      return Opcode::Anb;
    case Op::Orb:
      return Opcode::Orb;
    case Op::Inv:
      return Opcode::Inv;
    case Op::Pop:
      return Opcode::Pop;
    case Op::Mps:
      return Opcode::Mps;
    case Op::Mrd:
      return Opcode::Mrd;
    case Op::Mpp:
      return Opcode::Mpp;
    case Op::Out:
      return Opcode::Out;
    case Op::Set:
      return Opcode::Set;
    case Op::Rst:
      return Opcode::Rst;
    case Op::Add:
      return Opcode::Add;
    case Op::Sub:
      return Opcode::Sub;
    case Op::Wand:
      return Opcode::Wand;
    case Op::Wor:
      return Opcode::Wor;
    case Op::Wxor:
      return Opcode::Wxor;
    case Op::Rol:
      return Opcode::Rol;
    case Op::Minu:
      return Opcode::Minu;
    case Op::Mul:
      return Opcode::Mul;
    case Op::Div:
      return Opcode::Div;
    case Op::Mul32:
      return Opcode::Muld;
    case Op::Div32:
      return Opcode::Divd;
    case Op::Eq:
      return Opcode::Eq;
    case Op::Lt:
      return Opcode::Lt;
    case Op::Ltu:
      return Opcode::Ltu;
    case Op::Tb:
      return Opcode::Tb;
    default:
      return Opcode::Nop;
  }
}

class Assembler {
 public:
  Assembler(const core::Program& program, const Addresses& addresses, const isa::Config& config)
      : program_(program), config_(config), addresses_(addresses) {}

  Routine assemble() {
    for (const core::Instruction& instruction : program_.instructions) {
      now_ = &instruction;
      add();
    }
    out_.clocks = isa::constant::fill_clocks;
    for (const auto& step : out_.steps) out_.clocks += config_.clocks(step[0].opcode);
    return std::move(out_);
  }

 private:
  void emit(const SlotInstruction& instruction) {
    out_.steps.push_back({instruction});
    out_.origins.push_back({static_cast<int>(now_->origin)});
    out_.quiet.push_back({static_cast<std::uint8_t>(now_->quiet ? 1 : 0)});
  }
  void emit(Opcode opcode) {
    SlotInstruction out;
    out.opcode = opcode;
    emit(out);
  }
  void bit(Opcode opcode, Device device, bool always = false) {
    SlotInstruction out;
    out.opcode = opcode;
    out.a.device = addresses_.of(device);
    out.always = always;
    emit(out);
  }
  // A word operation or a test; without a target it leaves something in the slot only.
  void word(Opcode opcode, const WordSource& first, const WordSource& second,
            const Device* target) {
    SlotInstruction out;
    out.opcode = opcode;
    set_sources(out, first, second, addresses_);
    out.always = target != nullptr && now_->always;
    if (target != nullptr && isa::info(opcode).format == isa::Format::Test) {
      out.a.device = addresses_.of(*target);
    } else if (target != nullptr) {
      out.rd = addresses_.of(*target);
    }
    emit(out);
  }

  const WordSource& source(std::size_t i) const { return now_->sources.at(i); }
  const Device* target(std::size_t i) const { return &now_->targets.at(i); }

  void add() {
    switch (now_->op) {
      case Op::Mov:
        return word(Opcode::Mv, WordSource{}, source(0), target(0));
      case Op::Add32:
      case Op::Sub32: {
        const bool sum = now_->op == Op::Add32;
        word(sum ? Opcode::Add : Opcode::Sub, source(0), source(2), target(0));
        return word(sum ? Opcode::Adc : Opcode::Sbc, source(1), source(3), target(1));
      }
      case Op::Lt32:
        word(Opcode::Cmp, source(0), source(2), nullptr);
        return word(Opcode::Ltc, source(1), source(3), target(0));
      case Op::Mul:
      case Op::Div:
        word(plain_opcode(now_->op), source(0), source(1), target(0));
        return collect();
      case Op::Mul32:
      case Op::Div32:
        word(Opcode::Ldh, source(1), source(3), nullptr);
        word(plain_opcode(now_->op), source(0), source(2), target(0));
        return collect();
      case Op::Gather:
        return gather();
      case Op::LoadWord:
      case Op::LoadBit:
      case Op::StoreWord:
      case Op::SetBit:
      case Op::RstBit:
        return indexed();
      default:
        break;
    }
    const Opcode opcode = plain_opcode(now_->op);
    switch (isa::info(opcode).format) {
      case isa::Format::None:
        return emit(opcode);
      case isa::Format::Bit:
        return bit(opcode, *target(0), now_->always);
      default:
        return word(opcode, source(0), source(1), target(0));
    }
  }

  // The unit's further words: MUL and DIV have waited for them.
  void collect() {
    const Opcode opcodes[] = {Opcode::Mvl, Opcode::Mvh, Opcode::Mv2, Opcode::Mv3};
    for (std::size_t i = 1; i < now_->targets.size(); ++i) {
      SlotInstruction out;
      out.opcode = opcodes[i];
      out.rd = addresses_.of(*target(i));
      emit(out);
    }
  }

  void gather() {
    for (std::size_t i = now_->reads.size(); i-- > 0;) {
      bit(Opcode::Get, now_->reads[i], i + 1 == now_->reads.size());
    }
    SlotInstruction out;
    out.opcode = Opcode::Mva;
    out.rd = addresses_.of(*target(0));
    out.always = now_->always;
    emit(out);
  }

  void indexed() {
    const auto base = static_cast<std::int16_t>(addresses_.of(now_->head));
    word(Opcode::Ix, source(0), {true, base, {}}, nullptr);
    for (int clock = 1; clock < isa::constant::index_latency; ++clock) emit(Opcode::Nop);
    SlotInstruction out;
    out.always = now_->always;
    switch (now_->op) {
      case Op::LoadBit:
        emit(Opcode::Ldx);
        bit(Opcode::Out, *target(0));
        return emit(Opcode::Pop);
      case Op::LoadWord:
        out.opcode = Opcode::Mvx;
        out.rd = addresses_.of(*target(0));
        break;
      case Op::StoreWord:
        out.opcode = Opcode::Stx;
        set_sources(out, WordSource{}, source(1), addresses_);
        break;
      default:
        out.opcode = now_->op == Op::SetBit ? Opcode::Setx : Opcode::Rstx;
        break;
    }
    emit(out);
  }

  const core::Program& program_;
  const isa::Config& config_;
  const Addresses& addresses_;
  Routine out_;
  const core::Instruction* now_ = nullptr;
};

}  // namespace

Routine assemble_routine(const core::Program& program, const Addresses& addresses,
                         const isa::Config& config) {
  return Assembler(program, addresses, config).assemble();
}

Image assemble_mpu1(const Program& source, const core::Program& program,
                    const isa::Config& config) {
  const Addresses addresses(source, program, config);
  Image image = start_image(source, program, addresses, config, isa::Mpu::Mpu1);
  const Routine routine = assemble_routine(program, addresses, config);
  append(image, routine, 0);
  image.clocks = routine.clocks;
  return image;
}

}  // namespace rung::image
