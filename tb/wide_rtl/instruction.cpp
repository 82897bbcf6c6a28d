// SPDX-License-Identifier: Apache-2.0
#include "wide_rtl/instruction.hpp"

#include <bit>

namespace rung::tb::wide {

namespace {

// Fields one above the other.
class Fields {
 public:
  void add(unsigned value, int bits) {
    for (int i = 0; i < bits; ++i, ++size_) {
      if (size_ % 16 == 0) chunks_.push_back(0);
      chunks_.back() =
          static_cast<std::uint16_t>(chunks_.back() | (((value >> i) & 1U) << (size_ % 16)));
    }
  }
  void add_place(const Place& place, int lane_bits) {
    add(static_cast<unsigned>(place.lane), lane_bits);
    add(static_cast<unsigned>(place.row), constant::layout_row_bits);
  }
  const std::vector<std::uint16_t>& chunks() const { return chunks_; }

 private:
  std::vector<std::uint16_t> chunks_;
  int size_ = 0;
};

}  // namespace

std::vector<std::uint16_t> chunks(const Step& step, int slot) {
  const int lane_bits = std::countr_zero(step.bits.size());
  const int unit_bits = lane_bits - 1;
  Fields fields;
  const BitInstruction& bits = step.bits[static_cast<std::size_t>(slot)];
  fields.add(bits.table, 8);
  for (int i = 2; i >= 0; --i)
    fields.add_place(bits.operands[static_cast<std::size_t>(i)], lane_bits);
  if (slot % 2 == 0) {
    const WordInstruction& word = step.words[static_cast<std::size_t>(slot / 2)];
    if (word.kind == Kind::Places) {
      fields.add(static_cast<unsigned>(word.s2.row << unit_bits | word.s2.lane),
                 constant::layout_word_bits);
    } else {
      fields.add(word.constant, constant::layout_word_bits);
    }
    fields.add_place(word.s1, unit_bits);
    fields.add(static_cast<unsigned>(word.keep), constant::layout_row_bits);
    fields.add(static_cast<unsigned>(word.kind), constant::layout_kind_bits);
    fields.add(word.always ? 1 : 0, 1);
    fields.add(static_cast<unsigned>(word.op), constant::layout_op_bits);
  }
  return fields.chunks();
}

}  // namespace rung::tb::wide
