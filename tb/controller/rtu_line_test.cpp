// SPDX-License-Identifier: Apache-2.0
// The RTU line by itself, byte by byte, against a model of its rules.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>

#include "controller/rtu_rules.hpp"

namespace rung::tb {
namespace {

unsigned seed_of_run() {
  const char* given = std::getenv("RUNG_SEED");
  return given != nullptr ? static_cast<unsigned>(std::stoul(given)) : std::random_device()();
}

TEST(RtuLine, RandomFramesDamageAndTakingFollowTheRules) {
  const unsigned seed = seed_of_run();
  SCOPED_TRACE("RUNG_SEED=" + std::to_string(seed) + " unit_line --gtest_filter=RtuLine.Random*");
  std::mt19937 random(seed);
  const auto one_in = [&](unsigned n) { return random() % n == 0; };
  RtuLine line(static_cast<int>(seed % 1000));
  RtuRules rules;
  int delivered = 0;
  for (int round = 0; round < 1500 && !testing::Test::HasFailure(); ++round) {
    Frame bytes = with_crc(random_bytes(random, one_in(8) ? 240 + random() % 20 : random() % 24));
    if (one_in(4)) bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    if (one_in(8)) bytes.resize(random() % bytes.size());
    if (one_in(8)) bytes.insert(bytes.begin(), static_cast<std::uint8_t>(random()));
    const bool errors = one_in(6);
    for (const std::uint8_t value : bytes) {
      const bool error = errors && one_in(10);
      line.byte(value, error);
      rules.byte(value, error);
      // Pauses up to the silence are nothing.
      const int gap = one_in(50) ? kSilence - 1 : kShortest - 1 + static_cast<int>(random() % 8);
      line.pause(gap);
    }
    if (one_in(6)) continue;  // the next one follows without silence
    line.silence();
    rules.silence();
    ASSERT_EQ(line.frame_waits(), rules.waiting.has_value()) << round;
    ASSERT_EQ(line.counts(), rules.counts) << round;
    if (rules.waiting) {
      ASSERT_EQ(line.frame(), *rules.waiting) << round;
      if (!one_in(3)) {
        line.take();
        rules.waiting.reset();
        ++delivered;
      }
    }
  }
  EXPECT_GT(delivered, 300);
}

TEST(RtuLine, TheSilenceIsExact) {
  std::mt19937 random(2);
  for (const int gap : {kSilence - 1, kSilence, kSilence + 2, kSilence + 3}) {
    RtuLine line(1);
    const Frame bytes = random_bytes(random, 20);
    Frame whole = with_crc(bytes);
    const Frame front(whole.begin(), whole.begin() + 9);
    const Frame back(whole.begin() + 9, whole.end());
    line.frame_in(front, kShortest);
    line.pause(gap - kShortest);
    line.frame_in(back, kShortest);
    line.silence();
    EXPECT_EQ(line.frame_waits(), gap <= kSilence) << gap;
    EXPECT_EQ(line.counts().bad_crc, gap <= kSilence ? 0 : 2) << gap;
  }
}

TEST(RtuLine, EveryWrongBitOfAFrameIsFound) {
  std::mt19937 random(5);
  RtuLine line(2);
  const Frame good = with_crc(random_bytes(random, 62));
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    Frame bytes = good;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    line.frame_in(bytes, kShortest);
    line.silence();
    ASSERT_FALSE(line.frame_waits()) << bit;
    ASSERT_EQ(line.counts(), (LineCounts{static_cast<int>(bit) + 1, 0, 0}));
  }
  line.frame_in(good, kShortest);
  line.silence();
  EXPECT_TRUE(line.frame_waits());
}

TEST(RtuLine, ReceivesAndSendsWithOneFreeClockOfTheRamIn64) {
  std::mt19937 random(6);
  RtuLine line(3);
  line.hog = true;
  const Frame good = random_bytes(random, 254);
  line.frame_in(with_crc(good), 130);
  line.silence();
  ASSERT_TRUE(line.frame_waits());
  EXPECT_EQ(line.frame(), good);
  line.send(good);
  Frame out;
  for (int i = 0; i < 254 * 140; ++i) {
    line.dut->tx_ready_i = i % 120 == 0 ? 1 : 0;
    line.dut.operator->()->eval();
    if (line.dut->tx_valid_o != 0 && line.dut->tx_ready_i != 0) out.push_back(line.dut->tx_data_o);
    line.clock();
  }
  EXPECT_EQ(out, with_crc(good));
  EXPECT_FALSE(line.sending());
}

TEST(RtuLine, LengthsThatAreNoneAreNotSent) {
  RtuLine line(4);
  for (const int length : {0, 255, 256, 0x1001, 0xffff}) {
    line.write_register(controller::reg_line_send, length);
    line.silence();
    EXPECT_FALSE(line.sending()) << length;
  }
}

TEST(RtuLine, AByteBeforeTheOneBeforeIsStoredSpoilsTheFrameAndNothingElse) {
  std::mt19937 random(8);
  RtuLine line(5);
  const Frame good = random_bytes(random, 30);
  for (int gap = 0; gap < 8; ++gap) {
    line.frame_in(with_crc(good), gap);
    line.silence();
    EXPECT_FALSE(line.frame_waits()) << gap;
    EXPECT_EQ(line.counts().bad_crc, gap + 1);
  }
  line.frame_in(with_crc(good), kShortest);
  line.silence();
  ASSERT_TRUE(line.frame_waits());
  EXPECT_EQ(line.frame(), good);
}

TEST(RtuLine, SettingsOfResetAreThoseOf19200BaudEvenParity) {
  Clocked<Vrtu_line> dut;
  dut.reset();
  EXPECT_EQ(dut->baud_step_o, 13422U);  // 8 * 2^20 * 19200 / 12e6 = 13421.77
  EXPECT_EQ(dut->parity_o, 2U);
}

}  // namespace
}  // namespace rung::tb
