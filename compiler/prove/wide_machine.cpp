// SPDX-License-Identifier: Apache-2.0
#include "prove/wide_machine.hpp"

#include <algorithm>

namespace rung::prove {

namespace constant = wide::constant;

namespace {

Word as_word(Bit bit) {
  Word out = Terms::constant(0);
  out[0] = bit;
  return out;
}

}  // namespace

WideMachine::WideMachine(const wide::Machine& machine, const image::WideImage& image,
                         std::map<Place, Word> memory, std::vector<Bit> latched, Terms& terms,
                         Sweep& sweep)
    : machine_(machine),
      image_(image),
      memory_(std::move(memory)),
      latched_(std::move(latched)),
      t_(terms),
      sweep_(sweep),
      units_(static_cast<std::size_t>(machine.units)) {
  for (Unit& unit : units_) {
    first_flags_.push_back(unit.flag = t_.variable());
    first_accs_.push_back(unit.acc = t_.word_variable());
    unit.carry = t_.variable();
  }
}

// ---- places ----

int WideMachine::step_of_latch(int row) const {
  return row - std::max(image_.latch_rows, constant::scan_latch_free);
}

bool WideMachine::is_latch(bool word, int row) const {
  return !word && row >= image_.first_latch_row && row < image_.first_latch_row + image_.latch_rows;
}

// Lanes of the last row may have no device.
Word WideMachine::latched(int row, int lane) {
  const auto position = static_cast<std::size_t>(row * machine_.slots + lane);
  return position < latched_.size() ? as_word(latched_[position]) : undefined(false);
}

Word WideMachine::undefined(bool word) {
  return word ? t_.word_variable() : as_word(t_.variable());
}

const Word& WideMachine::before(Place place) {
  const auto [found, fresh] = memory_.try_emplace(place);
  if (fresh) found->second = undefined(place.word);
  return found->second;
}

const Computed& WideMachine::computed(bool word, int step, int lane) const {
  return (word ? words_ : bits_)
      .at(static_cast<std::size_t>(step))
      .at(static_cast<std::size_t>(lane));
}

Word WideMachine::read(const wide::Operand& operand, bool word, int lane) {
  if (operand.row < wide::kSpecialRow) return read_row(operand, word);
  const int code = operand.row - wide::kSpecialRow;
  if (code == constant::near_zero) return Terms::constant(0);
  if (code == constant::near_flag) return word ? undefined(true) : as_word(flag(lane / 2));
  const bool bus = code >= constant::near_bus_first;
  const int from = step_ - code;
  if (from >= 0) return computed(word, from, bus ? operand.lane : lane).value;
  // Before the first step there is nothing but what is latched, and that on the bus alone.
  const int row = from - step_of_latch(0);
  if (word || !bus || row < 0 || row >= image_.latch_rows) return undefined(word);
  return latched(row, operand.lane);
}

Word WideMachine::read_row(const wide::Operand& operand, bool word) {
  if (operand.row >= (word ? machine_.word_rows : machine_.rows)) return undefined(word);
  const Place place{word, operand.row * lanes(word) + operand.lane};
  const bool latch = is_latch(word, operand.row);
  if (!latch && operand.row >= static_cast<int>(image_.code.size())) return before(place);
  const int behind = operand.row - image_.first_latch_row;
  const int distance = step_ - (latch ? step_of_latch(behind) : operand.row);
  if (distance >= constant::distance_memory) {
    return latch ? latched(behind, operand.lane) : computed(word, operand.row, operand.lane).value;
  }
  if (latch || distance > constant::distance_old) return undefined(word);
  return before(place);
}

Word WideMachine::content(Place place) {
  const int row = place.address / lanes(place.word);
  const int lane = place.address % lanes(place.word);
  if (is_latch(place.word, row)) return latched(row - image_.first_latch_row, lane);
  if (row < step_) return computed(place.word, row, lane).value;
  return before(place);
}

Bit WideMachine::flag(int unit) const {
  const int from = step_ - constant::distance_flag;
  const auto u = static_cast<std::size_t>(unit);
  return from < 0 ? first_flags_[u] : units_[u].flags[static_cast<std::size_t>(from)];
}

// ---- a step ----

Bit WideMachine::look_up(unsigned table, const std::vector<Bit>& operands, std::size_t from,
                         unsigned address) {
  if (from == operands.size()) return when((table >> address & 1U) != 0);
  return t_.choose(operands[from], look_up(table, operands, from + 1, address << 1 | 1U),
                   look_up(table, operands, from + 1, address << 1));
}

void WideMachine::step(const wide::Step& step) {
  std::vector<Computed> bits;
  std::vector<Computed> words;
  for (int slot = 0; slot < machine_.slots; ++slot) {
    const wide::BitInstruction& code = step.bits[static_cast<std::size_t>(slot)];
    std::vector<Bit> operands;
    for (int i = 0; i < machine_.arity; ++i) {
      operands.push_back(read(code.inputs.at(static_cast<std::size_t>(i)), false, slot)[0]);
    }
    const Bit value = look_up(code.table, operands, 0, 0);
    bits.push_back({as_word(sweep_.represent(value)), kTrue});
    if (slot % 2 != 0) continue;
    const int unit = slot / 2;
    const wide::WordInstruction& word = step.words[static_cast<std::size_t>(unit)];
    Job job{word.opcode, unit,       read(word.s1, true, unit), Terms::constant(word.constant),
            kTrue,       word.always};
    if (word.kind == 0) job.s2 = read(word.s2, true, unit);
    if (word.kind == 2) std::swap(job.s1, job.s2);
    if (!word.always) {
      const int from = step_ - constant::distance_gate;
      job.gate = from < 0 ? t_.variable() : computed(false, from, slot).value[0];
    }
    Computed result = compute(job, operands);
    const Word kept = read({word.keep.row, unit}, true, unit);
    result.value = sweep_.represent(t_.choose(result.written, result.value, kept));
    words.push_back(std::move(result));
    Unit& state = units_[static_cast<std::size_t>(unit)];
    state.flags.push_back(state.flag);
    state.accs.push_back(state.acc);
  }
  bits_.push_back(std::move(bits));
  words_.push_back(std::move(words));
  ++step_;
}

Computed WideMachine::compute(const Job& job, const std::vector<Bit>& beside) {
  const Computed nothing{Terms::constant(0), kFalse};
  Unit& unit = units_[static_cast<std::size_t>(job.unit)];
  switch (job.opcode) {
    case Opcode::Mv:
      return {job.s2, job.gate};
    case Opcode::Add:
      return sum(job, false, false);
    case Opcode::Adc:
      return sum(job, false, true);
    case Opcode::Sub:
      return sum(job, true, false);
    case Opcode::Sbc:
      return sum(job, true, true);
    case Opcode::Wand:
      return {t_.bitwise(&Terms::both, job.s1, job.s2), job.gate};
    case Opcode::Wor:
      return {t_.bitwise(&Terms::either, job.s1, job.s2), job.gate};
    case Opcode::Wxor:
      return {t_.bitwise(&Terms::differ, job.s1, job.s2), job.gate};
    case Opcode::Rol:
      return {t_.rotate_left(job.s1, job.s2), job.gate};
    case Opcode::Minu:
      return {t_.choose(t_.less(job.s1, job.s2), job.s1, job.s2), job.gate};
    case Opcode::Eq:
      return test(job, t_.equal(job.s1, job.s2));
    case Opcode::Lt:
      return test(job, t_.less_signed(job.s1, job.s2));
    case Opcode::Ltu:
      unit.carry = t_.less(job.s1, job.s2);
      return test(job, unit.carry);
    case Opcode::Ltc:
      return test(job, t_.less_signed(job.s1, job.s2, unit.carry));
    case Opcode::Tb:
      return test(job, t_.pick(job.s1, job.s2));
    case Opcode::Get: {
      Word& acc = unit.acc;
      if (job.always) acc = Terms::constant(0);
      for (const Bit bit : beside) {
        std::move_backward(acc.begin(), acc.end() - 1, acc.end());
        acc[0] = bit;
      }
      return nothing;
    }
    case Opcode::Mva: {
      const int from = step_ - constant::distance_accumulator;
      return {from < 0 ? first_accs_[static_cast<std::size_t>(job.unit)]
                       : unit.accs[static_cast<std::size_t>(from)],
              job.gate};
    }
    case Opcode::Mul: {
      const auto words = t_.call_like_others(Function::Multiply16, {job.s1, job.s2});
      unit.products[step_] = {words[0], words[1]};
      return nothing;
    }
    case Opcode::Mull:
    case Opcode::Mulh:
      return collect_product(job);
    case Opcode::Div:
      start_quotient(job);
      return nothing;
    case Opcode::Quo:
    case Opcode::Rem:
      return collect_quotient(job);
    case Opcode::Ldh:
      // It may disturb what the one before has started.
      if (unit.high_step >= 0 && step_ - unit.high_step < constant::distance_wide_interval) {
        if (!unit.wides.empty()) unit.wides.back().disturbed = true;
      }
      unit.high_step = step_;
      unit.high1 = job.s1;
      unit.high2 = job.s2;
      return nothing;
    case Opcode::Muld:
    case Opcode::Divd:
      start_wide(job);
      return nothing;
    case Opcode::Mw0:
    case Opcode::Mw1:
    case Opcode::Mw2:
    case Opcode::Mw3:
      return collect_wide(job);
    default:  // NOP
      return nothing;
  }
}

Computed WideMachine::sum(const Job& job, bool subtract, bool with_carry) {
  // The carry changes whatever the gate is.
  Bit& carry = units_[static_cast<std::size_t>(job.unit)].carry;
  if (!with_carry) carry = kFalse;
  return {subtract ? t_.subtract(job.s1, job.s2, carry) : t_.add(job.s1, job.s2, carry), job.gate};
}

Computed WideMachine::test(const Job& job, Bit value) {
  units_[static_cast<std::size_t>(job.unit)].flag = sweep_.represent(value);
  return {Terms::constant(0), kFalse};
}

// ---- the units behind a unit ----

Computed WideMachine::collect_product(const Job& job) {
  const bool low = job.opcode == Opcode::Mull;
  const auto& all = units_[static_cast<std::size_t>(job.unit)].products;
  const auto found = all.find(step_ - constant::distance_mul - (low ? 0 : 1));
  if (found == all.end()) return {t_.word_variable(), job.gate};
  return {low ? found->second.low : found->second.high, job.gate};
}

void WideMachine::start_quotient(const Job& job) {
  if (job.unit >= machine_.dividers) return;
  const auto words = t_.call_like_others(Function::Divide16, {job.s1, job.s2});
  const Word divisor[] = {job.s2};
  units_[static_cast<std::size_t>(job.unit)].quotients[step_] = {words[0], words[1],
                                                                 t_.is_zero(divisor)};
}

Computed WideMachine::collect_quotient(const Job& job) {
  const bool low = job.opcode == Opcode::Quo;
  const auto& all = units_[static_cast<std::size_t>(job.unit)].quotients;
  const auto found = all.find(step_ - constant::distance_div - (low ? 0 : 1));
  if (found == all.end()) return divided(job, t_.word_variable(), t_.variable());
  return divided(job, low ? found->second.quotient : found->second.remainder, found->second.by_0);
}

Computed WideMachine::divided(const Job& job, const Word& value, Bit by_0) {
  error_ = t_.either(error_, t_.both(job.gate, by_0));
  return {value, t_.both(job.gate, inverse(by_0))};
}

void WideMachine::start_wide(const Job& job) {
  if (job.unit != 0) return;
  Unit& unit = units_[0];
  Wide out;
  out.step = step_;
  out.divide = job.opcode == Opcode::Divd;
  // Without an LDH right before it nobody knows the high words, nor whether the unit is free. One
  // that came too early is the last one's disturbance and is disturbed itself.
  out.disturbed =
      unit.high_step != step_ - 1 ||
      (!unit.wides.empty() && step_ - unit.wides.back().step < constant::distance_wide_interval);
  if (out.disturbed && !unit.wides.empty()) unit.wides.back().disturbed = true;
  if (!out.disturbed) {
    const std::vector<Word> operands{job.s1, unit.high1, job.s2, unit.high2};
    const Function function = out.divide ? Function::Divide32 : Function::Multiply32;
    out.words = t_.call_like_others(function, operands);
    if (out.divide) out.by_0 = t_.is_zero(std::span(operands).subspan(2));
  }
  unit.wides.push_back(std::move(out));
}

Computed WideMachine::collect_wide(const Job& job) {
  const int word = static_cast<int>(job.opcode) - static_cast<int>(Opcode::Mw0);
  const auto& all = units_[static_cast<std::size_t>(job.unit)].wides;
  const auto ready = [&](const Wide& each) {
    const int latency = each.divide ? constant::distance_div32 : constant::distance_mul32;
    return !each.disturbed && each.step + latency + word == step_;
  };
  const auto found = std::find_if(all.begin(), all.end(), ready);
  if (found == all.end()) return divided(job, t_.word_variable(), t_.variable());
  return divided(job, found->words[static_cast<std::size_t>(word)], found->by_0);
}

}  // namespace rung::prove
