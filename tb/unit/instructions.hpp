// SPDX-License-Identifier: Apache-2.0
// Short ways to write instructions in tests.
#pragma once

#include <cstdint>
#include <vector>

#include "isa/isa.hpp"
#include "unit/step_model.hpp"

namespace rung::tb {

// Operands that arithmetic goes wrong with first.
inline constexpr std::uint16_t kCorners[] = {0, 1, 0xffff, 0x7fff, 0x8000};

inline isa::BitOperand device(int number) { return {static_cast<std::uint16_t>(number), false}; }
// N0; `number` is then only the device that a look-up writes, if this is operand c.
inline isa::BitOperand n0(int number = 0) { return {static_cast<std::uint16_t>(number), true}; }

inline isa::SlotInstruction nop() { return {}; }

// A look-up: LUT, LUTO, LUTS or LUTR.
inline isa::SlotInstruction look_up(isa::Opcode opcode, int row, isa::BitOperand a,
                                    isa::BitOperand b, isa::BitOperand c) {
  isa::SlotInstruction out;
  out.opcode = opcode;
  out.row = static_cast<std::uint8_t>(row);
  out.a = a;
  out.b = b;
  out.c = c;
  return out;
}

// A contact or LD of device `number`, on any processor.
inline isa::SlotInstruction contact(isa::Opcode opcode, int number) {
  isa::SlotInstruction out;
  out.opcode = opcode;
  out.a = device(number);
  return out;
}

// OUT, SET or RST of device `number` on processor `mpu`.
inline isa::SlotInstruction coil(isa::Mpu mpu, isa::Opcode opcode, int number,
                                 bool always = false) {
  isa::SlotInstruction out;
  out.opcode = opcode;
  (mpu == isa::Mpu::Mpu1 ? out.a : out.c) = device(number);
  out.always = always;
  return out;
}

// An instruction without operands.
inline isa::SlotInstruction plain(isa::Opcode opcode) {
  isa::SlotInstruction out;
  out.opcode = opcode;
  return out;
}

// rd <- rs op device `source`
inline isa::SlotInstruction word(isa::Opcode opcode, int rs, int source, int rd,
                                 bool always = true) {
  isa::SlotInstruction out;
  out.opcode = opcode;
  out.kind = isa::WordKind::Devices;
  out.rs = static_cast<std::uint16_t>(rs);
  out.source = static_cast<std::uint16_t>(source);
  out.rd = static_cast<std::uint16_t>(rd);
  out.always = always;
  return out;
}

// rd <- rs op constant
inline isa::SlotInstruction with_constant(isa::Opcode opcode, int rs, std::uint16_t value,
                                          int rd = 0, bool always = true) {
  isa::SlotInstruction out = word(opcode, rs, value, rd, always);
  out.kind = isa::WordKind::DeviceConstant;
  return out;
}

// rd <- constant
inline isa::SlotInstruction move_constant(std::uint16_t value, int rd, bool always = true) {
  return with_constant(isa::Opcode::Mv, 0, value, rd, always);
}

// Bit device `number` <- what the test finds of rs and device `source`, on processor `mpu`.
inline isa::SlotInstruction test(isa::Mpu mpu, isa::Opcode opcode, int rs, int source, int number,
                                 bool always = true) {
  isa::SlotInstruction out = word(opcode, rs, source, 0, always);
  (mpu == isa::Mpu::Mpu1 ? out.a : out.c) = device(number);
  return out;
}

// MVL, MVH, MV2, MV3, MVA or MVX: an instruction that only has a destination.
inline isa::SlotInstruction into(isa::Opcode opcode, int rd, bool always = false) {
  isa::SlotInstruction out;
  out.opcode = opcode;
  out.rd = static_cast<std::uint16_t>(rd);
  out.always = always;
  return out;
}

// SETX or RSTX.
inline isa::SlotInstruction indexed_coil(isa::Opcode opcode, bool always = true) {
  isa::SlotInstruction out;
  out.opcode = opcode;
  out.always = always;
  return out;
}

}  // namespace rung::tb
