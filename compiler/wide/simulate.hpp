// SPDX-License-Identifier: Apache-2.0
// MPU4 step by step, from its encoded instructions: what the Verilog of hdl/wide does, with its
// distances. Nothing of the compiler's passes is used but the layout of an instruction.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include "wide/code.hpp"

namespace rung::wide {

class Simulator {
 public:
  explicit Simulator(const Machine& machine);

  // What the load port does.
  void load(int step, int slot, const Chunks& chunks);  // throws for what is no instruction
  void set_program(int steps, int first_latch_row, int latch_rows);
  bool bit(int address) const { return bits_.at(static_cast<std::size_t>(address)) != 0; }
  void set_bit(int address, bool value) { bits_.at(static_cast<std::size_t>(address)) = value; }
  std::uint16_t word(int address) const { return words_.at(static_cast<std::size_t>(address)); }
  void set_word(int address, std::uint16_t value) {
    words_.at(static_cast<std::size_t>(address)) = value;
  }

  // One scan. `inputs`: the bits that are latched, row by row. Throws std::logic_error where a row
  // is read in the clock in which it is written: what the block RAM gives then is not defined.
  void run_scan(std::span<const std::uint8_t> inputs);

  std::int64_t clocks() const;           // of a scan, from start to done
  bool error() const { return error_; }  // a division by 0 was executed in the last scan
  // What the last scan computed.
  bool computed_bit(int step, int slot) const { return bit_results_[step][slot] != 0; }
  std::uint16_t computed_word(int step, int unit) const { return word_results_[step][unit]; }
  // A word instruction kept what was there.
  bool kept(int step, int unit) const { return kept_[step][unit] != 0; }

 private:
  struct Unit {
    bool carry = false;
    std::vector<std::uint8_t> flags;      // by step: the flag after it
    std::vector<std::uint16_t> gathered;  // by step: acc after it
    std::vector<std::uint32_t> products;  // by step: what MUL started
    std::vector<std::uint16_t> quotients, remainders;
    std::vector<std::uint8_t> zero;  // by step: DIV by 0
    std::uint16_t high1 = 0, high2 = 0;
    std::vector<std::vector<std::uint16_t>> wide;  // by step: what MULD or DIVD started
  };

  bool read_bit(const Operand& operand, int step, int slot) const;
  std::uint16_t read_word(const Operand& operand, int step, int unit) const;
  int latch_step(int row) const;
  void write_rows(int step);
  void run_bits(int step);
  void run_word(int step, int unit);
  std::uint16_t compute(const WordInstruction& code, int step, int unit, std::uint16_t s1,
                        std::uint16_t s2, bool gate, bool& writes);
  std::uint16_t collect(Opcode opcode, int step, const Unit& unit, bool gate, bool& writes);
  void start_wide(Opcode opcode, int step, Unit& unit, std::uint16_t s1, std::uint16_t s2);

  const Machine& machine_;
  std::vector<Step> steps_;
  int length_ = 0, first_latch_row_ = 0, latch_rows_ = 0;
  std::vector<std::uint8_t> bits_;
  std::vector<std::uint16_t> words_;
  std::vector<std::vector<std::uint8_t>> bit_results_, kept_, latched_;
  std::vector<std::vector<std::uint16_t>> word_results_;
  std::vector<Unit> units_;
  bool error_ = false;
};

}  // namespace rung::wide
