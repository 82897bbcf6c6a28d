// SPDX-License-Identifier: Apache-2.0
// Zones of MC and STL, jumps, subroutines and loops.
#include <utility>

#include "reference/reference.hpp"

namespace rung {

void Reference::execute_zone(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::Mc: {
      const bool on = condition();
      write_bit(instruction.operand(1), on);
      now_.masters.push_back({instruction.operand(0).value, on});
      return;
    }
    case Op::Mcr:
      std::erase_if(now_.masters, [&](const Master& master) {
        return master.level >= instruction.operand(0).value;
      });
      return;
    case Op::Stl:
      return begin_state(instruction.operand(0).device);
    default:  // RET
      now_.states.clear();
      now_.state_power = true;
  }
}

void Reference::begin_state(Device state) {
  const auto is_stl = [&](std::size_t i) { return program_.instructions[i].op == Op::Stl; };
  const bool in_series = current_ > 0 && is_stl(current_ - 1);
  if (left_states_.erase(state) != 0) change(state, 0);
  const bool active = get(state) != 0 && (!in_series || now_.state_power);
  const bool was_active = exchange_memory(active);

  if (!in_series) now_.states.clear();
  now_.states.push_back(state);
  now_.state_power = active;
  now_.result = true;
  now_.blocks.clear();
  now_.branches.clear();
  if (active || was_active) return;
  while (next_ < program_.instructions.size() && !is_stl(next_) &&
         program_.instructions[next_].op != Op::Ret) {
    ++next_;
  }
}

bool Reference::transition(const Operand& state) {
  if (now_.states.empty() || state.kind != Operand::Kind::Device ||
      state.device.kind != DeviceKind::S) {
    return false;
  }
  if (!condition()) return true;
  write(state.device, 1);
  left_states_.insert(now_.states.begin(), now_.states.end());
  return true;
}

void Reference::execute_flow(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::Cj:
      if (executes(instruction)) next_ = instruction.destination;
      return;
    case Op::Call:
      if (!executes(instruction)) return;
      now_.back = next_;
      callers_.push_back(std::exchange(now_, {}));
      next_ = instruction.destination;
      return;
    case Op::Sret:
      now_ = std::move(callers_.back());
      callers_.pop_back();
      next_ = now_.back;
      return;
    case Op::Fend:
      next_ = program_.instructions.size();
      return;
    case Op::For:
      if (instruction.operand(0).value > 0) {
        loops_.push_back({next_, instruction.operand(0).value});
      } else {
        next_ = instruction.destination + 1;
      }
      return;
    case Op::Next: {
      Loop& loop = loops_.back();
      if (--loop.left > 0) {
        next_ = loop.begin;
      } else {
        loops_.pop_back();
      }
      return;
    }
    default:
      return;
  }
}

}  // namespace rung
