// SPDX-License-Identifier: Apache-2.0
// A Verilated board top as somebody at its pins sees it.
#pragma once

#include <gtest/gtest.h>
#include <verilated.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "Vhx8k_mpu1.h"
#include "Vhx8k_mpu2.h"
#include "Vhx8k_mpu3.h"
#include "harness/model_coverage.hpp"
#include "isa/isa.hpp"

namespace rung::tb {

// The fields of serial_link.v's frames.
inline constexpr std::uint64_t kStart = 1ULL << 63;
inline constexpr std::uint64_t kAccess = 1ULL << 62;
inline constexpr std::uint64_t kWrite = 1ULL << 61;
inline constexpr std::uint64_t kDone = 1ULL << 63;
inline constexpr int kFrameBits = 64;

enum Space : std::uint8_t { kSteps = 0, kLut = 1, kBits = 2, kWords = 3, kLength = 4, kPorts = 5 };

// sck is an eighth of the clock.
template <typename Top>
class Board {
 public:
  Board() : context_(std::make_unique<VerilatedContext>()) {
    context_->randReset(2);
    context_->randSeed(5);
    top_ = std::make_unique<Top>(context_.get());
    top_->sck_i = 0;
    top_->csn_i = 1;
    top_->sdi_i = 0;
    top_->rx_i = 1;
    clocks(40);
  }
  ~Board() {
    top_->final();
    count_coverage(*context_);
  }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  bool done_lamp() const { return (top_->led_o & 1) != 0; }

  // What the UART receives from now on, a level a clock, and what its and the PWM's pins show.
  void send(std::vector<bool> levels) {
    rx_ = std::move(levels);
    next_ = 0;
    tx_.clear();
    pwm_.clear();
  }
  bool sending() const { return next_ < rx_.size(); }
  const std::vector<bool>& tx() const { return tx_; }
  const std::vector<bool>& pwm() const { return pwm_; }

  // Sends the `bits` low bits of `frame`, the highest first, and gives what came back.
  std::uint64_t exchange(std::uint64_t frame, int bits = kFrameBits) {
    std::uint64_t reply = 0;
    top_->csn_i = 0;
    clocks(8);
    for (int i = bits - 1; i >= 0; --i) {
      top_->sdi_i = i < kFrameBits ? (frame >> i & 1) : 0;
      clocks(4);
      reply = reply << 1 | top_->sdo_o;
      top_->sck_i = 1;
      clocks(4);
      top_->sck_i = 0;
    }
    clocks(4);
    top_->csn_i = 1;
    clocks(16);
    return reply;
  }

  void write(Space space, std::uint32_t address, std::uint16_t data) {
    exchange(access(space, address) | kWrite | std::uint64_t{data} << 16);
  }

  std::uint16_t read(Space space, std::uint32_t address) {
    exchange(access(space, address));
    return static_cast<std::uint16_t>(exchange(0) >> 32);
  }

 private:
  static std::uint64_t access(Space space, std::uint32_t address) {
    return kAccess | std::uint64_t{space} << 56 | std::uint64_t{address} << 32;
  }

  void clocks(int count) {
    for (int i = 0; i < count; ++i) {
      top_->clk_12mhz_i = 0;
      top_->eval();
      top_->rx_i = sending() ? rx_[next_++] : 1;
      top_->clk_12mhz_i = 1;
      top_->eval();
      tx_.push_back(top_->tx_o != 0);
      pwm_.push_back(top_->pwm_o != 0);
    }
  }

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Top> top_;
  std::vector<bool> rx_, tx_, pwm_;
  std::size_t next_ = 0;
};

// A processor and the board top that holds it.
template <isa::Mpu kProcessor, typename Model>
struct BoardCase {
  static constexpr isa::Mpu kMpu = kProcessor;
  using Top = Model;
};
using BoardCases =
    testing::Types<BoardCase<isa::Mpu::Mpu1, Vhx8k_mpu1>, BoardCase<isa::Mpu::Mpu2, Vhx8k_mpu2>,
                   BoardCase<isa::Mpu::Mpu3, Vhx8k_mpu3>>;

}  // namespace rung::tb
