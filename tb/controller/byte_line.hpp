// SPDX-License-Identifier: Apache-2.0
// The client's side of the host line as bytes behind the UART (controller_core.v): for tests with
// very many frames. A byte takes kByteClocks instead of eleven bits.
#pragma once

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "controller/bit_line.hpp"

namespace rung::tb {

class ByteLine {
 public:
  // The least that hdl/controller/rtu_line.v allows is 12.
  static constexpr std::uint64_t kByteClocks = 16;

  struct Arrival {
    bool active = false;  // a byte is coming in
    bool valid = false;
    bool error = false;
    std::uint8_t byte = 0;
  };

  void send(std::uint8_t byte) { to_send_.push_back({byte, true}); }
  void send_bad(std::uint8_t byte) { to_send_.push_back({byte, false}); }
  std::size_t sending() const { return to_send_.size(); }
  std::vector<std::uint8_t> take() { return std::exchange(received_, {}); }
  void clear() { *this = ByteLine(); }

  std::uint64_t character_clocks() const { return kByteClocks; }
  double clocks_per_bit() const { return static_cast<double>(kByteClocks) / 11; }
  Parity parity() const { return Parity::None; }
  std::uint64_t bad_bytes() const { return 0; }

  // What the UART would say in this clock.
  Arrival arrive() {
    if (to_send_.empty()) return {};
    if (++arriving_ < kByteClocks) return {.active = true};
    const auto [byte, right] = to_send_.front();
    to_send_.pop_front();
    arriving_ = 0;
    return {.valid = right, .error = !right, .byte = byte};
  }
  // Whether it takes a byte to send, and whether one is on its way.
  bool ready() const { return leaving_ == 0; }
  bool busy() const { return leaving_ != 0; }
  void leave(bool valid, std::uint8_t byte) {
    if (leaving_ != 0) {
      --leaving_;
    } else if (valid) {
      received_.push_back(byte);
      leaving_ = kByteClocks;
    }
  }

 private:
  struct Byte {
    std::uint8_t byte;
    bool right;
  };
  std::deque<Byte> to_send_;
  std::uint64_t arriving_ = 0;
  std::uint64_t leaving_ = 0;
  std::vector<std::uint8_t> received_;
};

}  // namespace rung::tb
