// SPDX-License-Identifier: Apache-2.0
// An SPI NOR flash as the firmware meets it: programming clears bits, erasing sets a sector's, both
// take a while in which only the status answers, and the power can go at any moment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace rung::tb {

struct PowerCut {};

class Flash {
 public:
  explicit Flash(std::size_t bytes) : data_(bytes, 0xFF) {}

  // Pins
  void select(bool selected);
  std::uint8_t transfer(std::uint8_t byte);

  // Power: off and on again. What was under way is as it is.
  void power_up();
  // The power goes in write number `n` from now on (0: the next), before anything of it is done or,
  // with `partly`, in the middle of it, at a place that `seed` decides.
  void cut_at(int n, bool partly, unsigned seed);
  void never_cut() { cut_in_ = -1; }

  // Faults
  bool stuck_busy = false;      // a write never ends
  bool ignores_writes = false;  // or does nothing
  bool absent = false;          // reads 0xFF

  // Counted
  int writes = 0;      // programs and erases
  int violations = 0;  // commands while busy or asleep, programs without write enable, page wraps

  std::vector<std::uint8_t>& data() { return data_; }

 private:
  void carry_out();
  void program(std::size_t bytes);
  void erase(std::size_t bytes);

  std::vector<std::uint8_t> data_;
  bool selected_ = false;
  bool asleep_ = true;
  bool enabled_ = false;
  int busy_ = 0;  // status reads until the write is done
  std::vector<std::uint8_t> in_;
  std::size_t address_ = 0;
  int cut_in_ = -1;
  bool cut_partly_ = false;
  std::mt19937 random_{1};
};

}  // namespace rung::tb
