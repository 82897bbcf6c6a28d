// SPDX-License-Identifier: Apache-2.0
// What a program of the processors does, step by step and without a pipeline, written from
// hdl/isa/README.md alone: the model that the RTL's unit tests compare with.
#pragma once

#include <array>
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
    bool unit_valid = false;
    std::uint16_t unit_low = 0;
    std::uint16_t unit_high = 0;
  };

  Retired execute(const isa::SlotInstruction& instruction, Slot& slot);
  void execute_bit(const isa::SlotInstruction& instruction, Slot& slot, Retired& out) const;
  void execute_word(const isa::SlotInstruction& instruction, Slot& slot, Retired& out);
  void start_unit(bool divide, std::int16_t s1, std::int16_t s2, bool run, Slot& slot);

  isa::Mpu mpu_;
  const isa::Config& config_;
};

}  // namespace rung::tb
