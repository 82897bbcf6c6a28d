// SPDX-License-Identifier: Apache-2.0
// MPU4's RTL with 4, 8 or 16 slots behind one interface.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "wide_rtl/instruction.hpp"

namespace rung::tb::wide {

// The results of a step.
struct Row {
  int step = 0;
  std::vector<bool> bits;
  std::vector<std::uint16_t> words;
  bool operator==(const Row&) const = default;
};

struct Scan {
  int edges = 0;             // from the edge that samples start to the first that samples done
  std::uint32_t clocks = 0;  // what the processor counted
  bool error = false;        // of the last of several only
  std::vector<Row> rows;     // of the steps, as they retired
};

class WideRtl {
 public:
  virtual ~WideRtl() = default;
  virtual int slots() const = 0;
  int units() const { return slots() / 2; }
  virtual void reset() = 0;
  // One access of the load port.
  virtual void write(int space, std::uint32_t address, std::uint16_t data) = 0;
  // Reads of these addresses, one a clock.
  virtual std::vector<std::uint16_t> read(int space, std::span<const int> addresses) = 0;
  virtual void idle(int clocks) = 0;
  // One scan for each element of `inputs`, every one started with the edge that samples the done
  // before.
  virtual std::vector<Scan> scans(const std::vector<std::vector<bool>>& inputs) = 0;

  void load(std::span<const Step> steps, int latch_row, int latch_rows);
  void load_chunks(int step, int slot, std::span<const std::uint16_t> chunks);
  void set_program(int steps, int latch_row, int latch_rows);
  void write_bit(const Place& place, bool value);
  void write_word(const Place& place, std::uint16_t value);
  bool read_bit(const Place& place);
  std::uint16_t read_word(const Place& place);
  // Addresses are row * lanes + lane.
  std::vector<std::uint16_t> read_bits(std::span<const int> addresses);
  std::vector<std::uint16_t> read_words(std::span<const int> addresses);
  // Whole rows from row 0 on, lane by lane.
  std::vector<std::uint16_t> read_bit_rows(int rows);
  std::vector<std::uint16_t> read_word_rows(int rows);
};

// Every register starts with a value drawn from `seed`.
std::unique_ptr<WideRtl> make_wide_rtl(int slots, int seed);

}  // namespace rung::tb::wide
