// SPDX-License-Identifier: Apache-2.0
#include "prove/machine.hpp"

#include <algorithm>

#include "prove/decode.hpp"

namespace rung::prove {

using isa::Opcode;
using isa::SlotInstruction;

namespace {

Word bit_word(Bit bit) {
  Word out = Terms::constant(0);
  out[0] = bit;
  return out;
}

template <std::size_t N>
Bit pop(std::array<Bit, N>& stack) {
  const Bit top = stack[0];
  std::move(stack.begin() + 1, stack.end(), stack.begin());
  stack.back() = kFalse;
  return top;
}

template <std::size_t N>
void push(std::array<Bit, N>& stack, Bit bit) {
  std::move_backward(stack.begin(), stack.end() - 1, stack.end());
  stack[0] = bit;
}

}  // namespace

Machine::Machine(isa::Mpu mpu, const isa::Config& config, std::span<const std::uint8_t> lut,
                 std::vector<Window> windows, Terms& terms, Start& start)
    : mpu_(mpu),
      config_(config),
      lut_(lut),
      windows_(std::move(windows)),
      t_(terms),
      start_(start),
      slots_(static_cast<std::size_t>(isa::slots(mpu))) {
  for (Slot& slot : slots_) {
    slot.acc = Terms::constant(0);
    slot.blocks.fill(kFalse);
    slot.branches.fill(kFalse);
    slot.unit.fill(Terms::constant(0));
    // What a scan does not clear.
    slot.high1 = t_.word_variable();
    slot.high2 = t_.word_variable();
    slot.indices.push_back({-isa::constant::index_latency, t_.word_variable(), std::nullopt});
  }
}

std::vector<Write> Machine::step(std::span<const SlotInstruction> instructions) {
  writes_.clear();
  int clocks = 1;
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    slot_ = slot;
    execute(instructions[slot], slot);
    clocks = std::max(clocks, config_.clocks(instructions[slot].opcode));
  }
  clock_ += clocks;
  return std::move(writes_);
}

Word Machine::content(Place place) {
  const auto found = memory_.find(place);
  return found == memory_.end() ? start_.at(place) : found->second;
}

const Window* Machine::window_at(bool word, int address) const {
  const auto found = std::find_if(windows_.begin(), windows_.end(), [&](const Window& window) {
    return window.word == word && address >= window.first && address < window.first + window.size;
  });
  return found == windows_.end() ? nullptr : &*found;
}

void Machine::execute(const SlotInstruction& i, std::size_t slot) {
  const isa::Format format = isa::info(i.opcode).format;
  if (format == isa::Format::Word || format == isa::Format::Test) {
    execute_word(i, slots_[slot]);
  } else {
    execute_bit(i, slots_[slot]);
  }
}

// ---- the bit side ----

Bit Machine::operand(const isa::BitOperand& operand, const Slot& slot) {
  return operand.n0 ? slot.exc : bit(operand.device);
}

// The row's eight bits, chosen from by a, b and c.
Bit Machine::look_up(const SlotInstruction& i, const Slot& slot) {
  const std::uint8_t row = i.row < lut_.size() ? lut_[i.row] : 0;
  const Bit a = operand(i.a, slot);
  const Bit b = operand(i.b, slot);
  const Bit c = operand(i.c, slot);
  std::array<Bit, 4> by_c;
  for (std::size_t n = 0; n < by_c.size(); ++n) {
    by_c[n] = t_.choose(c, when((row >> (2 * n + 1) & 1) != 0), when((row >> 2 * n & 1) != 0));
  }
  return t_.choose(a, t_.choose(b, by_c[3], by_c[2]), t_.choose(b, by_c[1], by_c[0]));
}

void Machine::execute_bit(const SlotInstruction& i, Slot& slot) {
  const bool mpu1 = mpu_ == isa::Mpu::Mpu1;
  const int target = mpu1 ? i.a.device : i.c.device;
  const Bit run = i.always ? kTrue : slot.exc;
  const auto contact = [&] { return mpu1 ? bit(i.a.device) : operand(i.a, slot); };
  switch (i.opcode) {
    case Opcode::Lut:
      slot.exc = look_up(i, slot);
      return;
    case Opcode::Luto:
      slot.exc = look_up(i, slot);
      return write_bit(target, kTrue, slot.exc);
    case Opcode::Luts:
    case Opcode::Lutr:
      slot.exc = look_up(i, slot);
      return write_bit(target, slot.exc, when(i.opcode == Opcode::Luts));
    case Opcode::Ld:
    case Opcode::Ldi: {
      const Bit value = contact() ^ (i.opcode == Opcode::Ldi ? 1U : 0U);
      if (mpu1) push(slot.blocks, slot.exc);
      slot.exc = value;
      return;
    }
    case Opcode::Ldx:
      push(slot.blocks, slot.exc);
      slot.exc = read_indexed(false, slot)[0];
      return;
    case Opcode::And:
      slot.exc = t_.both(slot.exc, contact());
      return;
    case Opcode::Ani:
      slot.exc = t_.both(slot.exc, inverse(contact()));
      return;
    case Opcode::Or:
      slot.exc = t_.either(slot.exc, contact());
      return;
    case Opcode::Ori:
      slot.exc = t_.either(slot.exc, inverse(contact()));
      return;
    case Opcode::Anb:
      slot.exc = t_.both(pop(slot.blocks), slot.exc);
      return;
    case Opcode::Orb:
      slot.exc = t_.either(pop(slot.blocks), slot.exc);
      return;
    case Opcode::Pop:
      slot.exc = pop(slot.blocks);
      return;
    case Opcode::Inv:
      slot.exc = inverse(slot.exc);
      return;
    case Opcode::Mps:
      return push(slot.branches, slot.exc);
    case Opcode::Mrd:
      slot.exc = slot.branches[0];
      return;
    case Opcode::Mpp:
      slot.exc = pop(slot.branches);
      return;
    case Opcode::Out:
      return write_bit(target, kTrue, slot.exc);
    case Opcode::Set:
      return write_bit(target, run, kTrue);
    case Opcode::Rst:
      return write_bit(target, run, kFalse);
    case Opcode::Setx:
    case Opcode::Rstx:
      return write_indexed(false, run, bit_word(when(i.opcode == Opcode::Setx)), slot);
    case Opcode::Mvbx:
      return write_bit(target, kTrue, read_indexed(false, slot)[0]);
    case Opcode::Get: {
      if (i.always) slot.acc = Terms::constant(0);
      const isa::BitOperand entering[] = {i.a, i.b, i.c};
      for (std::size_t n = 0; n < (mpu1 ? 1U : 3U); ++n) {
        std::move_backward(slot.acc.begin(), slot.acc.end() - 1, slot.acc.end());
        slot.acc[0] = !mpu1 && entering[n].n0 ? kFalse : bit(entering[n].device);
      }
      return;
    }
    default:  // NOP
      return;
  }
}

// ---- the word side ----

void Machine::execute_word(const SlotInstruction& i, Slot& slot) {
  const Word constant = Terms::constant(i.source);
  const bool devices = i.kind == isa::WordKind::Devices;
  const auto rs = [&] { return content({true, i.rs}); };
  const int second = i.source & ((1 << address_bits(config_.word_devices)) - 1);
  const Word s1 = i.kind == isa::WordKind::ConstantDevice ? constant : rs();
  const Word s2 = devices                                   ? content({true, second})
                  : i.kind == isa::WordKind::ConstantDevice ? rs()
                                                            : constant;
  const Bit run = i.always ? kTrue : slot.exc;
  const int bit_target = mpu_ == isa::Mpu::Mpu1 ? i.a.device : i.c.device;
  const auto keep = [&](const Word& value) { write_word(i.rd, run, value); };
  const auto test = [&](Bit value) { write_bit(bit_target, run, value); };
  switch (i.opcode) {
    case Opcode::Mv:
      return keep(s2);
    // The carry changes whether the instruction is executed or not.
    case Opcode::Add:
      slot.carry = kFalse;
      [[fallthrough]];
    case Opcode::Adc:
      return keep(t_.add(s1, s2, slot.carry));
    case Opcode::Sub:
      slot.carry = kFalse;
      [[fallthrough]];
    case Opcode::Sbc:
      return keep(t_.subtract(s1, s2, slot.carry));
    case Opcode::Cmp:
      slot.carry = t_.less(s1, s2);
      return;
    case Opcode::Wand:
      return keep(t_.bitwise(&Terms::both, s1, s2));
    case Opcode::Wor:
      return keep(t_.bitwise(&Terms::either, s1, s2));
    case Opcode::Wxor:
      return keep(t_.bitwise(&Terms::differ, s1, s2));
    case Opcode::Rol:
      return keep(t_.rotate_left(s1, s2));
    case Opcode::Minu:
      return keep(t_.choose(t_.less(s1, s2), s1, s2));
    case Opcode::Eq:
      return test(t_.equal(s1, s2));
    case Opcode::Lt:
      return test(t_.less_signed(s1, s2));
    case Opcode::Ltu:
      slot.carry = t_.less(s1, s2);
      return test(slot.carry);
    case Opcode::Ltc:
      return test(t_.less_signed(s1, s2, slot.carry));
    case Opcode::Tb:
      return test(t_.pick(s1, s2));
    case Opcode::Mva:
      return keep(slot.acc);
    case Opcode::Ix: {
      Bit carry = kFalse;
      std::optional<int> base;
      if (i.kind == isa::WordKind::DeviceConstant) base = i.source;
      slot.indices.push_back({clock_, t_.add(s1, s2, carry), base});
      return;
    }
    case Opcode::Mvx:
      return keep(read_indexed(true, slot));
    case Opcode::Stx:
      return write_indexed(true, run, s2, slot);
    case Opcode::Ldh:
      slot.high1 = s1;
      slot.high2 = s2;
      return;
    case Opcode::Mul:
    case Opcode::Div:
    case Opcode::Muld:
    case Opcode::Divd:
      // The processor waits: the result is there when the step ends.
      start_unit(i, s1, s2, run, slot);
      return write_word(i.rd, slot.valid, slot.unit[0]);
    case Opcode::Muls:
    case Opcode::Divs:
    case Opcode::Mulds:
    case Opcode::Divds:
      return start_unit(i, s1, s2, run, slot);
    case Opcode::Mvl:
      return collect(i.rd, 0, slot);
    case Opcode::Mvh:
      return collect(i.rd, 1, slot);
    case Opcode::Mv2:
      return collect(i.rd, 2, slot);
    case Opcode::Mv3:
      return collect(i.rd, 3, slot);
    default:
      return;
  }
}

void Machine::start_unit(const SlotInstruction& i, const Word& s1, const Word& s2, Bit run,
                         Slot& slot) {
  const auto is = [&](std::initializer_list<Opcode> opcodes) {
    return std::find(opcodes.begin(), opcodes.end(), i.opcode) != opcodes.end();
  };
  const bool wide = is({Opcode::Muld, Opcode::Mulds, Opcode::Divd, Opcode::Divds});
  const bool divide = is({Opcode::Div, Opcode::Divs, Opcode::Divd, Opcode::Divds});
  const std::vector<Word> operands =
      wide ? std::vector<Word>{s1, slot.high1, s2, slot.high2} : std::vector<Word>{s1, s2};
  const Function function = divide ? (wide ? Function::Divide32 : Function::Divide16)
                                   : (wide ? Function::Multiply32 : Function::Multiply16);
  const std::vector<Word> results = t_.call(function, operands);
  // The words that it does not have are those of no result.
  for (Word& word : slot.unit) word = t_.word_variable();
  std::copy(results.begin(), results.end(), slot.unit.begin());
  slot.valid = run;
  if (divide) {
    const Bit by_0 = t_.is_zero(std::span(operands).subspan(wide ? 2 : 1));
    error_ = t_.either(error_, t_.both(run, by_0));
    slot.valid = t_.both(run, inverse(by_0));
  }
  const int latency = divide ? (wide ? config_.div32_latency : config_.div_latency)
                             : (wide ? config_.mul32_latency : config_.mul_latency);
  slot.ready = clock_ + latency;
}

void Machine::collect(std::uint16_t target, std::size_t word, const Slot& slot) {
  // Too early it is anybody's guess what is there, and whether it counts.
  if (clock_ < slot.ready) return write_word(target, t_.variable(), t_.word_variable());
  write_word(target, slot.valid, slot.unit[word]);
}

// ---- ix ----

Machine::Index Machine::index(const Slot& slot) {
  const auto old_enough = [&](const Index& index) {
    return index.clock + isa::constant::index_latency <= clock_;
  };
  return *std::find_if(slot.indices.rbegin(), slot.indices.rend(), old_enough);
}

Word Machine::read_indexed(bool word, const Slot& slot) {
  const Index ix = index(slot);
  Word outside = word ? t_.word_variable() : bit_word(t_.variable());
  const Window* window = ix.base ? window_at(word, *ix.base) : nullptr;
  if (window == nullptr) return outside;
  std::vector<Word> values;
  for (int n = 0; n < window->size; ++n) values.push_back(content({word, window->first + n}));
  const Selected found = select(t_, ix.value, window->first, values);
  return t_.choose(found.inside, found.value, outside);
}

// ---- writes ----

void Machine::write_bit(int address, Bit condition, Bit value) {
  writes_.push_back({slot_, condition, false, bit_word(value), address, false, {}});
}

void Machine::write_word(int address, Bit condition, const Word& value) {
  writes_.push_back({slot_, condition, true, value, address, false, {}});
}

void Machine::write_indexed(bool word, Bit condition, const Word& value, const Slot& slot) {
  const Index ix = index(slot);
  writes_.push_back({slot_, condition, word, value, ix.base.value_or(-1), true, ix.value});
}

}  // namespace rung::prove
