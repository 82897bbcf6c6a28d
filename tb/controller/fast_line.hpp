// SPDX-License-Identifier: Apache-2.0
// The client's side of the host line where bytes/host_uart.v stands in the place of the
// controller's UART: a bit a clock, a byte every 16.
#pragma once

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "controller/bit_line.hpp"

namespace rung::tb {

class FastLine {
 public:
  static constexpr std::uint64_t kByteClocks = 16;

  void send(std::uint8_t byte) { to_send_.push_back(frame(byte) | kRight); }
  void send_bad(std::uint8_t byte) { to_send_.push_back(frame(byte)); }
  std::size_t sending() const { return to_send_.size() + (place_ != 0 ? 1 : 0); }
  std::vector<std::uint8_t> take() { return std::exchange(received_, {}); }
  std::uint64_t bad_bytes() const { return bad_bytes_; }
  void clear() { *this = FastLine(); }

  // The level for the controller in this clock, the level of the controller in it: one call each a
  // clock.
  bool level() {
    if (place_ == 0) {
      if (to_send_.empty()) return true;
      shift_ = to_send_.front();
      to_send_.pop_front();
    }
    const bool level = (shift_ >> place_ & 1) != 0;
    place_ = (place_ + 1) % kByteClocks;
    return level;
  }
  void sample(bool level) {
    if (left_ == 0) {
      if (!level) left_ = kBits - 1;
      return;
    }
    bits_ = bits_ >> 1U | (level ? 1U << (kBits - 2) : 0U);
    if (--left_ != 0) return;
    if (level) {
      received_.push_back(static_cast<std::uint8_t>(bits_));
    } else {
      ++bad_bytes_;
    }
  }

 private:
  static constexpr unsigned kBits = 10;
  static constexpr std::uint32_t kRight = 1U << (kBits - 1);
  static std::uint32_t frame(std::uint8_t byte) {
    return 0xFFFF'FC00U | static_cast<std::uint32_t>(byte) << 1U;
  }

  std::deque<std::uint32_t> to_send_;
  std::uint32_t shift_ = 0;
  std::uint64_t place_ = 0;
  unsigned left_ = 0;
  std::uint32_t bits_ = 0;
  std::vector<std::uint8_t> received_;
  std::uint64_t bad_bytes_ = 0;
};

}  // namespace rung::tb
