// SPDX-License-Identifier: Apache-2.0
// What the steps of MPU4 do, by the contract (hdl/wide/README.md) alone: rows, distances, units.
// Time is in steps; latch rows have the times in front of step 0, and between scans enough of it
// passes.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "wide_rtl/wide_rtl.hpp"

namespace rung::tb::wide {

class StepModel {
 public:
  explicit StepModel(int slots);

  void write_bit(const Place& place, bool value);
  void write_word(const Place& place, std::uint16_t value);
  bool read_bit(const Place& place);
  std::uint16_t read_word(const Place& place);

  // The rows of all steps. Reads that the contract leaves open throw std::logic_error.
  std::vector<Row> scan(const std::vector<Step>& steps, int latch_row, int latch_rows,
                        const std::vector<bool>& inputs);
  bool error() const { return error_; }

 private:
  // What is known of one time.
  struct Moment {
    int row = 0;
    bool has_bits = false;
    bool has_words = false;
    std::vector<bool> bits;
    std::vector<std::uint16_t> words;
    std::vector<bool> flags;            // after the tests of that time
    std::vector<std::uint16_t> acc;     // after its GETs
    std::vector<std::int32_t> product;  // of MUL
  };
  struct Division {
    int start = -1000;
    std::uint32_t s1 = 0;
    std::uint32_t s2 = 0;
  };
  struct Wide {
    int start = -1000;
    bool divides = false;
    std::uint32_t s1 = 0;
    std::uint32_t s2 = 0;
  };

  const Moment& ago(int steps) const;
  // Moves the time on; what is old enough goes into the memories.
  void push(Moment moment);
  void flush();
  bool collides(int row, bool words) const;
  bool bit(const Place& place, int slot) const;
  std::uint16_t word(const Place& place, int unit) const;
  std::uint16_t keep(int row, int unit) const;
  void step_word(const WordInstruction& instruction, int unit, unsigned operands, Moment& now);

  int slots_;
  int units_;
  int now_ = 0;
  bool error_ = false;
  std::vector<std::vector<bool>> bits_;            // [row][lane], what the memories hold
  std::vector<std::vector<std::uint16_t>> words_;  // [row][unit]
  std::deque<Moment> moments_;                     // the newest first
  std::vector<bool> carry_;
  std::vector<bool> flags_;
  std::vector<std::uint16_t> acc_;
  std::vector<std::vector<Division>> divisions_;  // of each unit in this scan
  Wide wide_;
  std::uint16_t high1_ = 0;
  std::uint16_t high2_ = 0;
};

}  // namespace rung::tb::wide
