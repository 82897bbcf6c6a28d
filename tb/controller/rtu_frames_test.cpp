// SPDX-License-Identifier: Apache-2.0
// RTU line and UART together: frames as levels of the line, replies as levels and driver enable.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <random>
#include <tuple>
#include <vector>

#include "Vrtu_bench.h"
#include "controller/rtu_bus.hpp"
#include "peripherals/uart_lines.hpp"

namespace rung::tb {
namespace {

constexpr double kFastest = 12e6 / 921600;
constexpr double kCharacter = 11;
constexpr double kSilenceBits = 3.5 * kCharacter;

class Host : public RtuBus<Vrtu_bench> {
 public:
  Host(double clocks_a_bit, Parity parity) : RtuBus(7), rate(clocks_a_bit), parity(parity) {
    dut->rx_i = 1;
    dut.reset();
    const std::uint32_t step = baud_step(rate);
    write_register(controller::reg_line_baud_low, static_cast<int>(step & 0xffff));
    write_register(controller::reg_line_baud_high, static_cast<int>(step >> 16));
    write_register(controller::reg_line_parity, static_cast<int>(parity));
    set_silence(static_cast<std::uint32_t>(std::lround(kSilenceBits * rate)));
    pause(kSilenceBits + 1);
  }

  double rate;
  Parity parity;
  std::vector<bool> tx;
  std::vector<bool> enabled;
  // RS-485: what we send comes back so many clocks later; -1: full duplex.
  int echo = -1;

  void clock() override {
    bool level = true;
    if (!remote_.empty()) {
      level = remote_.front();
      remote_.pop_front();
    }
    const auto back = static_cast<std::size_t>(echo);
    if (echo >= 0 && tx.size() > back) {
      const std::size_t at = tx.size() - 1 - back;
      level = level && (!enabled[at] || tx[at]);
    }
    dut->rx_i = level ? 1 : 0;
    dut.tick();
    tx.push_back(dut->tx_o != 0);
    enabled.push_back(dut->de_o != 0);
  }
  void pause(double bits) {
    const auto clocks = static_cast<int>(std::lround(bits * rate));
    for (int i = 0; i < clocks; ++i) clock();
  }
  // What the client's side of the line does from now on.
  void remote(LineWriter& line) {
    remote_.insert(remote_.end(), line.levels().begin(), line.levels().end());
  }
  void run_remote() {
    while (!remote_.empty()) clock();
  }
  void bytes_in(const Frame& bytes, double off = 1, double gap_bits = 0) {
    LineWriter line(rate * off);
    for (const std::uint8_t value : bytes) {
      line.byte(value, true, parity);
      line.idle(gap_bits);
    }
    remote(line);
    run_remote();
  }
  void silence() { pause(kSilenceBits + 1.5); }
  void forget() {
    tx.clear();
    enabled.clear();
  }
  std::size_t clocks_enabled() const {
    std::size_t clocks = 0;
    for (const bool on : enabled) clocks += on ? 1 : 0;
    return clocks;
  }

 private:
  std::deque<bool> remote_;
};

class Frames : public testing::TestWithParam<std::tuple<double, Parity>> {
 protected:
  Host host{std::get<0>(GetParam()), std::get<1>(GetParam())};
  std::mt19937 random{21};
};

TEST_P(Frames, OfEveryLengthAreReceived) {
  // All of them at the fastest rate with even parity, of the others some.
  const std::size_t step = host.rate > 14 ? 61 : host.parity == Parity::even ? 1 : 13;
  const double offs[] = {0.98, 1.0, 1.02};
  for (std::size_t length = 2; length <= 254; length += step) {
    const Frame bytes = random_bytes(random, length);
    host.bytes_in(with_crc(bytes), offs[length % 3], length % 5 == 0 ? 20 : 0);
    EXPECT_FALSE(host.frame_waits());
    host.silence();
    ASSERT_TRUE(host.frame_waits()) << length;
    ASSERT_EQ(host.frame(), bytes);
    host.take();
    ASSERT_FALSE(host.frame_waits());
  }
  EXPECT_EQ(host.counts(), LineCounts{});
  for (const std::size_t length : {std::size_t{1}, std::size_t{255}, std::size_t{600}}) {
    host.bytes_in(with_crc(random_bytes(random, length)));
    host.silence();
    ASSERT_FALSE(host.frame_waits()) << length;
  }
  EXPECT_EQ(host.counts(), (LineCounts{3, 0, 0}));
}

// Any bit of the line: start, data, parity and stop bits.
TEST_P(Frames, EveryWrongBitOfTheLineIsFound) {
  const Frame good = with_crc({0x11, 0x03, 0x00, 0x6b, 0x00, 0x03});
  const int character = host.parity == Parity::none ? 10 : 11;
  for (std::size_t bit = 0; bit < good.size() * static_cast<std::size_t>(character); ++bit) {
    LineWriter line(host.rate);
    for (const std::uint8_t value : good) line.byte(value, true, host.parity);
    std::vector<bool>& levels = line.levels();
    const auto from = static_cast<std::size_t>(std::ceil(static_cast<double>(bit) * host.rate));
    const auto to = static_cast<std::size_t>(std::ceil(static_cast<double>(bit + 1) * host.rate));
    for (std::size_t i = from; i < to && i < levels.size(); ++i) levels[i] = !levels[i];
    host.remote(line);
    host.run_remote();
    host.pause(kCharacter);  // a byte whose start bit is wrong ends late
    host.silence();
    ASSERT_FALSE(host.frame_waits()) << bit;
    ASSERT_EQ(host.counts().bad_crc, static_cast<int>(bit) + 1) << bit;
  }
  host.bytes_in(good);
  host.silence();
  EXPECT_TRUE(host.frame_waits());
}

TEST_P(Frames, CutFramesAreDroppedAndTheNextOneIsReceived) {
  const Frame good = random_bytes(random, 9);
  for (std::size_t kept = 1; kept < 11; ++kept) {
    Frame cut = with_crc(good);
    cut.resize(kept);
    host.bytes_in(cut);
    host.silence();
    ASSERT_FALSE(host.frame_waits()) << kept;
    host.bytes_in(with_crc(good));
    host.silence();
    ASSERT_TRUE(host.frame_waits()) << kept;
    host.take();
  }
  EXPECT_EQ(host.counts(), (LineCounts{10, 0, 0}));
}

TEST_P(Frames, WhatComesBeforeLineTakeIsLostAndCounted) {
  const Frame first = random_bytes(random, 20);
  const Frame second = random_bytes(random, 200);
  host.bytes_in(with_crc(first));
  host.silence();
  host.bytes_in(with_crc(second));
  host.silence();
  // Taken in the middle of the third one: it is lost all the same.
  Frame third = with_crc(second);
  const Frame rest(third.begin() + 50, third.end());
  third.resize(50);
  host.bytes_in(third);
  ASSERT_TRUE(host.frame_waits());
  EXPECT_EQ(host.frame(), first);
  host.take();
  host.bytes_in(rest);
  host.silence();
  EXPECT_FALSE(host.frame_waits());
  EXPECT_EQ(host.counts(), (LineCounts{0, 0, 2}));
  host.bytes_in(with_crc(second));
  host.silence();
  ASSERT_TRUE(host.frame_waits());
  EXPECT_EQ(host.frame(), second);
}

// As a client on the same line does it that talks to others: taken at once, but no pause beyond the
// standard's, from one that is 2 % too fast, so that its pause is short too.
TEST_P(Frames, BackToBackFramesAreToldApart) {
  for (const double off : {0.98, 1.0, 1.02}) {
    // As rtu_line.v says: a bit less than 3.5 characters for clients that are too fast.
    if (off < 1) host.set_silence(static_cast<std::uint32_t>((kSilenceBits - 1) * host.rate));
    if (off == 1) host.set_silence(static_cast<std::uint32_t>(kSilenceBits * host.rate));
    host.silence();
    const int frames = 20;
    LineWriter line(host.rate * off);
    std::vector<Frame> sent;
    for (int i = 0; i < frames; ++i) {
      sent.push_back(random_bytes(random, 2 + random() % 12));
      for (const std::uint8_t value : with_crc(sent.back())) line.byte(value, true, host.parity);
      if (host.parity == Parity::none) line.idle(1);  // the second stop bit
      line.idle(kSilenceBits);
    }
    line.idle(5);
    host.remote(line);
    std::vector<Frame> received;
    for (int i = 0; i < static_cast<int>(line.levels().size()); ++i) {
      if (host.frame_waits()) {
        received.push_back(host.frame());
        host.take();
      }
    }
    EXPECT_EQ(received, sent) << off;
  }
  EXPECT_EQ(host.counts(), LineCounts{});
}

TEST_P(Frames, RepliesComeAfterTheSilenceInOnePiece) {
  for (const std::size_t length : {std::size_t{1}, std::size_t{7}, std::size_t{254}}) {
    const Frame reply = random_bytes(random, length);
    host.bytes_in(with_crc({1, 3, 0, 0, 0, 1}));
    host.forget();
    while (!host.frame_waits()) host.clock();
    host.take();
    host.send(reply);
    while (host.sending()) host.clock();
    host.pause(5);
    const LineReader line(host.tx, host.rate, host.parity);
    EXPECT_EQ(line.bytes, with_crc(reply));
    EXPECT_FALSE(line.framing_error || line.parity_error || line.cut);
    ASSERT_EQ(line.starts.size(), length + 2);
    // The request's end is known from the middle of its stop bit on.
    EXPECT_GE(static_cast<double>(line.starts[0]), (kSilenceBits - 0.5) * host.rate);
    const double whole = kCharacter * static_cast<double>(length + 2) * host.rate;
    const auto first = static_cast<std::size_t>(
        std::find(host.enabled.begin(), host.enabled.end(), true) - host.enabled.begin());
    EXPECT_EQ(first + 1, line.starts[0]);
    EXPECT_NEAR(static_cast<double>(host.clocks_enabled()), whole, 4 + whole * 0.001);
    EXPECT_TRUE(host.enabled[first + host.clocks_enabled() - 1]);  // in one piece
  }
  EXPECT_EQ(host.counts(), LineCounts{});
}

TEST_P(Frames, TheOwnEchoIsNotHeard) {
  const Frame request = random_bytes(random, 6);
  for (const double delay : {0.0, 0.3, 0.9}) {
    host.echo = static_cast<int>(delay * host.rate);
    host.bytes_in(with_crc(request));
    host.silence();
    ASSERT_TRUE(host.frame_waits());
    host.take();
    host.send(random_bytes(random, 30));
    while (host.sending()) host.clock();
    host.silence();
    EXPECT_FALSE(host.frame_waits()) << delay;
    EXPECT_EQ(host.counts(), LineCounts{}) << delay;
  }
}

// The client does not wait for the silence before the reply: its frame is lost, the reply is sent.
TEST_P(Frames, AFrameThatComesWhileAReplyWaitsIsLost) {
  const Frame reply = random_bytes(random, 5);
  LineWriter line(host.rate);
  line.byte(0x55, true, host.parity);
  host.remote(line);
  host.pause(3);
  host.send(reply);  // in the middle of a byte
  host.run_remote();
  host.bytes_in({1, 2, 3});
  host.pause(kSilenceBits / 2);
  host.bytes_in({4, 5});
  EXPECT_EQ(host.clocks_enabled(), 0U);
  EXPECT_TRUE(host.sending());
  while (host.sending()) host.clock();
  EXPECT_EQ(LineReader(host.tx, host.rate, host.parity).bytes, with_crc(reply));
  EXPECT_EQ(host.counts(), (LineCounts{0, 0, 1}));
  host.bytes_in(with_crc(reply));
  host.silence();
  EXPECT_TRUE(host.frame_waits());
}

INSTANTIATE_TEST_SUITE_P(Rates, Frames,
                         testing::Combine(testing::Values(kFastest, 12e6 / 115200),
                                          testing::Values(Parity::none, Parity::odd,
                                                          Parity::even)));

TEST(Line, AFloodHoldsBackNoReply) {
  std::mt19937 random(31);
  Host host(kFastest, Parity::even);
  const Frame reply = random_bytes(random, 10);
  LineWriter line(host.rate);
  for (const std::uint8_t value : random_bytes(random, 900)) {
    line.byte(value, true, random() % 50 == 0 ? Parity::odd : Parity::even);
  }
  host.remote(line);
  host.pause(50);
  host.forget();
  host.send(reply);
  host.pause(kCharacter * 259);
  EXPECT_GT(host.clocks_enabled(), 0U);
  host.pause(kCharacter * 14);
  EXPECT_FALSE(host.sending());
  EXPECT_EQ(LineReader(host.tx, host.rate, Parity::even).bytes, with_crc(reply));
  host.run_remote();
  host.silence();
  EXPECT_FALSE(host.frame_waits());
  host.bytes_in(with_crc(reply));
  host.silence();
  ASSERT_TRUE(host.frame_waits());
  EXPECT_EQ(host.frame(), reply);
}

TEST(Line, NoiseIsNoFrameAndTheNextFrameIsReceived) {
  std::mt19937 random(32);
  Host host(kFastest, Parity::even);
  const Frame good = random_bytes(random, 12);
  LineCounts before;
  for (int round = 0; round < 60; ++round) {
    LineWriter line(host.rate);
    const double longest = round % 3 == 0 ? 0.3 : round % 3 == 1 ? 3 : 30;
    for (int i = 0; i < 200; ++i) {
      line.level(random() % 2 != 0, longest * static_cast<double>(random() % 1000) / 1000);
    }
    line.idle(1);
    host.remote(line);
    // The sequencer wants to send now and then.
    if (round % 4 == 0) host.send(good);
    host.run_remote();
    while (host.sending()) host.clock();
    host.pause(2 * kCharacter + kSilenceBits);
    ASSERT_FALSE(host.frame_waits()) << round;
    host.bytes_in(with_crc(good));
    host.silence();
    ASSERT_TRUE(host.frame_waits()) << round;
    ASSERT_EQ(host.frame(), good);
    host.take();
  }
  EXPECT_GT(host.counts().bad_crc, 10);
  EXPECT_GT(host.counts().bad_byte, 10);
}

}  // namespace
}  // namespace rung::tb
