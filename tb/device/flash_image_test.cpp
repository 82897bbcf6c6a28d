// SPDX-License-Identifier: Apache-2.0
#include "device/flash_image.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <stdexcept>

namespace rung::device {
namespace {

using Bytes = std::vector<std::uint8_t>;

const controller::Board& board(int id) {
  for (const controller::Board& one : controller::boards()) {
    if (one.id == id) return one;
  }
  throw std::runtime_error("no such board");
}

// As hdl/controller/README.md has it.
TEST(FlashImage, CopyWithItsHeader) {
  constexpr std::size_t kBase = 0x100 * 4096;  // hx8k
  Bytes flash(2 << 20, 0x55);
  const std::vector<std::uint16_t> words{0x5250, 0x0001, 0xABCD};
  put_program(flash, board(2), words);

  const Bytes content(flash.begin() + kBase + 4096, flash.begin() + kBase + 4096 + 6);
  EXPECT_EQ(content, (Bytes{0x52, 0x50, 0x00, 0x01, 0xAB, 0xCD}));
  const auto word = [&](std::size_t i) {
    return static_cast<std::uint32_t>(flash[kBase + 2 * i] << 8 | flash[kBase + 2 * i + 1]);
  };
  EXPECT_EQ(word(0), 0x5243U);
  EXPECT_EQ(word(1) | word(2) << 16, 1U);
  EXPECT_EQ(word(3) | word(4) << 16, 3U);
  EXPECT_EQ(word(5) | word(6) << 16, ::crc32(0, content.data(), 6));
  EXPECT_EQ(word(7) | word(8) << 16, ::crc32(0, flash.data() + kBase, 14));
  // The other copy is gone; what is not the copies' is untouched.
  EXPECT_EQ(flash[kBase + 64 * 4096], 0xFF);
  EXPECT_EQ(flash[kBase + 128 * 4096 - 1], 0xFF);
  EXPECT_EQ(flash[kBase + 128 * 4096], 0x55);
  EXPECT_EQ(flash[kBase - 1], 0x55);
}

TEST(FlashImage, TooLong) {
  Bytes flash(1 << 20, 0xFF);
  std::vector<std::uint16_t> words(63 * 2048);
  put_program(flash, board(0), words);
  words.push_back(0);
  EXPECT_THROW(put_program(flash, board(0), words), std::runtime_error);
}

}  // namespace
}  // namespace rung::device
