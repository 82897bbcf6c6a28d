// SPDX-License-Identifier: Apache-2.0
// Instructions from the bits of the instruction memory: a decoder of its own, written from the
// layout in hdl/isa/README.md.
#pragma once

#include <cstdint>
#include <optional>

#include "isa/isa.hpp"

namespace rung::prove {

// Bits that hold an address of a memory of `size` devices.
int address_bits(int size);

// Nothing if the opcode is none of this processor's.
std::optional<isa::SlotInstruction> decode(std::uint64_t bits, isa::Mpu mpu,
                                           const isa::Config& config);

}  // namespace rung::prove
