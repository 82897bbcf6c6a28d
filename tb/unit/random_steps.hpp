// SPDX-License-Identifier: Apache-2.0
// Random programs of all instructions of a processor on few devices, so that every hazard comes up
// again and again.
#pragma once

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "unit/bench.hpp"

namespace rung::tb {

class RandomSteps {
 public:
  RandomSteps(const Target& target, std::uint32_t seed);

  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  // Often one at the end of a range.
  std::uint16_t word();
  // Few devices, at both ends of the memory.
  std::uint16_t device(int devices);
  // A program that uses a unit's result or an index only when it is there, and in no step writes
  // a device twice.
  std::vector<Step> program(int steps);
  // Gives a bench random look-ups and devices for it.
  void fill(Bench& bench);

 private:
  // A word device that only an indexed write can reach. It begins as 0, so that IX can name a
  // device.
  static constexpr int kZeroWord = 100;
  static constexpr int kDevices = 6;

  // From which clock on a slot's unit and index may be used.
  struct Slot {
    int unit = 0;
    bool wide = false;  // the unit's operation has 32 bits
    bool high = false;  // there was an LDH
    int index = std::numeric_limits<int>::max();
  };

  isa::SlotInstruction instruction();
  void word_sources(isa::SlotInstruction& out);
  isa::BitOperand operand(int devices) { return {device(devices), below(4) == 0}; }
  static bool too_early(const isa::SlotInstruction& instruction, const Slot& slot, int clock);
  void track(const isa::SlotInstruction& instruction, int clock, Slot& slot) const;

  Target target_;
  std::mt19937 random_;
  std::vector<isa::Opcode> opcodes_;
};

}  // namespace rung::tb
