// SPDX-License-Identifier: Apache-2.0
// The other end of a serial line, 8 bits, in clocks of the module under test: a sender that makes
// the level of each clock, and a receiver that measures every edge.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rung::tb {

// What uart_tx.v and uart_rx.v take for this many clocks a bit.
inline std::uint32_t baud_step(double clocks_a_bit) {
  return static_cast<std::uint32_t>(std::lround(8 * 1048576 / clocks_a_bit));
}

enum class Parity { none = 0, odd = 1, even = 2 };

inline bool parity_bit(std::uint8_t value, Parity parity) {
  bool bit = parity == Parity::odd;
  for (int i = 0; i < 8; ++i) bit ^= (value >> i & 1) != 0;
  return bit;
}

// One level a clock. Bits may have any length in clocks: edges fall on the clock before them.
class LineWriter {
 public:
  explicit LineWriter(double clocks_a_bit) : clocks_a_bit_(clocks_a_bit) {}

  void idle(double bits) { level(true, bits); }
  void level(bool value, double bits) {
    end_ += bits * clocks_a_bit_;
    while (static_cast<double>(levels_.size()) < end_) levels_.push_back(value);
  }
  void byte(std::uint8_t value, bool stop = true, Parity parity = Parity::none) {
    level(false, 1);
    for (int i = 0; i < 8; ++i) level((value >> i & 1) != 0, 1);
    if (parity != Parity::none) level(parity_bit(value, parity), 1);
    level(stop, 1);
  }
  std::vector<bool>& levels() { return levels_; }

 private:
  double clocks_a_bit_;
  double end_ = 0;
  std::vector<bool> levels_;
};

// Decodes the levels of all clocks so far, sampling bits in their middle.
struct LineReader {
  std::vector<std::uint8_t> bytes;
  std::vector<std::size_t> starts;  // clock of each byte's start bit
  bool framing_error = false;
  bool parity_error = false;
  bool cut = false;  // the levels end within a byte

  LineReader(const std::vector<bool>& levels, double clocks_a_bit, Parity parity = Parity::none) {
    const int stop = parity == Parity::none ? 9 : 10;
    std::size_t at = 0;
    while (at < levels.size()) {
      if (levels[at]) {
        ++at;
        continue;
      }
      const auto sample = [&](int bit) {
        return at + static_cast<std::size_t>((bit + 0.5) * clocks_a_bit);
      };
      if (sample(stop) >= levels.size()) {
        cut = true;
        return;
      }
      int value = 0;
      for (int bit = 0; bit < 8; ++bit) value |= levels[sample(bit + 1)] ? 1 << bit : 0;
      framing_error = framing_error || levels[sample(0)] || !levels[sample(stop)];
      parity_error =
          parity_error ||
          (stop == 10 && levels[sample(9)] != parity_bit(static_cast<std::uint8_t>(value), parity));
      bytes.push_back(static_cast<std::uint8_t>(value));
      starts.push_back(at);
      at = sample(stop);
    }
  }
};

}  // namespace rung::tb
