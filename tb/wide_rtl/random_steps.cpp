// SPDX-License-Identifier: Apache-2.0
#include "wide_rtl/random_steps.hpp"

#include <algorithm>
#include <tuple>

namespace rung::tb::wide {

namespace {

class Generator {
 public:
  Generator(std::mt19937& random, int slots, int length)
      : random_(random),
        slots_(slots),
        units_(slots / 2),
        dividers_(rung::wide::find_machine(slots)->dividers),
        length_(length),
        state_(static_cast<std::size_t>(units_)) {
    program_.latch_rows = below(13);
    // Close behind the steps or far away; only rows of bits may lie where rows of words do not.
    program_.latch_row = length + below(std::min(64, kSpecial - length - 13));
    latch_times_ = std::max(program_.latch_rows, constant::scan_latch_free);
  }

  RandomProgram generate() {
    for (now_ = 0; now_ < length_; ++now_) {
      Step step;
      for (int slot = 0; slot < slots_; ++slot) {
        BitInstruction bits;
        bits.table = static_cast<std::uint8_t>(below(256));
        for (Place& operand : bits.operands) operand = bit_place(slot);
        step.bits.push_back(bits);
      }
      for (int unit = 0; unit < units_; ++unit) step.words.push_back(word_instruction(unit));
      program_.steps.push_back(step);
    }
    return program_;
  }

 private:
  // What the generator knows of a unit: steps of its last instructions of a kind.
  struct Unit {
    bool tested = false;
    bool cleared = false;
    int test = -1000;
    int clear = -1000;  // GET that clears acc
    int high = -1000;   // LDH
    int wide = -1000;
    bool wide_divides = false;
    std::vector<int> muls{};
    std::vector<int> divs{};
  };

  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  bool one_in(int n) { return below(n) == 0; }
  std::uint16_t constant_word() {
    static constexpr std::uint16_t kCorners[] = {0, 1, 2, 0x7FFF, 0x8000, 0xFFFF, 15, 0x8001};
    return one_in(3) ? kCorners[below(8)] : static_cast<std::uint16_t>(below(1 << 16));
  }

  // A row is being written when it is this many steps since its step (its latch row) was there.
  bool open(int row, bool words) const {
    static_assert(constant::distance_memory == constant::distance_old + 2);
    const int closed = constant::distance_old + 1;
    if (row < length_) return now_ - row != closed;
    const int latch = row - program_.latch_row;
    return words || latch < 0 || latch >= program_.latch_rows ||
           now_ - (latch - latch_times_) != closed;
  }
  int memory_row(bool words) {
    const int rows = words && slots_ == 16 ? 512 : kSpecial;
    for (;;) {
      int row = 0;
      switch (below(4)) {
        case 0:
          row = below(rows);
          break;
        // The distances at which something changes.
        case 1:
          row = now_ - constant::distance_memory - below(3);
          break;
        case 2:
          row = now_ - below(constant::distance_memory);
          break;
        default:
          row = words ? below(length_) : program_.latch_row + below(8);
          break;
      }
      if (row >= 0 && row < rows && open(row, words)) return row;
    }
  }
  // There is a row of bits at that time.
  bool bits_at(int time) const {
    return time >= 0 || (time + latch_times_ >= 0 && time + latch_times_ < program_.latch_rows);
  }

  Place bit_place(int slot) {
    if (one_in(2)) return {memory_row(false), below(slots_)};
    const int steps = below(9);
    const Unit& unit = state_[static_cast<std::size_t>(slot / 2)];
    if (steps == 8 && unit.tested && now_ - unit.test >= constant::distance_flag) return flag();
    if (steps < 1 || steps > constant::near_bus_last || !bits_at(now_ - steps)) return zero();
    if (steps < constant::near_bus_first) return now_ >= steps ? own(steps) : zero();
    return bus(steps, below(slots_));
  }
  Place word_place() {
    if (one_in(2)) return {memory_row(true), below(units_)};
    const int steps = below(constant::near_bus_last + 1);
    if (steps == 0 || now_ < steps) return zero();
    if (steps < constant::near_bus_first) return own(steps);
    return bus(steps, below(units_));
  }
  int keep_row() {
    const int steps = 1 + below(constant::near_bus_last);
    return one_in(2) && now_ >= steps ? keep_near(steps) : memory_row(true);
  }

  WordInstruction word_instruction(int unit) {
    Unit& state = state_[static_cast<std::size_t>(unit)];
    WordInstruction word;
    word.op = opcode(unit, state);
    word.kind = static_cast<Kind>(below(3));
    word.always = one_in(2);
    word.constant = constant_word();
    word.s1 = word_place();
    word.s2 = word_place();
    word.keep = keep_row();
    if (word.op == Opcode::Get && word.always)
      std::tie(state.cleared, state.clear) = std::pair(true, now_);
    return word;
  }

  Opcode opcode(int unit, Unit& state) {
    // Results that are only there now are taken as often as not.
    if (one_in(2)) {
      const auto had_mul = [&](int steps) {
        return std::find(state.muls.begin(), state.muls.end(), now_ - steps) != state.muls.end();
      };
      if (had_mul(constant::distance_mul) && one_in(2)) return Opcode::Mull;
      if (had_mul(constant::distance_mul + 1)) return Opcode::Mulh;
      for (int start : state.divs) {
        if (now_ - start == constant::distance_div && one_in(2)) return Opcode::Quo;
        if (now_ - start == constant::distance_div + 1) return Opcode::Rem;
      }
      const int done =
          state.wide + (state.wide_divides ? constant::distance_div32 : constant::distance_mul32);
      if (now_ >= done && now_ < done + 4)
        return static_cast<Opcode>(static_cast<int>(Opcode::Mw0) + now_ - done);
    }
    if (unit == 0 && now_ == state.high + 1) {
      state.wide = now_;
      state.wide_divides = one_in(2);
      return state.wide_divides ? Opcode::Divd : Opcode::Muld;
    }
    if (unit == 0 && now_ >= state.high + constant::distance_wide_interval && one_in(4)) {
      state.high = now_;
      return Opcode::Ldh;
    }
    if (unit < dividers_ && one_in(4)) {
      state.divs.push_back(now_);
      return Opcode::Div;
    }
    if (one_in(5)) {
      state.muls.push_back(now_);
      return Opcode::Mul;
    }
    const auto op = static_cast<Opcode>(below(static_cast<int>(Opcode::Mul)));
    if (op >= Opcode::Eq && op <= Opcode::Tb)
      std::tie(state.tested, state.test) = std::pair(true, now_);
    if (op == Opcode::Mva &&
        (!state.cleared || now_ < state.clear + constant::distance_accumulator))
      return Opcode::Nop;
    return op;
  }

  std::mt19937& random_;
  int slots_;
  int units_;
  int dividers_;
  int length_;
  int latch_times_ = 0;
  int now_ = 0;
  std::vector<Unit> state_;
  RandomProgram program_;
};

}  // namespace

RandomProgram random_program(std::mt19937& random, int slots, int steps) {
  return Generator(random, slots, steps).generate();
}

}  // namespace rung::tb::wide
