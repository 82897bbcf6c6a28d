// SPDX-License-Identifier: Apache-2.0
#include "isa/isa.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

namespace rung::isa {
namespace {

constexpr OpcodeInfo kOpcodes[] = {
#define RUNG_LAYOUT(name, value)
#define RUNG_OPCODE(id, name, code, mpu1, slot, format, clocks, gate) \
  {Opcode::id, name, mpu1 != 0, slot != 0, Format::format, Clocks::clocks, Gate::gate},
#define RUNG_PROCESSOR(name, value)
#define RUNG_CONFIG(...)
#include "isa_table.inc"
};

constexpr Config kConfigs[] = {
#define RUNG_LAYOUT(name, value)
#define RUNG_OPCODE(...)
#define RUNG_PROCESSOR(name, value)
#define RUNG_CONFIG(name, steps1, steps2, steps3, bits, words, mul, div, mul32, div32, hz, flow) \
  {#name, steps1, steps2, steps3, bits, words, mul, div, mul32, div32, hz, (flow) != 0},
#include "isa_table.inc"
};

int address_bits(int count) {
  return count <= 2 ? 1 : std::bit_width(static_cast<unsigned>(count - 1));
}

// Where the parts of one slot's instruction begin (hdl/isa/README.md, "Layout").
struct Layout {
  Layout(Mpu mpu, const Config& config)
      : bit(address_bits(config.bit_devices)), word(address_bits(config.word_devices)) {
    const bool slot = mpu != Mpu::Mpu1;
    destination = std::max(2 * (bit + 1), constant::word_bits + word);
    tail = destination + std::max(slot ? bit + 1 : bit, word);
    opcode = tail + std::max(slot ? constant::row_bits : 0, 1 + constant::kind_bits);
  }
  int bit, word;  // bits of a device number
  int destination, tail, opcode;
};

// Packs fields from bit 0 up, or takes them apart in the same order: the layout stands once.
class Packer {
 public:
  explicit Packer(std::uint64_t bits, bool unpack) : bits_(bits), unpack_(unpack) {}

  template <typename T>
  void field(T& value, int width) {
    const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
    if (unpack_) {
      value = static_cast<T>(bits_ >> at_ & mask);
    } else {
      assert((static_cast<std::uint64_t>(value) & ~mask) == 0 && "field does not fit");
      bits_ |= (static_cast<std::uint64_t>(value) & mask) << at_;
    }
    at_ += width;
  }
  void operand(BitOperand& operand, int width) {
    field(operand.device, width);
    field(operand.n0, 1);
  }
  // The next field begins at `bit`.
  void at(int bit) { at_ = bit; }
  std::uint64_t bits() const { return bits_; }

 private:
  std::uint64_t bits_;
  bool unpack_;
  int at_ = 0;
};

// Bit instructions whose flag stands where a look-up has its row.
bool has_flag(Opcode opcode) { return info(opcode).gate == Gate::Exc || opcode == Opcode::Get; }

void bit_body(Packer& packer, SlotInstruction& instruction, Mpu mpu, const Layout& layout) {
  if (mpu == Mpu::Mpu1) {
    packer.at(layout.destination);
    packer.field(instruction.a.device, layout.bit);
    packer.at(layout.tail);
    packer.field(instruction.always, 1);
    return;
  }
  packer.operand(instruction.a, layout.bit);
  packer.operand(instruction.b, layout.bit);
  packer.at(layout.destination);
  packer.operand(instruction.c, layout.bit);
  packer.at(layout.tail);
  if (has_flag(instruction.opcode)) {
    packer.field(instruction.always, 1);
  } else {
    packer.field(instruction.row, constant::row_bits);
  }
}

void word_body(Packer& packer, SlotInstruction& instruction, Mpu mpu, const Layout& layout) {
  packer.field(instruction.source, constant::word_bits);
  packer.field(instruction.rs, layout.word);
  packer.at(layout.destination);
  if (info(instruction.opcode).format == Format::Test) {
    packer.field((mpu == Mpu::Mpu1 ? instruction.a : instruction.c).device, layout.bit);
  } else {
    packer.field(instruction.rd, layout.word);
  }
  packer.at(layout.tail);
  packer.field(instruction.always, 1);
  packer.field(instruction.kind, constant::kind_bits);
}

void body(Packer& packer, SlotInstruction& instruction, Mpu mpu, const Layout& layout) {
  switch (info(instruction.opcode).format) {
    case Format::None:
      break;
    case Format::Bit:
      bit_body(packer, instruction, mpu, layout);
      break;
    case Format::Test:
    case Format::Word:
      word_body(packer, instruction, mpu, layout);
      break;
  }
}

}  // namespace

std::span<const OpcodeInfo> opcodes() { return kOpcodes; }

const OpcodeInfo& info(Opcode opcode) {
  static const auto by_code = [] {
    std::array<const OpcodeInfo*, 1 << constant::op_bits> table{};
    for (const OpcodeInfo& entry : kOpcodes) table[static_cast<std::size_t>(entry.opcode)] = &entry;
    return table;
  }();
  const OpcodeInfo* entry = by_code[static_cast<std::size_t>(opcode)];
  assert(entry != nullptr);
  return *entry;
}

int slots(Mpu mpu) { return mpu == Mpu::Mpu3 ? 2 : 1; }

int Config::steps(Mpu mpu) const {
  switch (mpu) {
    case Mpu::Mpu1:
      return steps_mpu1;
    case Mpu::Mpu2:
      return steps_mpu2;
    case Mpu::Mpu3:
      return steps_mpu3;
    case Mpu::Mpu4:
      break;  // its sizes are those of its slots (compiler/wide/machine.hpp)
  }
  return 0;
}

int Config::clocks(Opcode opcode) const {
  switch (info(opcode).clocks) {
    case Clocks::One:
      return 1;
    case Clocks::Mul:
      return mul_latency + 1;
    case Clocks::Div:
      return div_latency + 1;
    case Clocks::Mul32:
      return mul32_latency + 1;
    case Clocks::Div32:
      return div32_latency + 1;
  }
  return 0;
}

std::span<const Config> configs() { return kConfigs; }

const Config* find_config(std::string_view name) {
  for (const Config& config : kConfigs) {
    if (config.name == name) return &config;
  }
  return nullptr;
}

int slot_bits(Mpu mpu, const Config& config) {
  return Layout(mpu, config).opcode + constant::op_bits;
}

std::uint64_t encode(const SlotInstruction& instruction, Mpu mpu, const Config& config) {
  const Layout layout(mpu, config);
  SlotInstruction copy = instruction;
  Packer packer(0, false);
  body(packer, copy, mpu, layout);
  return packer.bits() | static_cast<std::uint64_t>(instruction.opcode) << layout.opcode;
}

std::optional<SlotInstruction> decode(std::uint64_t bits, Mpu mpu, const Config& config) {
  const Layout layout(mpu, config);
  const auto code = static_cast<std::size_t>(bits >> layout.opcode);
  for (const OpcodeInfo& entry : kOpcodes) {
    if (static_cast<std::size_t>(entry.opcode) != code) continue;
    if (!(mpu == Mpu::Mpu1 ? entry.on_mpu1 : entry.on_slot)) return std::nullopt;
    SlotInstruction instruction;
    instruction.opcode = entry.opcode;
    Packer packer(bits & ((std::uint64_t{1} << layout.opcode) - 1), true);
    body(packer, instruction, mpu, layout);
    // A bit outside the fields, or a kind that does not exist, is not an instruction.
    if (static_cast<int>(instruction.kind) > 2) return std::nullopt;
    if (encode(instruction, mpu, config) != bits) return std::nullopt;
    return instruction;
  }
  return std::nullopt;
}

std::uint8_t paper_row(int first, int second, int third) {
  return static_cast<std::uint8_t>(first << 6 | second << 3 | third);
}

std::uint8_t paper_row_function(std::uint8_t row) {
  const auto step = [](int code, bool exc, bool operand) {
    switch (code) {
      case 1:
        return exc && operand;
      case 2:
        return exc && !operand;
      case 3:
        return exc || operand;
      case 4:
        return exc || !operand;
      default:
        return exc;
    }
  };
  const int second = row >> 3 & 7;
  const int third = row & 7;
  if (second > 4 || third > 4) return 0;
  std::uint8_t function = 0;
  for (int address = 0; address < 8; ++address) {
    const bool a = (address & 4) != 0;
    bool exc = (row >> 6 & 1) != 0 ? !a : a;
    exc = step(second, exc, (address & 2) != 0);
    exc = step(third, exc, (address & 1) != 0);
    if (exc) function = static_cast<std::uint8_t>(function | 1 << address);
  }
  return function;
}

}  // namespace rung::isa
