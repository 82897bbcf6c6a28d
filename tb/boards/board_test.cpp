// SPDX-License-Identifier: Apache-2.0
// The board top through its pins: a program goes in over the serial link, runs, and its results
// come back; frames that are too short or too long do nothing.
#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "Vhx8k_mpu1.h"
#include "Vhx8k_mpu2.h"
#include "Vhx8k_mpu3.h"
#include "isa/isa.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Mpu;
using isa::Opcode;

// The fields of serial_link.v's frames.
constexpr std::uint64_t kStart = 1ULL << 63;
constexpr std::uint64_t kAccess = 1ULL << 62;
constexpr std::uint64_t kWrite = 1ULL << 61;
constexpr std::uint64_t kDone = 1ULL << 63;
constexpr int kFrameBits = 64;

enum Space : std::uint8_t { kSteps = 0, kBits = 2, kWords = 3, kLength = 4 };

// A board top as somebody at its pins sees it; sck is an eighth of the clock.
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
    clocks(40);
  }
  ~Board() { top_->final(); }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  bool done_lamp() const { return (top_->led_o & 1) != 0; }

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
      top_->clk_12mhz_i = 1;
      top_->eval();
    }
  }

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Top> top_;
};

template <Mpu kProcessor, typename Model>
struct Case {
  static constexpr Mpu kMpu = kProcessor;
  using Top = Model;
};
using Cases = testing::Types<Case<Mpu::Mpu1, Vhx8k_mpu1>, Case<Mpu::Mpu2, Vhx8k_mpu2>,
                             Case<Mpu::Mpu3, Vhx8k_mpu3>>;

template <typename Which>
class BoardTest : public testing::Test {
 protected:
  static constexpr Mpu kMpu = Which::kMpu;

  // One step into the instruction memory: the instruction in slot 0, NOP in the others.
  void load_step(int step, const isa::SlotInstruction& instruction) {
    const isa::Config& config = *isa::find_config("hx8k");
    const int width = isa::slot_bits(kMpu, config) * isa::slots(kMpu);
    const std::uint64_t bits = isa::encode(instruction, kMpu, config);
    for (int chunk = 0; chunk * 16 < width; ++chunk) {
      const std::uint64_t data = chunk < 4 ? bits >> (16 * chunk) : 0;
      board_.write(kSteps, static_cast<std::uint32_t>(step * 8 + chunk),
                   static_cast<std::uint16_t>(data));
    }
  }

  // Y <- X, and D1 <- 0x1234 where X is 1.
  void load_program() {
    load_step(0, contact(Opcode::Ld, kX));
    load_step(1, coil(kMpu, Opcode::Out, kY));
    load_step(2, move_constant(kConstant, 1, false));
    board_.write(kLength, 0, kLength3);
  }

  static constexpr int kX = 5, kY = 700;
  static constexpr std::uint16_t kConstant = 0x1234, kLength3 = 3;
  Board<typename Which::Top> board_;
};
TYPED_TEST_SUITE(BoardTest, Cases);

TYPED_TEST(BoardTest, DevicesReadBack) {
  for (const std::uint16_t value : {0xa55a, 0x0001, 0x8000}) {
    this->board_.write(kWords, 255, value);
    this->board_.write(kBits, 1023, value & 1);
    EXPECT_EQ(this->board_.read(kWords, 255), value);
    EXPECT_EQ(this->board_.read(kBits, 1023) & 1, value & 1);
  }
}

TYPED_TEST(BoardTest, ProgramRunsAndItsClocksComeBack) {
  this->load_program();
  EXPECT_FALSE(this->board_.done_lamp());
  for (const bool x : {true, false, true}) {
    this->board_.write(kBits, this->kX, x);
    this->board_.write(kWords, 1, 0);
    this->board_.exchange(kStart);
    const std::uint64_t reply = this->board_.exchange(0);
    EXPECT_EQ(reply & kDone, kDone);
    EXPECT_EQ(reply & 0xffffffff, 3U + isa::constant::fill_clocks);
    EXPECT_TRUE(this->board_.done_lamp());
    EXPECT_EQ(this->board_.read(kBits, this->kY) & 1, x);
    EXPECT_EQ(this->board_.read(kWords, 1), x ? this->kConstant : 0);
  }
}

TYPED_TEST(BoardTest, FramesOfAnotherLengthDoNothing) {
  this->board_.write(kWords, 7, 0x1111);
  const std::uint64_t write =
      kAccess | kWrite | std::uint64_t{kWords} << 56 | 7ULL << 32 | 0x2222ULL << 16;
  for (const int bits : {1, 63, 65, 127, 128, 129, 192}) {
    this->board_.exchange(write, bits);
    EXPECT_EQ(this->board_.read(kWords, 7), 0x1111) << bits << " bits";
  }
  this->board_.exchange(write);
  EXPECT_EQ(this->board_.read(kWords, 7), 0x2222);
}

}  // namespace
}  // namespace rung::tb
