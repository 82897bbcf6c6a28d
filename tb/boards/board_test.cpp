// SPDX-License-Identifier: Apache-2.0
// The board top through its pins: a program goes in over the serial link, runs, and its results
// come back; frames that are too short or too long do nothing; the program's UART and PWM work.
#include <gtest/gtest.h>
#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "Vhx8k_mpu1.h"
#include "Vhx8k_mpu2.h"
#include "Vhx8k_mpu3.h"
#include "isa/isa.hpp"
#include "peripherals/uart_lines.hpp"
#include "rungs/ports.hpp"
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

enum Space : std::uint8_t { kSteps = 0, kBits = 2, kWords = 3, kLength = 4, kPorts = 5 };

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
    top_->rx_i = 1;
    clocks(40);
  }
  ~Board() { top_->final(); }
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

  static int at(Device port) {
    const isa::Config& config = *isa::find_config("hx8k");
    return (port.kind == DeviceKind::PB ? config.bit_devices : config.word_devices) - 1 -
           static_cast<int>(port.number);
  }

  // Sends back what comes, and PWM at 10 kHz, 25 %.
  void load_echo() {
    const isa::SlotInstruction steps[] = {
        contact(Opcode::Ld, at(port::uart_rx_full)),
        word(Opcode::Mv, 0, at(port::uart_rx_data), at(port::uart_tx_data), false),
        coil(kMpu, Opcode::Rst, at(port::uart_rx_full)),
        coil(kMpu, Opcode::Rst, at(port::uart_tx_ready)),
        move_constant(25, at(port::pwm_duty)),
        move_constant(10000, at(port::pwm_hz_low)),
        move_constant(0, at(port::pwm_hz_high))};
    int step = 0;
    for (const isa::SlotInstruction& instruction : steps) load_step(step++, instruction);
    board_.write(kLength, 0, static_cast<std::uint16_t>(step));
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

TYPED_TEST(BoardTest, TheProgramsUartAndPwm) {
  constexpr double kClocksABit = 12e6 / 115200;
  this->load_echo();
  this->board_.write(kPorts, 0, 5 << 8 | 2);
  this->board_.write(kPorts, 1, static_cast<std::uint16_t>(baud_step(kClocksABit)));
  this->board_.write(kPorts, 2, static_cast<std::uint16_t>(baud_step(kClocksABit) >> 16));
  const std::vector<std::uint8_t> bytes = {0x00, 0xff, 0x55, 0x12, 0xed, 0x80, 0x01};
  LineWriter line(kClocksABit);
  line.idle(3);
  for (const std::uint8_t byte : bytes) line.byte(byte);
  line.idle(15);
  this->board_.send(line.levels());
  std::uint64_t reply = 0;
  while (this->board_.sending()) reply = this->board_.exchange(kStart);
  EXPECT_EQ(reply & kDone, kDone);
  EXPECT_EQ(reply & 0xffffffff, 7U + isa::constant::fill_clocks);
  const LineReader answer(this->board_.tx(), kClocksABit);
  EXPECT_EQ(answer.bytes, bytes);
  EXPECT_FALSE(answer.framing_error || answer.cut);
  // Periods of 1,200 clocks, after the first scan.
  const std::vector<bool>& pwm = this->board_.pwm();
  ASSERT_GT(pwm.size(), 2000U + 4 * 1200U);
  const auto begin = pwm.begin() + 2000;
  EXPECT_EQ(std::count(begin, begin + 4 * 1200, true), 4 * 300);
  EXPECT_TRUE(std::equal(begin, begin + 3 * 1200, begin + 1200));
}

TYPED_TEST(BoardTest, APortsPlaceIsAnOrdinaryDeviceWithoutPorts) {
  this->load_echo();
  this->board_.write(kBits, this->at(port::uart_rx_full), 1);
  this->board_.write(kWords, this->at(port::uart_rx_data), 0x4321);
  this->board_.send(std::vector<bool>(3000, true));
  while (this->board_.sending()) this->board_.exchange(kStart);
  EXPECT_EQ(this->board_.read(kWords, this->at(port::uart_tx_data)), 0x4321);
  EXPECT_EQ(this->board_.read(kBits, this->at(port::uart_rx_full)) & 1, 0);
  EXPECT_EQ(this->board_.read(kBits, this->at(port::uart_tx_ready)) & 1, 0);
  EXPECT_EQ(std::count(this->board_.tx().begin(), this->board_.tx().end(), false), 0);
  EXPECT_EQ(std::count(this->board_.pwm().begin(), this->board_.pwm().end(), true), 0);
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
