// SPDX-License-Identifier: Apache-2.0
// The host line's UART: parity, stop bits, driver enable.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

#include "Vhost_uart.h"
#include "harness/clocked.hpp"
#include "peripherals/uart_lines.hpp"

namespace rung::tb {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Clocks a bit (921,600 and 115,200 baud at 12 MHz, 19,200 at 25 MHz) and parity.
class HostUart : public testing::TestWithParam<std::tuple<double, Parity>> {
 protected:
  HostUart() {
    dut_->baud_step_i = baud_step(rate());
    dut_->parity_i = static_cast<std::uint8_t>(parity());
    dut_->rx_i = 1;
    dut_->tx_valid_i = 0;
    dut_.reset();
  }
  static double rate() { return std::get<0>(GetParam()); }
  static Parity parity() { return std::get<1>(GetParam()); }

  Bytes bytes() const {
    Bytes all;
    for (int i = 0; i < (rate() > 1000 ? 24 : 256); ++i) {
      all.push_back(static_cast<std::uint8_t>(i * 77));
    }
    return all;
  }

  struct Received {
    Bytes bytes;
    int errors = 0;
    std::vector<std::size_t> began;  // clocks in which rx_active_o became 1
    std::vector<std::size_t> ended;  // clocks of valid or error
  };
  Received receive(const std::vector<bool>& levels) {
    Received received;
    bool active = false;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      dut_->rx_i = levels[i] ? 1 : 0;
      dut_.tick();
      if (dut_->rx_active_o != 0 && !active) received.began.push_back(i);
      if (dut_->rx_valid_o != 0 || dut_->rx_error_o != 0) {
        EXPECT_TRUE(active && dut_->rx_active_o == 0);
        EXPECT_NE(dut_->rx_valid_o, dut_->rx_error_o);
        received.ended.push_back(i);
      }
      active = dut_->rx_active_o != 0;
      if (dut_->rx_valid_o != 0) received.bytes.push_back(dut_->rx_data_o);
      received.errors += dut_->rx_error_o;
    }
    return received;
  }

  Clocked<Vhost_uart> dut_{5};
};

TEST_P(HostUart, ReceivesFromSendersTwoPerCentOff) {
  for (const double off : {0.98, 1.0, 1.02}) {
    LineWriter line(rate() * off);
    line.idle(3.3);
    for (const std::uint8_t byte : bytes()) line.byte(byte, true, parity());
    line.idle(3);
    const Received received = receive(line.levels());
    EXPECT_EQ(received.bytes, bytes()) << off;
    EXPECT_EQ(received.errors, 0) << off;
    // Active from five eighths of the start bit to five eighths of the stop bit, by the receiver's
    // own clock from the start bit's edge on; two clocks for the input's registers, one for ours.
    const int character = parity() == Parity::none ? 10 : 11;
    ASSERT_EQ(received.began.size(), bytes().size());
    for (std::size_t i = 0; i < received.began.size(); ++i) {
      const double start = (3.3 + character * static_cast<double>(i)) * rate() * off;
      EXPECT_NEAR(static_cast<double>(received.began[i]), start + 0.625 * rate() + 3, 2.5);
      EXPECT_NEAR(static_cast<double>(received.ended[i]), start + (character - 0.375) * rate() + 3,
                  2.5 + 0.001 * character * rate());
    }
  }
}

TEST_P(HostUart, AWrongParityOrStopBitIsAnErrorInsteadOfAByte) {
  LineWriter line(rate());
  line.idle(2);
  Bytes expected;
  int errors = 0;
  std::mt19937 random(17);
  for (int i = 0; i < 60; ++i) {
    const auto byte = static_cast<std::uint8_t>(random());
    const auto kind = random() % 3;
    if (kind == 0 && parity() != Parity::none) {
      line.byte(byte, true, parity() == Parity::odd ? Parity::even : Parity::odd);
      ++errors;
    } else if (kind == 1) {
      line.byte(byte, false, parity());
      line.idle(1);
      ++errors;
    } else {
      line.byte(byte, true, parity());
      expected.push_back(byte);
    }
  }
  line.level(false, 50);  // a break: one error
  line.idle(2);
  const Received received = receive(line.levels());
  EXPECT_EQ(received.bytes, expected);
  EXPECT_EQ(received.errors, errors + 1);
}

TEST_P(HostUart, SendsCharactersOfElevenBitsAndEnablesTheDriverAroundThem) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}, bytes().size()}) {
    Bytes out = bytes();
    out.resize(count);
    std::vector<bool> levels;
    std::vector<bool> enabled;
    std::size_t next = 0;
    for (std::size_t quiet = 0; quiet < static_cast<std::size_t>(4 * rate()); ++quiet) {
      const bool offer = next < out.size() && dut_->tx_ready_o != 0;
      dut_->tx_valid_i = offer ? 1 : 0;
      dut_->tx_data_i = offer ? out[next] : 0xaa;
      dut_.tick();
      if (offer) ++next;
      levels.push_back(dut_->tx_o != 0);
      enabled.push_back(dut_->de_o != 0);
      EXPECT_EQ(dut_->tx_busy_o, dut_->de_o);
      if (dut_->de_o != 0) quiet = 0;
    }
    const LineReader line(levels, rate(), parity());
    EXPECT_EQ(line.bytes, out);
    EXPECT_FALSE(line.framing_error || line.parity_error || line.cut);
    ASSERT_EQ(line.starts.size(), out.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double at = 11.0 * static_cast<double>(i) * rate();
      EXPECT_NEAR(static_cast<double>(line.starts[i] - line.starts[0]), at, 1 + 0.001 * at);
    }
    // One piece, from the clock before the start bit to the clock after the last stop bit.
    std::vector<std::size_t> edges;
    for (std::size_t i = 0; i < enabled.size(); ++i) {
      if (enabled[i] != (i != 0 && enabled[i - 1])) edges.push_back(i);
    }
    ASSERT_EQ(edges.size(), 2U);
    EXPECT_EQ(edges[0] + 1, line.starts[0]);
    const double length = 11.0 * static_cast<double>(out.size()) * rate();
    EXPECT_GE(static_cast<double>(edges[1] - line.starts[0]), length * 0.999 - 1);
    EXPECT_LE(static_cast<double>(edges[1] - line.starts[0]), length * 1.001 + 3);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rates, HostUart,
    testing::Combine(testing::Values(12e6 / 921600, 12e6 / 115200, 25e6 / 19200),
                     testing::Values(Parity::none, Parity::odd, Parity::even)));

}  // namespace
}  // namespace rung::tb
