// SPDX-License-Identifier: Apache-2.0
// The client's side of the host line, level by level, at a number of clocks a bit that need not be
// whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace rung::tb {

enum class Parity : std::uint8_t { None, Odd, Even };

// A character is 11 bits: start, 8, parity or a second stop bit, stop. (One stop bit is enough in
// what is received.) Times are clocks in units of 2^-20, as the UART's own.
class BitLine {
 public:
  // As baud_step_i of hdl/peripherals/uart_tx.v; from the next character on.
  void set_rate(std::uint32_t baud_step, Parity parity) {
    if (baud_step == 0) return;
    bit_ = kBit / baud_step;
    parity_ = parity;
  }
  std::uint64_t character_clocks() const { return (kCharacter * bit_) >> kFraction; }
  double clocks_per_bit() const { return static_cast<double>(bit_) / (1 << kFraction); }

  Parity parity() const { return parity_; }

  void send(std::uint8_t byte) { to_send_.push_back({byte, true}); }
  // With its last bit, parity or stop, as it must not be.
  void send_bad(std::uint8_t byte) { to_send_.push_back({byte, false}); }
  std::size_t sending() const { return to_send_.size() + (shifting_ ? 1 : 0); }
  std::vector<std::uint8_t> take() { return std::exchange(received_, {}); }
  std::uint64_t bad_bytes() const { return bad_bytes_; }
  // Idle, both ways, at the rate that it has.
  void clear() {
    BitLine idle;
    idle.bit_ = bit_;
    idle.parity_ = parity_;
    *this = std::move(idle);
  }

  // The level for the controller's receiver in this clock.
  bool level(std::uint64_t now) {
    if (now < next_edge_) return level_;
    return advance(now);
  }
  // The level of its transmitter in this clock.
  void sample(std::uint64_t now, bool level) {
    if (now < next_sample_) return;
    decode(now, level);
  }

 private:
  static constexpr unsigned kFraction = 20;
  static constexpr std::uint64_t kBit = 8ULL << (2 * kFraction);
  static constexpr std::uint64_t kCharacter = 11;
  static constexpr std::uint64_t kNever = ~0ULL;

  bool parity_bit(std::uint8_t byte) const {
    return (__builtin_popcount(byte) % 2 != 0) != (parity_ == Parity::Odd);
  }
  std::uint64_t clock_of(std::uint64_t start, std::uint64_t halves) const {
    return start + ((halves * bit_ / 2) >> kFraction);
  }

  bool advance(std::uint64_t now) {
    if (!shifting_) {
      if (to_send_.empty()) return level_ = true;
      const auto [byte, right] = to_send_.front();
      to_send_.pop_front();
      const bool ninth = (parity_ == Parity::None || parity_bit(byte)) == right;
      bits_ = static_cast<std::uint16_t>(byte << 1 | (ninth ? 0x200 : 0) | 0x400);
      start_ = now;
      bit_index_ = 0;
      shifting_ = true;
    } else if (++bit_index_ == kCharacter) {
      shifting_ = false;
      next_edge_ = 0;
      return level_ = true;  // the next character begins a clock later
    }
    level_ = (bits_ >> bit_index_ & 1) != 0;
    next_edge_ = clock_of(start_, 2 * (bit_index_ + std::uint64_t{1}));
    return level_;
  }

  void decode(std::uint64_t now, bool level) {
    if (!receiving_) {
      if (level) stuck_ = false;
      if (level || stuck_) return;
      receiving_ = true;
      heard_start_ = now;
      heard_index_ = 0;
      heard_ = 0;
    } else {
      heard_ = static_cast<std::uint16_t>(heard_ | (level ? 1 << heard_index_ : 0));
      const unsigned last = parity_ == Parity::None ? 9 : 10;
      if (heard_index_++ == last) {
        finish();
        return;
      }
    }
    next_sample_ = clock_of(heard_start_, 2 * heard_index_ + std::uint64_t{1});
  }

  void finish() {
    receiving_ = false;
    next_sample_ = 0;
    const auto byte = static_cast<std::uint8_t>(heard_ >> 1);
    const unsigned stop = parity_ == Parity::None ? 9 : 10;
    const bool right = (heard_ & 1) == 0 && (heard_ >> stop & 1) != 0 &&
                       (parity_ == Parity::None || (heard_ >> 9 & 1) == (parity_bit(byte) ? 1 : 0));
    if (right) {
      received_.push_back(byte);
    } else {
      ++bad_bytes_;
      stuck_ = true;  // until the line is 1 again
    }
  }

  std::uint64_t bit_ = 13ULL << kFraction;
  Parity parity_ = Parity::Even;
  struct Byte {
    std::uint8_t byte;
    bool right;
  };
  std::deque<Byte> to_send_;
  bool shifting_ = false, level_ = true;
  std::uint16_t bits_ = 0;
  unsigned bit_index_ = 0;
  std::uint64_t start_ = 0, next_edge_ = 0;
  bool receiving_ = false, stuck_ = false;
  std::uint16_t heard_ = 0;
  unsigned heard_index_ = 0;
  std::uint64_t heard_start_ = 0, next_sample_ = 0;
  std::vector<std::uint8_t> received_;
  std::uint64_t bad_bytes_ = 0;
};

}  // namespace rung::tb
