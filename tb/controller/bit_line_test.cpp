// SPDX-License-Identifier: Apache-2.0
#include "controller/bit_line.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rung::tb {
namespace {

constexpr std::uint32_t step_of(double clocks_per_bit) {
  return static_cast<std::uint32_t>(8.0 * (1 << 20) / clocks_per_bit);
}

std::vector<std::uint8_t> through(BitLine& from, BitLine& to, int clocks) {
  for (std::uint64_t now = 0; now < static_cast<std::uint64_t>(clocks); ++now) {
    to.sample(now, from.level(now));
  }
  return to.take();
}

// One end sends, the other decodes: any rate, parity and bytes.
TEST(BitLine, RoundTrip) {
  std::mt19937 random(7);
  for (const double clocks : {8.1, 13.0, 13.02, 26.04, 217.01}) {
    for (const Parity parity : {Parity::None, Parity::Odd, Parity::Even}) {
      BitLine from, to;
      from.set_rate(step_of(clocks), parity);
      to.set_rate(step_of(clocks), parity);
      std::vector<std::uint8_t> bytes(200);
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
      for (const auto byte : bytes) from.send(byte);
      EXPECT_EQ(from.sending(), bytes.size());
      EXPECT_EQ(through(from, to, static_cast<int>(bytes.size() * 11 * (clocks + 1))), bytes);
      EXPECT_EQ(from.sending(), 0U);
      EXPECT_EQ(to.bad_bytes(), 0U);
    }
  }
}

// Levels of one character: start, bits from the lowest, parity, stop; each as long as it should be.
TEST(BitLine, LevelsOfACharacter) {
  BitLine line;
  line.set_rate(step_of(16), Parity::Even);
  EXPECT_EQ(line.clocks_per_bit(), 16);
  EXPECT_EQ(line.character_clocks(), 176U);
  line.send(0x43);
  std::string levels;
  for (std::uint64_t now = 0; now < 192; ++now) {
    const bool level = line.level(now);
    if (now % 16 == 0 || now % 16 == 15) levels += level ? '1' : '0';
  }
  EXPECT_EQ(levels,
            "00"
            "1111000000001100"
            "11"
            "11"
            "11");
}

TEST(BitLine, BadBytesAndAnotherParityAreNone) {
  for (const Parity parity : {Parity::None, Parity::Odd, Parity::Even}) {
    BitLine from, to;
    from.set_rate(step_of(13), parity);
    to.set_rate(step_of(13), parity);
    from.send(0x12);
    from.send_bad(0x34);
    from.send(0x56);
    EXPECT_EQ(through(from, to, 600), (std::vector<std::uint8_t>{0x12, 0x56}));
    EXPECT_EQ(to.bad_bytes(), 1U);
  }
  BitLine even, odd;
  even.set_rate(step_of(13), Parity::Even);
  odd.set_rate(step_of(13), Parity::Odd);
  even.send(0x12);
  EXPECT_TRUE(through(even, odd, 200).empty());
  EXPECT_EQ(odd.bad_bytes(), 1U);
}

}  // namespace
}  // namespace rung::tb
