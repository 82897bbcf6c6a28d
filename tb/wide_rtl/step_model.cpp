// SPDX-License-Identifier: Apache-2.0
#include "wide_rtl/step_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace rung::tb::wide {

namespace {

constexpr int kMoments = 10;  // as long as anything looks back, but for divisions

std::int32_t as_signed(std::uint16_t value) { return static_cast<std::int16_t>(value); }

// Quotient and remainder; the most negative number divided by -1 is itself.
struct Quotient {
  std::uint32_t quotient;
  std::uint32_t remainder;
};
Quotient divide(std::int64_t s1, std::int64_t s2) {
  return {static_cast<std::uint32_t>(s1 / s2), static_cast<std::uint32_t>(s1 % s2)};
}

}  // namespace

StepModel::StepModel(int slots)
    : slots_(slots),
      units_(slots / 2),
      bits_(kRows, std::vector<bool>(static_cast<std::size_t>(slots))),
      words_(kRows, std::vector<std::uint16_t>(static_cast<std::size_t>(slots / 2))),
      carry_(static_cast<std::size_t>(units_)),
      flags_(static_cast<std::size_t>(units_)),
      acc_(static_cast<std::size_t>(units_)),
      divisions_(static_cast<std::size_t>(units_)) {}

void StepModel::write_bit(const Place& place, bool value) {
  bits_.at(static_cast<std::size_t>(place.row)).at(static_cast<std::size_t>(place.lane)) = value;
}
void StepModel::write_word(const Place& place, std::uint16_t value) {
  words_.at(static_cast<std::size_t>(place.row)).at(static_cast<std::size_t>(place.lane)) = value;
}
bool StepModel::read_bit(const Place& place) {
  return bits_.at(static_cast<std::size_t>(place.row)).at(static_cast<std::size_t>(place.lane));
}
std::uint16_t StepModel::read_word(const Place& place) {
  return words_.at(static_cast<std::size_t>(place.row)).at(static_cast<std::size_t>(place.lane));
}

const StepModel::Moment& StepModel::ago(int steps) const {
  return moments_.at(static_cast<std::size_t>(steps - 1));
}

void StepModel::push(Moment moment) {
  moments_.push_front(std::move(moment));
  ++now_;
  if (moments_.size() < static_cast<std::size_t>(constant::distance_memory)) return;
  // A step now reads what was written distance_memory steps ago.
  const Moment& old = ago(constant::distance_memory);
  if (old.has_bits) bits_[static_cast<std::size_t>(old.row)] = old.bits;
  if (old.has_words) words_[static_cast<std::size_t>(old.row)] = old.words;
  if (moments_.size() > kMoments) moments_.pop_back();
}

void StepModel::flush() {
  for (int i = 0; i < kMoments; ++i) {
    Moment nothing;
    nothing.flags = flags_;
    nothing.acc = acc_;
    nothing.product.resize(static_cast<std::size_t>(units_));
    push(std::move(nothing));
  }
}

bool StepModel::collides(int row, bool words) const {
  for (int steps = constant::distance_old + 1; steps < constant::distance_memory; ++steps) {
    const Moment& moment = ago(steps);
    if ((words ? moment.has_words : moment.has_bits) && moment.row == row) return true;
  }
  return false;
}

bool StepModel::bit(const Place& place, int slot) const {
  if (!is_special(place.row)) {
    if (collides(place.row, false))
      throw std::logic_error(fmt::format("bit row {} is being written", place.row));
    return bits_[static_cast<std::size_t>(place.row)][static_cast<std::size_t>(place.lane)];
  }
  const int near = place.row - kSpecial;
  if (near == constant::near_zero) return false;
  if (near == constant::near_flag) {
    return ago(constant::distance_flag).flags.at(static_cast<std::size_t>(slot / 2));
  }
  const Moment& then = ago(near);
  // A latch row is nobody's own: it comes by the bus.
  if (near < constant::near_bus_first ? !then.has_words : !then.has_bits) {
    throw std::logic_error("a near bit of a time without a row");
  }
  return then.bits[static_cast<std::size_t>(near < constant::near_bus_first ? slot : place.lane)];
}

std::uint16_t StepModel::word(const Place& place, int unit) const {
  if (!is_special(place.row)) {
    if (collides(place.row, true))
      throw std::logic_error(fmt::format("word row {} is being written", place.row));
    return words_[static_cast<std::size_t>(place.row)][static_cast<std::size_t>(place.lane)];
  }
  const int near = place.row - kSpecial;
  if (near == constant::near_zero) return 0;
  const Moment& then = ago(near);
  if (!then.has_words) throw std::logic_error("a near word of a time without a row");
  return then.words[static_cast<std::size_t>(near < constant::near_bus_first ? unit : place.lane)];
}

std::uint16_t StepModel::keep(int row, int unit) const {
  if (!is_special(row)) return word({row, unit}, unit);
  const int steps = row - kSpecial;
  return word(steps < constant::near_bus_first ? own(steps) : bus(steps, unit), unit);
}

void StepModel::step_word(const WordInstruction& instruction, int unit, unsigned operands,
                          Moment& now) {
  const auto u = static_cast<std::size_t>(unit);
  const bool gate = instruction.always || (ago(constant::distance_gate).has_words &&
                                           ago(constant::distance_gate).bits.at(2 * u));
  std::uint16_t s1 = 0;
  std::uint16_t s2 = 0;
  switch (instruction.kind) {
    case Kind::Places:
      s1 = word(instruction.s1, unit);
      s2 = word(instruction.s2, unit);
      break;
    case Kind::ConstantS2:
      s1 = word(instruction.s1, unit);
      s2 = instruction.constant;
      break;
    case Kind::ConstantS1:
      s1 = instruction.constant;
      s2 = word(instruction.s1, unit);
      break;
  }
  const std::uint16_t kept = keep(instruction.keep, unit);
  const unsigned carry = carry_[u] ? 1 : 0;
  unsigned result = kept;
  bool collected_by_0 = false;
  const auto add = [&](unsigned a, unsigned b, unsigned in) {
    const unsigned sum = a + b + in;
    carry_[u] = sum > 0xFFFF;
    return sum;
  };
  const auto subtract = [&](unsigned a, unsigned b, unsigned in) {
    carry_[u] = a < b + in;
    return a - b - in;
  };
  switch (instruction.op) {
    case Opcode::Nop:
      break;
    case Opcode::Mv:
      result = s2;
      break;
    case Opcode::Add:
      result = add(s1, s2, 0);
      break;
    case Opcode::Adc:
      result = add(s1, s2, carry);
      break;
    case Opcode::Sub:
      result = subtract(s1, s2, 0);
      break;
    case Opcode::Sbc:
      result = subtract(s1, s2, carry);
      break;
    case Opcode::Wand:
      result = s1 & s2;
      break;
    case Opcode::Wor:
      result = s1 | s2;
      break;
    case Opcode::Wxor:
      result = s1 ^ s2;
      break;
    case Opcode::Rol:
      result = std::rotl(s1, s2 & 15);
      break;
    case Opcode::Minu:
      result = std::min(s1, s2);
      break;
    case Opcode::Eq:
      flags_[u] = s1 == s2;
      break;
    case Opcode::Lt:
      flags_[u] = as_signed(s1) < as_signed(s2);
      break;
    case Opcode::Ltu:
      flags_[u] = s1 < s2;
      carry_[u] = s1 < s2;
      break;
    case Opcode::Ltc:
      flags_[u] = as_signed(s1) - static_cast<int>(carry) < as_signed(s2);
      break;
    case Opcode::Tb:
      flags_[u] = ((s1 >> (s2 & 15)) & 1) != 0;
      break;
    case Opcode::Get:
      acc_[u] = static_cast<std::uint16_t>((instruction.always ? 0 : acc_[u] << 3) | operands);
      break;
    case Opcode::Mva:
      result = ago(constant::distance_accumulator).acc[u];
      break;
    case Opcode::Mul:
      now.product[u] = as_signed(s1) * as_signed(s2);
      break;
    case Opcode::Mull:
      result = static_cast<unsigned>(ago(constant::distance_mul).product[u]);
      break;
    case Opcode::Mulh:
      result = static_cast<unsigned>(ago(constant::distance_mul + 1).product[u]) >> 16;
      break;
    case Opcode::Div:
      divisions_[u].push_back({now_, s1, s2});
      break;
    case Opcode::Quo:
    case Opcode::Rem: {
      const bool quotient = instruction.op == Opcode::Quo;
      const int start = now_ - constant::distance_div - (quotient ? 0 : 1);
      const auto division = std::find_if(divisions_[u].begin(), divisions_[u].end(),
                                         [&](const Division& one) { return one.start == start; });
      if (division == divisions_[u].end()) throw std::logic_error("a result of no division");
      collected_by_0 = division->s2 == 0;
      if (collected_by_0) break;
      const Quotient both = divide(as_signed(static_cast<std::uint16_t>(division->s1)),
                                   as_signed(static_cast<std::uint16_t>(division->s2)));
      result = quotient ? both.quotient : both.remainder;
      break;
    }
    case Opcode::Ldh:
      high1_ = s1;
      high2_ = s2;
      break;
    case Opcode::Muld:
    case Opcode::Divd:
      wide_ = {now_, instruction.op == Opcode::Divd, static_cast<std::uint32_t>(high1_) << 16 | s1,
               static_cast<std::uint32_t>(high2_) << 16 | s2};
      break;
    case Opcode::Mw0:
    case Opcode::Mw1:
    case Opcode::Mw2:
    case Opcode::Mw3: {
      const auto which = static_cast<unsigned>(instruction.op) - static_cast<unsigned>(Opcode::Mw0);
      const auto first = static_cast<std::int32_t>(wide_.s1);
      const auto second = static_cast<std::int32_t>(wide_.s2);
      std::uint64_t value = 0;
      if (!wide_.divides) {
        value = static_cast<std::uint64_t>(static_cast<std::int64_t>(first) * second);
      } else if (second == 0) {
        collected_by_0 = true;
        break;
      } else {
        const Quotient both = divide(first, second);
        value = static_cast<std::uint64_t>(both.remainder) << 32 | both.quotient;
      }
      result = static_cast<std::uint16_t>(value >> (16 * which));
      break;
    }
  }
  if (collected_by_0 && gate) error_ = true;
  now.words[u] = gate && !collected_by_0 ? static_cast<std::uint16_t>(result) : kept;
}

std::vector<Row> StepModel::scan(const std::vector<Step>& steps, int latch_row, int latch_rows,
                                 const std::vector<bool>& inputs) {
  flush();
  error_ = false;
  for (auto& divisions : divisions_) divisions.clear();
  std::fill(carry_.begin(), carry_.end(), false);
  const auto moment = [&](int row) {
    Moment now;
    now.row = row;
    now.bits.resize(static_cast<std::size_t>(slots_));
    now.words.resize(static_cast<std::size_t>(units_));
    now.product.resize(static_cast<std::size_t>(units_));
    return now;
  };
  const int times = std::max(latch_rows, constant::scan_latch_free);
  for (int i = 0; i < times; ++i) {
    Moment now = moment(latch_row + i);
    now.has_bits = i < latch_rows;
    for (int lane = 0; lane < slots_ && now.has_bits; ++lane) {
      now.bits[static_cast<std::size_t>(lane)] =
          inputs[static_cast<std::size_t>(i * slots_ + lane)];
    }
    now.flags = flags_;
    now.acc = acc_;
    push(std::move(now));
  }
  std::vector<Row> rows;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    Moment now = moment(static_cast<int>(s));
    now.has_bits = now.has_words = true;
    std::vector<unsigned> operands(static_cast<std::size_t>(slots_));
    for (int slot = 0; slot < slots_; ++slot) {
      const BitInstruction& instruction = steps[s].bits[static_cast<std::size_t>(slot)];
      unsigned index = 0;
      for (const Place& place : instruction.operands)
        index = index << 1 | (bit(place, slot) ? 1U : 0U);
      operands[static_cast<std::size_t>(slot)] = index;
      now.bits[static_cast<std::size_t>(slot)] = ((instruction.table >> index) & 1) != 0;
    }
    for (int unit = 0; unit < units_; ++unit) {
      step_word(steps[s].words[static_cast<std::size_t>(unit)], unit,
                operands[static_cast<std::size_t>(2 * unit)], now);
    }
    now.flags = flags_;
    now.acc = acc_;
    rows.push_back({static_cast<int>(s), now.bits, now.words});
    push(std::move(now));
  }
  flush();
  return rows;
}

}  // namespace rung::tb::wide
