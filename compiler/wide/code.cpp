// SPDX-License-Identifier: Apache-2.0
#include "wide/code.hpp"

#include <fmt/format.h>

#include <bit>

namespace rung::wide {
namespace {

int lane_bits(int lanes) { return std::bit_width(static_cast<unsigned>(lanes) - 1); }

// Fields one after the other, from the lowest bit on.
class Writer {
 public:
  void add(unsigned value, int bits) {
    for (int i = 0; i < bits; ++i, ++at_) {
      if (at_ % 16 == 0) chunks.push_back(0);
      chunks.back() = static_cast<std::uint16_t>(chunks.back() | (value >> i & 1U) << at_ % 16);
    }
  }
  void add(const Operand& operand, int lanes) {
    add(static_cast<unsigned>(operand.lane), lane_bits(lanes));
    add(static_cast<unsigned>(operand.row), constant::layout_row_bits);
  }

  Chunks chunks;

 private:
  int at_ = 0;
};

class Reader {
 public:
  explicit Reader(const Chunks& chunks) : chunks_(chunks) {}

  unsigned take(int bits) {
    unsigned value = 0;
    for (int i = 0; i < bits; ++i, ++at_) {
      const auto chunk = static_cast<std::size_t>(at_ / 16);
      if (chunk < chunks_.size()) value |= (chunks_[chunk] >> at_ % 16 & 1U) << i;
    }
    return value;
  }
  Operand operand(int lanes) {
    Operand out;
    out.lane = static_cast<int>(take(lane_bits(lanes)));
    out.row = static_cast<int>(take(constant::layout_row_bits));
    return out;
  }

 private:
  const Chunks& chunks_;
  int at_ = 0;
};

bool has_unit(int slot) { return slot % 2 == 0; }

std::string text(const Operand& operand) {
  if (!is_near(operand)) return fmt::format("{}.{}", operand.row, operand.lane);
  const int code = operand.row - kSpecialRow;
  if (code == constant::near_zero) return "0";
  if (code == constant::near_flag) return "flag";
  if (code < constant::near_bus_first) return fmt::format("own-{}", code);
  return fmt::format("bus-{}.{}", code, operand.lane);
}

}  // namespace

int chunks_of(const Machine& machine, int slot) {
  const int operand = lane_bits(machine.slots) + constant::layout_row_bits;
  int bits = (1 << machine.arity) + machine.arity * operand;
  if (has_unit(slot)) {
    bits += constant::layout_word_bits + lane_bits(machine.units) + 2 * constant::layout_row_bits +
            constant::layout_kind_bits + 1 + constant::layout_op_bits;
  }
  return (bits + 15) / 16;
}

Chunks encode(const Step& step, int slot, const Machine& machine) {
  Writer out;
  const BitInstruction& bit = step.bits[slot];
  out.add(bit.table, 1 << machine.arity);
  for (int i = machine.arity; i-- > 0;) out.add(bit.inputs[i], machine.slots);
  if (has_unit(slot)) {
    const WordInstruction& word = step.words[slot / 2];
    const Operand& s2 = word.s2;
    const auto source = word.kind == 0
                            ? static_cast<unsigned>(s2.row << lane_bits(machine.units) | s2.lane)
                            : word.constant;
    out.add(source, constant::layout_word_bits);
    out.add(word.s1, machine.units);
    out.add(static_cast<unsigned>(word.keep.row), constant::layout_row_bits);
    out.add(static_cast<unsigned>(word.kind), constant::layout_kind_bits);
    out.add(word.always ? 1 : 0, 1);
    out.add(static_cast<unsigned>(word.opcode), constant::layout_op_bits);
  }
  return out.chunks;
}

bool decode(const Chunks& chunks, int slot, const Machine& machine, Step& step) {
  if (static_cast<int>(chunks.size()) != chunks_of(machine, slot)) return false;
  Reader in(chunks);
  BitInstruction& bit = step.bits[slot];
  bit = {};
  bit.table = static_cast<std::uint16_t>(in.take(1 << machine.arity));
  for (int i = machine.arity; i-- > 0;) bit.inputs[i] = in.operand(machine.slots);
  if (!has_unit(slot)) return true;
  WordInstruction& word = step.words[slot / 2];
  word = {};
  const unsigned source = in.take(constant::layout_word_bits);
  word.s1 = in.operand(machine.units);
  word.keep.row = static_cast<int>(in.take(constant::layout_row_bits));
  word.keep.lane = slot / 2;
  word.kind = static_cast<int>(in.take(constant::layout_kind_bits));
  word.always = in.take(1) != 0;
  const unsigned opcode = in.take(constant::layout_op_bits);
  if (!is_opcode(opcode) || word.kind > 2) return false;
  word.opcode = static_cast<Opcode>(opcode);
  if (word.kind == 0) {
    word.s2.lane = static_cast<int>(source & (static_cast<unsigned>(machine.units) - 1));
    word.s2.row = static_cast<int>(source >> lane_bits(machine.units));
  } else {
    word.constant = static_cast<std::uint16_t>(source);
  }
  return word.s2.row < 1 << constant::layout_row_bits;
}

std::string disassemble(const Step& step, int slot, const Machine& machine) {
  const BitInstruction& bit = step.bits[slot];
  std::string out = fmt::format("{:0{}b}", bit.table, 1 << machine.arity);
  for (int i = 0; i < machine.arity; ++i) out += " " + text(bit.inputs[i]);
  if (!has_unit(slot)) return out;
  const WordInstruction& word = step.words[slot / 2];
  if (word.opcode == Opcode::Nop && !word.always) return out;
  out += fmt::format(" | {}", name_of(word.opcode));
  const auto constant = static_cast<std::int16_t>(word.constant);
  if (word.kind == 2) {
    out += fmt::format(" K{} {}", constant, text(word.s1));
  } else {
    out += fmt::format(" {}", text(word.s1));
    out += word.kind == 1 ? fmt::format(" K{}", constant) : " " + text(word.s2);
  }
  return word.always ? out + " always" : out + " else " + text(word.keep);
}

}  // namespace rung::wide
