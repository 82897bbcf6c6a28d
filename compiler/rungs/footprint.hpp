// SPDX-License-Identifier: Apache-2.0
// Which devices an instruction names: its operands with their second words, digit groups, ranges.
#pragma once

#include <vector>

#include "rungs/program.hpp"

namespace rung {

// `count` operands that follow each other from `first` on, as BMOV and ZRST mean it: the next
// device, the next pair of words, the next digit group.
Operand element(const Operand& first, int i, int width);

// The bits of a digit group, the lowest first.
std::vector<Device> digit_bits(const Operand& operand);
// The words that a word operand of `width` bits (16, 32, 64) takes, the lowest first.
std::vector<Device> words_of(Device device, int width, Dialect dialect);

// All devices that `instruction` names, in no order; some may stand there twice. Not the flags that
// it writes, but the carry that RCL and RCR read. Of an indexed operand the head and the index
// register.
std::vector<Device> footprint(const Instruction& instruction, Dialect dialect);

// The devices that indexed operands of `kind` reach in this program (SEMANTICS.md, Words), or
// nothing when it has no indexed operand of this kind.
struct IndexWindow {
  DeviceKind kind = DeviceKind::D;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};
std::vector<IndexWindow> index_windows(const Program& program);

// What a trace's state shows, in order: the devices that the program names, and those of its
// windows.
std::vector<Device> visible_devices(const Program& program);

}  // namespace rung
