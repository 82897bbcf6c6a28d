// SPDX-License-Identifier: Apache-2.0
#include "device/flash_image.hpp"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>

namespace rung::device {
namespace {

constexpr std::uint16_t kCopyMagic = 0x5243;  // "RC"
constexpr std::uint8_t kErased = 0xFF;
constexpr std::uint32_t kGeneration = 1;  // of the first program

void put_word(std::span<std::uint8_t> flash, std::size_t word, std::uint32_t value) {
  flash[2 * word] = static_cast<std::uint8_t>(value >> 8 & 0xFF);
  flash[2 * word + 1] = static_cast<std::uint8_t>(value & 0xFF);
}

// 32-bit values are two words, the low one first.
void put_long(std::span<std::uint8_t> flash, std::size_t word, std::uint32_t value) {
  put_word(flash, word, value & 0xFFFF);
  put_word(flash, word + 1, value >> 16);
}

std::uint32_t crc(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(::crc32(0, bytes.data(), static_cast<uInt>(bytes.size())));
}

}  // namespace

void put_program(std::span<std::uint8_t> flash, const controller::Board& board,
                 std::span<const std::uint16_t> words) {
  constexpr std::size_t kSector = controller::flash_sector_bytes;
  constexpr std::size_t kCopy = controller::flash_copy_sectors * kSector;
  const auto base = static_cast<std::size_t>(board.flash_base) * kSector;
  if (flash.size() < base + 2 * kCopy || 2 * words.size() > kCopy - kSector) {
    throw std::runtime_error("the program is longer than its place in the flash");
  }
  const auto copies = flash.subspan(base, 2 * kCopy);
  std::fill(copies.begin(), copies.end(), kErased);

  const auto content = copies.subspan(kSector, 2 * words.size());
  for (std::size_t i = 0; i < words.size(); ++i) put_word(content, i, words[i]);
  put_word(copies, 0, kCopyMagic);
  put_long(copies, 1, kGeneration);
  put_long(copies, 3, static_cast<std::uint32_t>(words.size()));
  put_long(copies, 5, crc(content));
  put_long(copies, 7, crc(copies.first(14)));
}

}  // namespace rung::device
