// SPDX-License-Identifier: Apache-2.0
// The processors on terms: what each step of the instruction memory reads, computes and writes, and
// when. Written from hdl/README.md and hdl/isa/README.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "isa/isa.hpp"
#include "prove/start.hpp"

namespace rung::prove {

// Devices side by side that an index may reach.
struct Window {
  bool word = false;
  int first = 0;
  int size = 0;
};

// One write of a step.
struct Write {
  std::size_t slot = 0;
  Bit condition = kTrue;
  bool word = false;
  Word value;
  int address = 0;  // of a store through ix: where its index would be 0, `at` instead
  bool indexed = false;
  Word at;
};

class Machine {
 public:
  Machine(isa::Mpu mpu, const isa::Config& config, std::span<const std::uint8_t> lut,
          std::vector<Window> windows, Terms& terms, Start& start);

  // Executes the step's instructions, slot 0 first, on what memory holds. The writes are the
  // caller's to carry out: put() what they leave behind.
  std::vector<Write> step(std::span<const isa::SlotInstruction> instructions);
  Word content(Place place);
  void put(Place place, const Word& content) { memory_[place] = content; }
  const Window* window_at(bool word, int address) const;

  Bit error() const { return error_; }

 private:
  struct Index {
    std::int64_t clock = 0;
    Word value;
    std::optional<int> base;  // of a sum with a constant: that one
  };
  struct Slot {
    Bit exc = kFalse;
    Bit carry = kFalse;
    Word acc;
    // MPU1's stacks are shift registers: what is pushed too far is lost, 0 comes from below.
    std::array<Bit, isa::constant::block_stack> blocks;
    std::array<Bit, isa::constant::branch_stack> branches;
    Word high1, high2;  // of LDH
    // The multiply-divide unit: its result can be collected from `ready` on.
    Bit valid = kFalse;
    std::array<Word, 4> unit;
    std::int64_t ready = 0;
    std::vector<Index> indices;  // what IX has computed, the latest last
  };

  void execute(const isa::SlotInstruction& i, std::size_t slot);
  void execute_bit(const isa::SlotInstruction& i, Slot& slot);
  void execute_word(const isa::SlotInstruction& i, Slot& slot);
  void start_unit(const isa::SlotInstruction& i, const Word& s1, const Word& s2, Bit run,
                  Slot& slot);
  void collect(std::uint16_t target, std::size_t word, const Slot& slot);

  Bit bit(int address) { return content({false, address})[0]; }
  Bit operand(const isa::BitOperand& operand, const Slot& slot);
  Bit look_up(const isa::SlotInstruction& i, const Slot& slot);
  Word read_indexed(bool word, const Slot& slot);
  Index index(const Slot& slot);
  void write_bit(int address, Bit condition, Bit value);
  void write_word(int address, Bit condition, const Word& value);
  void write_indexed(bool word, Bit condition, const Word& value, const Slot& slot);

  isa::Mpu mpu_;
  const isa::Config& config_;
  std::span<const std::uint8_t> lut_;
  std::vector<Window> windows_;
  Terms& t_;
  Start& start_;
  std::map<Place, Word> memory_;
  std::vector<Slot> slots_;
  std::int64_t clock_ = 0;
  std::vector<Write> writes_;  // of this step
  std::size_t slot_ = 0;
  Bit error_ = kFalse;
};

}  // namespace rung::prove
