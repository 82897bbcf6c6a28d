// SPDX-License-Identifier: Apache-2.0
// LDmicro: the rung, its branches, and the elements that only change the condition.
#include "reference/reference.hpp"

namespace rung {

void Reference::execute_element(const Instruction& instruction) {
  const Op op = instruction.op;
  if (op <= Op::Join) return execute_frame(op);
  switch (op) {
    case Op::Short:
      return;
    case Op::Open:
      now_.result = false;
      return;
    case Op::Osr:
      now_.result = rises();
      return;
    case Op::Osf: {
      const bool before = exchange_memory(now_.result);
      now_.result = before && !now_.result;
      return;
    }
    case Op::MasterRelay:
      relay_ = !relay_ || now_.result;
      return;
    case Op::Ton:
    case Op::Tof:
    case Op::Rto:
      return execute_timer(instruction);
    case Op::Res:
      if (now_.result) change(instruction.operand(0).device, 0);
      return;
    case Op::Ctu:
    case Op::Ctd:
    case Op::Ctc:
      return execute_counter(instruction);
    case Op::ShiftRegister:
      return shift_stages(instruction);
    case Op::LookUpTable:
      return look_up(instruction);
    case Op::PiecewiseLinear:
      return interpolate(instruction);
    default:
      return execute_peripheral(instruction);
  }
}

void Reference::execute_frame(Op op) {
  switch (op) {
    case Op::Rung:
      now_.result = relay_;
      return;
    case Op::Parallel:
      forks_.push_back({now_.result, false});
      return;
    case Op::Branch:
      forks_.back().any |= now_.result;
      now_.result = forks_.back().into;
      return;
    case Op::Join:
      now_.result = now_.result || forks_.back().any;
      forks_.pop_back();
      return;
    default:
      return;
  }
}

std::int16_t Reference::variable_of(const Operand& operand) const {
  return static_cast<std::int16_t>(read_word(operand, 16));
}

bool Reference::rises() { return !exchange_memory(now_.result) && now_.result; }

}  // namespace rung
