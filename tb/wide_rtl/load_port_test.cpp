// SPDX-License-Identifier: Apache-2.0
// The load port: what is written is read, nothing else changes, answers come one a clock in time.
#include <gtest/gtest.h>

#include <random>

#include "wide_rtl/wide_rtl.hpp"

namespace rung::tb::wide {
namespace {

class LoadPort : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Slots, LoadPort, testing::Values(4, 8, 16));

TEST_P(LoadPort, WritesOnePlaceOnly) {
  auto rtl = make_wide_rtl(GetParam(), 1);
  const int slots = rtl->slots();
  constexpr int kSome = 20;  // rows
  std::vector<std::uint16_t> bits(static_cast<std::size_t>(kSome * slots));
  std::vector<std::uint16_t> words(static_cast<std::size_t>(kSome * slots / 2));
  for (int row = 0; row < kSome; ++row) {
    for (int slot = 0; slot < slots; ++slot) rtl->write_bit({row, slot}, false);
    for (int unit = 0; unit < slots / 2; ++unit) rtl->write_word({row, unit}, 0);
  }
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    const auto place = static_cast<int>(random() % bits.size());
    const auto value = static_cast<std::uint16_t>(random() & 1);
    rtl->write_bit({place / slots, place % slots}, value != 0);
    bits[static_cast<std::size_t>(place)] = value;
    const auto word_place = static_cast<int>(random() % words.size());
    const auto word = static_cast<std::uint16_t>(random());
    rtl->write_word({word_place / (slots / 2), word_place % (slots / 2)}, word);
    words[static_cast<std::size_t>(word_place)] = word;
  }
  EXPECT_EQ(rtl->read_bit_rows(kSome), bits);
  EXPECT_EQ(rtl->read_word_rows(kSome), words);
}

}  // namespace
}  // namespace rung::tb::wide
