// SPDX-License-Identifier: Apache-2.0
// What a program of the processors does, step by step and without a pipeline, written from
// hdl/isa/README.md alone: the model that the RTL's unit tests compare with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "harness/processor.hpp"
#include "isa/isa.hpp"

namespace rung::tb {

using Step = std::vector<isa::SlotInstruction>;  // slot 0 first
using LutRows = std::array<std::uint8_t, isa::constant::lut_rows>;

class StepModel {
 public:
  StepModel(isa::Mpu mpu, const isa::Config& config);

  std::vector<bool> bits;
  std::vector<std::uint16_t> words;
  LutRows lut{};
  bool error = false;

  // Runs one scan of `program`; gives what each slot of each step retires, in order, and sets
  // `clocks`.
  std::vector<Retired> scan(const std::vector<Step>& program, std::uint32_t& clocks);

 private:
  struct Slot {
    bool exc = false;
    std::uint16_t block = 0;  // MPU1's stacks, the top in bit 0
    std::uint16_t branch = 0;
    bool carry = false;
    std::uint16_t acc = 0;
    std::uint16_t ix = 0;
    bool unit_valid = false;
    std::array<std::uint16_t, 4> unit{};  // the words of its result
    std::uint16_t high1 = 0;              // of LDH
    std::uint16_t high2 = 0;
  };

  Retired execute(const isa::SlotInstruction& instruction, Slot& slot);
  void execute_bit(const isa::SlotInstruction& instruction, Slot& slot, Retired& out) const;
  void execute_word(const isa::SlotInstruction& instruction, Slot& slot, Retired& out);
  // What EQ to TB find; LTU sets the slot's carry.
  static bool test(isa::Opcode opcode, std::uint16_t s1, std::uint16_t s2, Slot& slot);
  void start_unit(isa::Opcode opcode, std::uint16_t s1, std::uint16_t s2, bool run, Slot& slot);
  std::size_t indexed_bit(const Slot& slot) const;
  std::size_t indexed_word(const Slot& slot) const;

  isa::Mpu mpu_;
  const isa::Config& config_;
};

}  // namespace rung::tb
