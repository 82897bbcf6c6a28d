// SPDX-License-Identifier: Apache-2.0
#include "prove/wide_decode.hpp"

#include <algorithm>

namespace rung::prove {
namespace {

// Bits of a number below `size`, a power of two.
int bits_below(int size) {
  int bits = 0;
  while (1 << bits < size) ++bits;
  return bits;
}

// The fields of one slot's instruction, by where their lowest bit is.
class Fields {
 public:
  Fields(const std::vector<std::uint16_t>& chunks, const wide::Machine& machine)
      : chunks_(chunks),
        machine_(machine),
        lane_bits_(bits_below(machine.slots)),
        unit_bits_(bits_below(machine.units)) {}

  std::size_t chunks_needed(bool with_unit) const {
    const int bits = with_unit ? at_op() + wide::constant::layout_op_bits : word_part();
    return static_cast<std::size_t>(bits + 15) / 16;
  }

  wide::BitInstruction bit() const {
    wide::BitInstruction out;
    out.table = static_cast<std::uint16_t>(field(0, 1 << machine_.arity));
    for (int i = 0; i < machine_.arity; ++i) {
      // The last operand is the lowest.
      const int number = machine_.arity - 1 - i;
      out.inputs.at(static_cast<std::size_t>(i)) =
          place((1 << machine_.arity) + number * (lane_bits_ + kRow), lane_bits_);
    }
    return out;
  }

  std::optional<wide::WordInstruction> word(int unit) const {
    const int op = field(at_op(), wide::constant::layout_op_bits);
    const int kind = field(at_kind(), wide::constant::layout_kind_bits);
    if (!wide::is_opcode(static_cast<unsigned>(op)) || kind > 2) return std::nullopt;
    wide::WordInstruction out;
    out.opcode = static_cast<wide::Opcode>(op);
    out.always = field(at_kind() + wide::constant::layout_kind_bits, 1) != 0;
    out.kind = kind;
    out.s1 = place(at_s1(), unit_bits_);
    out.keep = {field(at_keep(), kRow), unit};
    const int source = field(word_part(), wide::constant::layout_word_bits);
    if (kind != 0) {
      out.constant = static_cast<std::uint16_t>(source);
    } else {
      out.s2 = {source >> unit_bits_, source & (machine_.units - 1)};
      if (out.s2.row >> kRow != 0) return std::nullopt;
    }
    return out;
  }

 private:
  static constexpr int kRow = wide::constant::layout_row_bits;

  int word_part() const { return (1 << machine_.arity) + machine_.arity * (lane_bits_ + kRow); }
  int at_s1() const { return word_part() + wide::constant::layout_word_bits; }
  int at_keep() const { return at_s1() + unit_bits_ + kRow; }
  int at_kind() const { return at_keep() + kRow; }
  int at_op() const { return at_kind() + wide::constant::layout_kind_bits + 1; }

  int field(int at, int bits) const {
    int value = 0;
    for (int i = 0; i < bits; ++i) {
      const int chunk = chunks_.at(static_cast<std::size_t>(at + i) / 16);
      value |= (chunk >> (at + i) % 16 & 1) << i;
    }
    return value;
  }
  wide::Operand place(int at, int lane_bits) const {
    return {field(at + lane_bits, kRow), field(at, lane_bits)};
  }

  const std::vector<std::uint16_t>& chunks_;
  const wide::Machine& machine_;
  int lane_bits_, unit_bits_;
};

}  // namespace

std::optional<wide::Step> decode(const std::vector<std::vector<std::uint16_t>>& slots,
                                 const wide::Machine& machine) {
  if (slots.size() != static_cast<std::size_t>(machine.slots)) return std::nullopt;
  wide::Step out;
  for (std::size_t slot = 0; slot < slots.size(); ++slot) {
    const bool with_unit = slot % 2 == 0;
    const Fields fields(slots[slot], machine);
    if (slots[slot].size() != fields.chunks_needed(with_unit)) return std::nullopt;
    out.bits.push_back(fields.bit());
    if (!with_unit) continue;
    const auto word = fields.word(static_cast<int>(slot / 2));
    if (!word) return std::nullopt;
    out.words.push_back(*word);
  }
  return out;
}

}  // namespace rung::prove
