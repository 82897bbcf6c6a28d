// SPDX-License-Identifier: Apache-2.0
// The instruction set in C++: opcodes, configurations, and one slot's instruction as fields and as
// bits. Everything here is derived from hdl/isa/*.toml (see hdl/isa/README.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rung::isa {

enum class Opcode : std::uint8_t {
#define RUNG_LAYOUT(name, value)
#define RUNG_OPCODE(id, name, code, mpu1, slot, format, clocks, gate) id = code,
#define RUNG_PROCESSOR(name, value)
#define RUNG_CONFIG(...)
#include "isa_table.inc"
};

enum class Format : std::uint8_t { None, Bit, Word, Test };
enum class Clocks : std::uint8_t { One, Mul, Div, Mul32, Div32 };
enum class Gate : std::uint8_t { None, Exc, Unit };

struct OpcodeInfo {
  Opcode opcode;
  std::string_view name;
  bool on_mpu1;
  bool on_slot;
  Format format;
  Clocks clocks;
  Gate gate;
};

// All opcodes, in the order of the table.
std::span<const OpcodeInfo> opcodes();
// What the table says of `opcode`, which must be one of it.
const OpcodeInfo& info(Opcode opcode);

// The processors. MPU2 is one slot, MPU3 two. MPU4 has instructions of its own (compiler/wide).
enum class Mpu : std::uint8_t { Mpu1 = 1, Mpu2 = 2, Mpu3 = 3, Mpu4 = 4 };
// Slots of `mpu`: instructions in one step.
int slots(Mpu mpu);

// One named configuration of hdl/isa/configs.toml.
struct Config {
  std::string_view name;
  int steps_mpu1, steps_mpu2, steps_mpu3;
  int bit_devices;
  int word_devices;
  int mul_latency;
  int div_latency;
  int mul32_latency;
  int div32_latency;
  int clock_hz;  // of the controller and its peripherals
  bool flow;     // its controller runs flow tasks

  int steps(Mpu mpu) const;
  // Clocks that one instruction of this opcode takes, executed or not.
  int clocks(Opcode opcode) const;
};

std::span<const Config> configs();
// The configuration called `name`, or null.
const Config* find_config(std::string_view name);

// Constants of [processor] and [layout].
namespace constant {
#define RUNG_LAYOUT(name, value) inline constexpr int name = value;
#define RUNG_OPCODE(...)
#define RUNG_PROCESSOR(name, value) inline constexpr int name = value;
#define RUNG_CONFIG(...)
#include "isa_table.inc"
}  // namespace constant

// A bit operand of a look-up: a device, or N0, the slot's previous look-up result. A device number
// stands beside N0 too, because operand c also names the device that the look-up writes.
struct BitOperand {
  std::uint16_t device = 0;
  bool n0 = false;
  bool operator==(const BitOperand&) const = default;
};

// Where the two sources of a word instruction come from.
enum class WordKind : std::uint8_t { Devices = 0, DeviceConstant = 1, ConstantDevice = 2 };

// One slot's instruction as fields. Fields that its format does not have are 0.
struct SlotInstruction {
  Opcode opcode = Opcode::Nop;
  // bit format; MPU1 uses only `a`, for what it reads and for what it writes. A test writes the bit
  // device `c` too (MPU1: `a`), beside its word sources.
  std::uint8_t row = 0;
  BitOperand a, b, c;
  // word format; a test has no rd
  std::uint16_t rd = 0;
  std::uint16_t rs = 0;
  std::uint16_t source = 0;  // a constant, or a word device (see WordKind)
  WordKind kind = WordKind::Devices;
  // instructions that exc gates: run even if it is 0; GET: clear acc first
  bool always = false;
  bool operator==(const SlotInstruction&) const = default;
};

// Bits of one slot's instruction on `mpu`.
int slot_bits(Mpu mpu, const Config& config);

// The instruction as bits, `slot_bits` wide. Every field must fit the configuration.
std::uint64_t encode(const SlotInstruction& instruction, Mpu mpu, const Config& config);
// The reverse; nothing when the opcode is not one of this processor's or a field has no meaning.
std::optional<SlotInstruction> decode(std::uint64_t bits, Mpu mpu, const Config& config);

// LUT row of a Table 2 opcode (paper, section 3.2): `first` 0 LD, 1 LDI; `second` and `third` 0
// NOP, 1 AND, 2 ANI, 3 OR, 4 ORI.
std::uint8_t paper_row(int first, int second, int third);
// The 8 bits that this row holds, bit {a,b,c} with `a` the highest; 0 for the codes Table 2 lacks.
std::uint8_t paper_row_function(std::uint8_t row);

}  // namespace rung::isa
