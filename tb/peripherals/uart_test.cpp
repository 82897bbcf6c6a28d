// SPDX-License-Identifier: Apache-2.0
// The UART's transmitter and receiver against lines that the test makes and measures clock by
// clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "Vuart_rx.h"
#include "Vuart_tx.h"
#include "harness/clocked.hpp"
#include "peripherals/uart_lines.hpp"

namespace rung::tb {
namespace {

// Clocks a bit: 921,600 baud at 12 MHz, 115,200 at 12 and 25, 9,600 at 12 and at 100 MHz.
constexpr double kRates[] = {12e6 / 921600, 12e6 / 115200, 25e6 / 115200, 12e6 / 9600,
                             100e6 / 9600};

// All of them in some order; some of them where a bit takes long.
std::vector<std::uint8_t> all_bytes(double clocks_a_bit) {
  std::vector<std::uint8_t> bytes(256);
  for (int i = 0; i < 256; ++i) bytes[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i);
  std::shuffle(bytes.begin(), bytes.end(), std::mt19937(3));
  if (clocks_a_bit > 1000) bytes.resize(20);
  return bytes;
}

struct Received {
  std::vector<std::uint8_t> bytes;
  int framing_errors = 0;
};

// What the receiver makes of the levels.
Received receive(const std::vector<bool>& levels, double clocks_a_bit) {
  Clocked<Vuart_rx> rx;
  rx->baud_step_i = baud_step(clocks_a_bit);
  rx->parity_i = 0;
  rx->rx_i = 1;
  rx.reset();
  Received received;
  for (const bool level : levels) {
    rx->rx_i = level ? 1 : 0;
    rx.tick();
    if (rx->valid_o != 0) received.bytes.push_back(rx->data_o);
    received.framing_errors += rx->framing_error_o;
  }
  return received;
}

class Uart : public testing::TestWithParam<double> {};

// Bytes to send, `gap` clocks after the transmitter can take each; the levels until all are out.
std::vector<bool> transmit(const std::vector<std::uint8_t>& bytes, double clocks_a_bit, int gap) {
  Clocked<Vuart_tx> tx;
  tx->baud_step_i = baud_step(clocks_a_bit);
  tx->parity_i = 0;
  tx->two_stops_i = 0;
  tx->valid_i = 0;
  tx.reset();
  std::vector<bool> levels;
  std::size_t next = 0;
  int wait = 0;
  const auto rest = static_cast<std::size_t>(20 * clocks_a_bit);
  for (std::size_t quiet = 0; quiet < rest; ++quiet) {
    const bool offer = next < bytes.size() && tx->ready_o != 0 && ++wait > gap;
    tx->valid_i = offer ? 1 : 0;
    tx->data_i = offer ? bytes[next] : 0x55;
    tx.tick();
    if (offer) {
      ++next;
      wait = 0;
    }
    if (next < bytes.size() || tx->tx_o == 0) quiet = 0;
    levels.push_back(tx->tx_o != 0);
  }
  return levels;
}

TEST_P(Uart, SendsEveryByteWithoutGaps) {
  const std::vector<std::uint8_t> bytes = all_bytes(GetParam());
  const std::vector<bool> levels = transmit(bytes, GetParam(), 0);
  const LineReader line(levels, GetParam());
  EXPECT_EQ(line.bytes, bytes);
  EXPECT_FALSE(line.framing_error || line.cut);
  // Start bits ten bits apart on the line, all through: the length of a bit is right on average.
  ASSERT_EQ(line.starts.size(), bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const double clocks = static_cast<double>(line.starts[i] - line.starts[0]);
    EXPECT_NEAR(clocks, 10.0 * static_cast<double>(i) * GetParam(), 1 + 0.001 * clocks) << i;
  }
}

TEST_P(Uart, EveryBitOfTheLineIsAtMostAClockOff) {
  const std::vector<bool> levels = transmit({0x55, 0x55}, GetParam(), 0);
  std::vector<std::size_t> edges;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (levels[i] != levels[i - 1]) edges.push_back(i);
  }
  ASSERT_EQ(edges.size(), 20U);  // start, eight bits and stop alternate, twice
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto clocks = static_cast<double>(edges[i] - edges[0]);
    EXPECT_NEAR(clocks, static_cast<double>(i) * GetParam(), 1 + 0.001 * clocks) << i;
  }
}

TEST_P(Uart, SendsAfterPausesToo) {
  const std::vector<std::uint8_t> bytes = {0x00, 0xff, 0xa5, 0x80, 0x01};
  const LineReader line(transmit(bytes, GetParam(), static_cast<int>(12.3 * GetParam())),
                        GetParam());
  EXPECT_EQ(line.bytes, bytes);
  EXPECT_FALSE(line.framing_error || line.cut);
}

TEST_P(Uart, ReceivesBackToBackFromSendersTwoPerCentOff) {
  const std::vector<std::uint8_t> bytes = all_bytes(GetParam());
  for (const double off : {0.98, 0.99, 1.0, 1.01, 1.02}) {
    LineWriter line(GetParam() * off);
    line.idle(1.37);
    for (const std::uint8_t byte : bytes) line.byte(byte);
    line.idle(3);
    const Received received = receive(line.levels(), GetParam());
    EXPECT_EQ(received.bytes, bytes) << off;
    EXPECT_EQ(received.framing_errors, 0) << off;
  }
}

TEST_P(Uart, ReceivesWhateverThePhaseOfTheSender) {
  for (int i = 0; i < 40; ++i) {
    LineWriter line(GetParam());
    line.idle(2 + i / 40.0);
    line.byte(0xa6);
    line.idle(0.1 * i);
    line.byte(0x31);
    line.idle(2);
    EXPECT_EQ(receive(line.levels(), GetParam()).bytes, (std::vector<std::uint8_t>{0xa6, 0x31}));
  }
}

// One disturbance a bit, shorter than the distance of two samples, anywhere in a bit but for its
// edges, where a start bit's edge is what everything is measured from.
TEST_P(Uart, ShortDisturbancesChangeNothing) {
  const auto length = static_cast<std::size_t>(GetParam() / 8.01);
  ASSERT_GE(length, 1U);
  std::mt19937 random(7);
  const std::vector<std::uint8_t> bytes = all_bytes(GetParam());
  LineWriter line(GetParam());
  line.idle(2);
  for (const std::uint8_t byte : bytes) line.byte(byte);
  line.idle(2);
  std::vector<bool>& levels = line.levels();
  for (std::size_t bit = 0; bit < 10 * bytes.size(); ++bit) {
    const auto begin = static_cast<std::size_t>((2.0 + static_cast<double>(bit)) * GetParam()) + 2;
    const auto room = static_cast<std::size_t>(GetParam()) - length - 4;
    const std::size_t at = begin + random() % room;
    for (std::size_t i = at; i < at + length; ++i) levels[i] = !levels[i];
  }
  const Received received = receive(levels, GetParam());
  EXPECT_EQ(received.bytes, bytes);
  EXPECT_EQ(received.framing_errors, 0);
}

TEST_P(Uart, APulseOnTheIdleLineIsNoStartBit) {
  for (const double bits : {0.1, 0.2, 0.3}) {
    LineWriter line(GetParam());
    line.idle(1);
    for (int i = 0; i < 20; ++i) {
      line.level(false, bits);
      line.idle(1.5);
    }
    line.byte(0x5a);
    line.idle(2);
    const Received received = receive(line.levels(), GetParam());
    EXPECT_EQ(received.bytes, std::vector<std::uint8_t>{0x5a}) << bits;
    EXPECT_EQ(received.framing_errors, 0) << bits;
  }
}

TEST_P(Uart, AByteWithoutStopBitIsAFramingErrorAndTheNextOneIsReceived) {
  LineWriter line(GetParam());
  line.idle(2);
  line.byte(0x12);
  line.byte(0x34, false);
  line.idle(1);
  line.byte(0x56);
  line.level(false, 40);  // a break is one error, however long
  line.idle(1);
  line.byte(0x78);
  line.idle(2);
  const Received received = receive(line.levels(), GetParam());
  EXPECT_EQ(received.bytes, (std::vector<std::uint8_t>{0x12, 0x56, 0x78}));
  EXPECT_EQ(received.framing_errors, 2);
}

TEST_P(Uart, ItsOwnBytesComeBack) {
  const std::vector<std::uint8_t> bytes = all_bytes(GetParam());
  for (const int gap : {0, static_cast<int>(10.7 * GetParam())}) {
    const Received received = receive(transmit(bytes, GetParam(), gap), GetParam());
    EXPECT_EQ(received.bytes, bytes);
    EXPECT_EQ(received.framing_errors, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(ClocksABit, Uart, testing::ValuesIn(kRates),
                         [](const auto& info) { return std::to_string(std::lround(info.param)); });

}  // namespace
}  // namespace rung::tb
