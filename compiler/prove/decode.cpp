// SPDX-License-Identifier: Apache-2.0
#include "prove/decode.hpp"

#include <algorithm>

namespace rung::prove {

using isa::Format;
using isa::SlotInstruction;

int address_bits(int size) {
  int bits = 1;
  while (1 << bits < size) ++bits;
  return bits;
}

std::optional<SlotInstruction> decode(std::uint64_t bits, isa::Mpu mpu, const isa::Config& config) {
  const bool mpu1 = mpu == isa::Mpu::Mpu1;
  const int bit = address_bits(config.bit_devices);
  const int word = address_bits(config.word_devices);
  const int bit_sources = 2 * (bit + 1);
  const int word_sources = isa::constant::word_bits + word;
  const int destination = std::max(bit_sources, word_sources);
  const int tail = destination + std::max(mpu1 ? bit : bit + 1, word);
  const int flags = 1 + isa::constant::kind_bits;
  const int opcode = tail + std::max(mpu1 ? 0 : isa::constant::row_bits, flags);
  const auto field = [&](int lowest, int width) {
    return static_cast<std::uint16_t>(bits >> lowest & ((std::uint64_t{1} << width) - 1));
  };
  const auto operand = [&](int lowest) {
    return isa::BitOperand{field(lowest, bit), field(lowest + bit, 1) != 0};
  };

  SlotInstruction out;
  const std::uint64_t code = bits >> opcode;
  const auto known = isa::opcodes();
  const auto entry = std::find_if(known.begin(), known.end(), [&](const isa::OpcodeInfo& info) {
    return static_cast<std::uint64_t>(info.opcode) == code && (mpu1 ? info.on_mpu1 : info.on_slot);
  });
  if (entry == known.end()) return std::nullopt;
  out.opcode = entry->opcode;
  const bool flag = field(tail, 1) != 0;
  switch (entry->format) {
    case Format::None:
      break;
    case Format::Bit:
      if (mpu1) {
        out.a.device = field(destination, bit);
        out.always = flag;
        break;
      }
      out.a = operand(0);
      out.b = operand(bit + 1);
      out.c = operand(destination);
      out.row = static_cast<std::uint8_t>(field(tail, isa::constant::row_bits));
      out.always = flag;  // of those that have it: SET, RST, SETX, RSTX and GET
      break;
    case Format::Word:
    case Format::Test:
      out.source = field(0, isa::constant::word_bits);
      out.rs = field(isa::constant::word_bits, word);
      if (entry->format == Format::Word) {
        out.rd = field(destination, word);
      } else {
        (mpu1 ? out.a : out.c).device = field(destination, bit);
      }
      out.always = flag;
      if (field(tail + 1, isa::constant::kind_bits) > 2) return std::nullopt;
      out.kind = static_cast<isa::WordKind>(field(tail + 1, isa::constant::kind_bits));
      break;
  }
  return out;
}

}  // namespace rung::prove
