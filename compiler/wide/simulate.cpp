// SPDX-License-Identifier: Apache-2.0
#include "wide/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace rung::wide {
namespace {

std::int16_t as_signed(std::uint16_t value) { return static_cast<std::int16_t>(value); }
std::uint16_t low_word(std::int64_t value) { return static_cast<std::uint16_t>(value & 0xffff); }

}  // namespace

Simulator::Simulator(const Machine& machine)
    : machine_(machine),
      bits_(static_cast<std::size_t>(machine.rows) * machine.slots, 0),
      words_(static_cast<std::size_t>(machine.word_rows) * machine.units, 0) {
  Step empty;
  empty.bits.resize(machine.slots);
  empty.words.resize(machine.units);
  steps_.assign(machine.steps, empty);
}

void Simulator::load(int step, int slot, const Chunks& chunks) {
  if (!decode(chunks, slot, machine_, steps_.at(step))) {
    throw std::invalid_argument(fmt::format("step {}, slot {}: no instruction", step, slot));
  }
}

void Simulator::set_program(int steps, int first_latch_row, int latch_rows) {
  length_ = steps;
  first_latch_row_ = first_latch_row;
  latch_rows_ = latch_rows;
}

std::int64_t Simulator::clocks() const {
  return length_ + constant::scan_fill + std::max(0, latch_rows_ - constant::scan_latch_free);
}

int Simulator::latch_step(int row) const {
  return row - std::max(latch_rows_, constant::scan_latch_free);
}

void Simulator::run_scan(std::span<const std::uint8_t> inputs) {
  bit_results_.assign(length_, std::vector<std::uint8_t>(machine_.slots, 0));
  kept_.assign(length_, std::vector<std::uint8_t>(machine_.units, 0));
  word_results_.assign(length_, std::vector<std::uint16_t>(machine_.units, 0));
  units_.assign(machine_.units, {});
  for (Unit& unit : units_) {
    for (auto* each : {&unit.flags, &unit.zero}) each->assign(length_, 0);
    for (auto* each : {&unit.gathered, &unit.quotients, &unit.remainders}) {
      each->assign(length_, 0);
    }
    unit.products.assign(length_, 0);
    unit.wide.assign(length_, {});
  }
  error_ = false;
  latched_.assign(latch_rows_, std::vector<std::uint8_t>(machine_.slots, 0));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    latched_.at(i / machine_.slots)[i % machine_.slots] = inputs[i] != 0;
  }
  const int first = latch_rows_ > 0 ? latch_step(0) : 0;
  for (int step = first; step < length_; ++step) {
    write_rows(step - constant::distance_memory);
    if (step < 0) continue;
    run_bits(step);
    for (int unit = 0; unit < machine_.units; ++unit) run_word(step, unit);
  }
  for (int step = length_; step < length_ + constant::distance_memory; ++step) {
    write_rows(step - constant::distance_memory);
  }
}

// The results of `step` reach the memories.
void Simulator::write_rows(int step) {
  const int row = step + std::max(latch_rows_, constant::scan_latch_free);
  if (step < 0 && row >= 0 && row < latch_rows_) {
    std::copy(latched_[row].begin(), latched_[row].end(),
              bits_.begin() + (first_latch_row_ + row) * machine_.slots);
  }
  if (step < 0) return;
  std::copy(bit_results_[step].begin(), bit_results_[step].end(),
            bits_.begin() + step * machine_.slots);
  std::copy(word_results_[step].begin(), word_results_[step].end(),
            words_.begin() + step * machine_.units);
}

bool Simulator::read_bit(const Operand& operand, int step, int slot) const {
  if (!is_near(operand)) {
    const int behind = operand.row - first_latch_row_;
    const bool latch = behind >= 0 && behind < latch_rows_;
    const int written = latch ? latch_step(behind) : operand.row;
    if (step - written == constant::distance_memory - 1 && (latch || operand.row < length_)) {
      throw std::logic_error(
          fmt::format("step {}, slot {} reads row {} as it is written", step, slot, operand.row));
    }
    return bits_.at(static_cast<std::size_t>(operand.row * machine_.slots + operand.lane)) != 0;
  }
  const int code = operand.row - kSpecialRow;
  if (code == constant::near_zero) return false;
  if (code == constant::near_flag) {
    const int from = step - constant::distance_flag;
    return from >= 0 && units_[slot / 2].flags[from] != 0;
  }
  const int from = step - code;
  const int lane = code >= constant::near_bus_first ? operand.lane : slot;
  if (from >= 0) return bit_results_[from][lane] != 0;
  const int row = from + std::max(latch_rows_, constant::scan_latch_free);
  return row >= 0 && row < latch_rows_ && latched_[row][lane] != 0;
}

std::uint16_t Simulator::read_word(const Operand& operand, int step, int unit) const {
  if (!is_near(operand)) {
    if (step - operand.row == constant::distance_memory - 1 && operand.row < length_) {
      throw std::logic_error(
          fmt::format("step {}, unit {} reads row {} as it is written", step, unit, operand.row));
    }
    return words_.at(static_cast<std::size_t>(operand.row * machine_.units + operand.lane));
  }
  const int code = operand.row - kSpecialRow;
  if (code == constant::near_zero || code == constant::near_flag) return 0;
  const int from = step - code;
  const int lane = code >= constant::near_bus_first ? operand.lane : unit;
  return from >= 0 ? word_results_[from][lane] : std::uint16_t{0};
}

void Simulator::run_bits(int step) {
  for (int slot = 0; slot < machine_.slots; ++slot) {
    const BitInstruction& code = steps_[step].bits[slot];
    unsigned address = 0;
    for (int i = 0; i < machine_.arity; ++i) {
      address = address << 1 | (read_bit(code.inputs[i], step, slot) ? 1U : 0U);
    }
    bit_results_[step][slot] = code.table >> address & 1U;
  }
}

void Simulator::run_word(int step, int unit) {
  const WordInstruction& code = steps_[step].words[unit];
  Unit& state = units_[unit];
  if (step > 0) {
    state.flags[step] = state.flags[step - 1];
    state.gathered[step] = state.gathered[step - 1];
  }
  const std::uint16_t place = read_word(code.s1, step, unit);
  const std::uint16_t s1 = code.kind == 2 ? code.constant : place;
  std::uint16_t s2 = code.constant;
  if (code.kind == 0) s2 = read_word(code.s2, step, unit);
  if (code.kind == 2) s2 = place;
  const int gate_step = step - constant::distance_gate;
  const bool gate = code.always || (gate_step >= 0 && bit_results_[gate_step][2 * unit] != 0);
  bool writes = gate;
  const std::uint16_t value = compute(code, step, unit, s1, s2, gate, writes);
  Operand keep = code.keep;
  keep.lane = unit;
  word_results_[step][unit] = writes ? value : read_word(keep, step, unit);
  kept_[step][unit] = writes ? 0 : 1;
}

std::uint16_t Simulator::compute(const WordInstruction& code, int step, int unit, std::uint16_t s1,
                                 std::uint16_t s2, bool gate, bool& writes) {
  Unit& state = units_[unit];
  const bool carry = state.carry;
  const auto test = [&](bool result) {
    state.flags[step] = result;
    writes = false;
    return std::uint16_t{0};
  };
  const auto sum = [&](int value) {
    state.carry = value < 0 || value > 0xffff;
    return low_word(value);
  };
  switch (code.opcode) {
    case Opcode::Mv:
      return s2;
    case Opcode::Add:
      return sum(s1 + s2);
    case Opcode::Adc:
      return sum(s1 + s2 + (carry ? 1 : 0));
    case Opcode::Sub:
      return sum(s1 - s2);
    case Opcode::Sbc:
      return sum(s1 - s2 - (carry ? 1 : 0));
    case Opcode::Wand:
      return s1 & s2;
    case Opcode::Wor:
      return s1 | s2;
    case Opcode::Wxor:
      return s1 ^ s2;
    case Opcode::Rol:
      return std::rotl(s1, s2 & 15);
    case Opcode::Minu:
      return std::min(s1, s2);
    case Opcode::Eq:
      return test(s1 == s2);
    case Opcode::Lt:
      return test(as_signed(s1) < as_signed(s2));
    case Opcode::Ltu:
      state.carry = s1 < s2;
      return test(s1 < s2);
    case Opcode::Ltc:
      return test(as_signed(s1) - (carry ? 1 : 0) < as_signed(s2));
    case Opcode::Tb:
      return test((s1 >> (s2 & 15) & 1) != 0);
    case Opcode::Get: {
      unsigned bits = code.always ? 0 : state.gathered[step];
      const BitInstruction& beside = steps_[step].bits[2 * unit];
      for (int i = 0; i < machine_.arity; ++i) {
        bits = bits << 1 | (read_bit(beside.inputs[i], step, 2 * unit) ? 1U : 0U);
      }
      state.gathered[step] = static_cast<std::uint16_t>(bits);
      writes = false;
      return 0;
    }
    case Opcode::Mva:
      return step >= constant::distance_accumulator
                 ? state.gathered[step - constant::distance_accumulator]
                 : std::uint16_t{0};
    case Opcode::Mul:
      state.products[step] = static_cast<std::uint32_t>(as_signed(s1) * as_signed(s2));
      writes = false;
      return 0;
    case Opcode::Div:
      state.zero[step] = s2 == 0;
      if (s2 != 0) {
        state.quotients[step] = low_word(as_signed(s1) / as_signed(s2));
        state.remainders[step] = low_word(as_signed(s1) % as_signed(s2));
      }
      writes = false;
      return 0;
    case Opcode::Ldh:
      state.high1 = s1;
      state.high2 = s2;
      writes = false;
      return 0;
    case Opcode::Muld:
    case Opcode::Divd:
      start_wide(code.opcode, step, state, s1, s2);
      writes = false;
      return 0;
    case Opcode::Nop:
      writes = false;
      return 0;
    default:
      return collect(code.opcode, step, state, gate, writes);
  }
}

void Simulator::start_wide(Opcode opcode, int step, Unit& unit, std::uint16_t s1,
                           std::uint16_t s2) {
  const auto whole = [](std::uint16_t high, std::uint16_t low) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(high) << 16 | low);
  };
  const std::int64_t a = whole(unit.high1, s1);
  const std::int64_t b = whole(unit.high2, s2);
  const bool divide = opcode == Opcode::Divd;
  const int from = step + (divide ? constant::distance_div32 : constant::distance_mul32);
  std::vector<std::uint16_t> words;
  if (!divide) {
    const std::int64_t product = a * b;
    for (int i = 0; i < 4; ++i) words.push_back(low_word(product >> (16 * i)));
  } else if (b != 0) {
    for (const std::int64_t value : {a / b, a % b}) {
      words.push_back(low_word(value));
      words.push_back(low_word(value >> 16));
    }
  }
  for (int i = 0; i < 4; ++i) {
    if (from + i < length_) unit.wide[from + i] = words;
  }
}

std::uint16_t Simulator::collect(Opcode opcode, int step, const Unit& unit, bool gate,
                                 bool& writes) {
  const auto by_zero = [&] {
    writes = false;
    error_ = error_ || gate;
    return std::uint16_t{0};
  };
  const bool low = opcode == Opcode::Mull || opcode == Opcode::Quo;
  if (opcode == Opcode::Mull || opcode == Opcode::Mulh) {
    const int from = step - machine_.mul - (low ? 0 : 1);
    const std::uint32_t product = from >= 0 ? unit.products[from] : 0;
    return low_word(low ? product : product >> 16);
  }
  if (opcode == Opcode::Quo || opcode == Opcode::Rem) {
    const int from = step - machine_.div - (low ? 0 : 1);
    if (from < 0) return 0;
    if (unit.zero[from] != 0) return by_zero();
    return low ? unit.quotients[from] : unit.remainders[from];
  }
  const std::vector<std::uint16_t>& words = unit.wide[step];
  if (words.empty()) return by_zero();
  return words[static_cast<std::size_t>(opcode) - static_cast<std::size_t>(Opcode::Mw0)];
}

}  // namespace rung::wide
