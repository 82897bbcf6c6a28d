// SPDX-License-Identifier: Apache-2.0
// The board top through its pins: a program goes in over the serial link, runs, and its results
// come back; frames that are too short or too long do nothing; the program's UART and PWM work.
#include "boards/board.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "isa/isa.hpp"
#include "peripherals/uart_lines.hpp"
#include "rungs/ports.hpp"
#include "unit/instructions.hpp"

namespace rung::tb {
namespace {

using isa::Mpu;
using isa::Opcode;

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
TYPED_TEST_SUITE(BoardTest, BoardCases);

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
  while (this->board_.sending()) this->board_.exchange(kStart);
  this->board_.exchange(0);  // while the last scan runs
  const std::uint64_t reply = this->board_.exchange(0);
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
