// SPDX-License-Identifier: Apache-2.0
#include "bytecode/hand_made.hpp"

#include <zlib.h>

namespace rung::tb {
namespace {

void put(std::string& bytes, std::size_t at, std::uint32_t value, int width) {
  for (int i = 0; i < width; ++i) bytes[at + i] = static_cast<char>(value >> (8 * i) & 0xFFU);
}

void add(std::string& bytes, const std::vector<std::uint8_t>& section) {
  bytes.append(section.begin(), section.end());
}

}  // namespace

std::string HandMade::bytes() const {
  std::string out(RUNG_HEADER_BYTES, '\0');
  out.replace(0, 4, RUNG_FORMAT_MAGIC);
  put(out, RUNG_AT_MAJOR, static_cast<std::uint32_t>(major), 1);
  put(out, RUNG_AT_MINOR, static_cast<std::uint32_t>(minor), 1);
  put(out, RUNG_AT_CODE_SIZE, static_cast<std::uint32_t>(code.size()), 4);
  put(out, RUNG_AT_BITS, static_cast<std::uint32_t>(bits), 2);
  put(out, RUNG_AT_WORDS, static_cast<std::uint32_t>(words + constants.size()), 2);
  put(out, RUNG_AT_FIRST_CONSTANT, static_cast<std::uint32_t>(words), 2);
  put(out, RUNG_AT_TICKS, static_cast<std::uint32_t>(ticks.size() / RUNG_TICK_BYTES), 2);
  put(out, RUNG_AT_DRIVEN, static_cast<std::uint32_t>(driven.size() / RUNG_DRIVEN_BYTES), 2);
  put(out, RUNG_AT_PORTS, static_cast<std::uint32_t>(ports.size() / RUNG_PORT_BYTES), 2);
  put(out, RUNG_AT_NAMES, static_cast<std::uint32_t>(names_count), 2);
  put(out, RUNG_AT_BLOCKS, static_cast<std::uint32_t>(blocks), 2);
  put(out, RUNG_AT_BRANCHES, static_cast<std::uint32_t>(branches), 2);
  for (const std::int16_t constant : constants) {
    out.append(RUNG_CONSTANT_BYTES, '\0');
    put(out, out.size() - RUNG_CONSTANT_BYTES, static_cast<std::uint16_t>(constant), 2);
  }
  for (const auto* section : {&ticks, &driven, &ports, &code, &names}) add(out, *section);
  out.append(RUNG_CRC_BYTES, '\0');
  put(out, RUNG_AT_SIZE, static_cast<std::uint32_t>(out.size()), 4);
  return with_crc(std::move(out));
}

std::string with_crc(std::string bytes) {
  if (bytes.size() < RUNG_CRC_BYTES) return bytes;
  const std::size_t at = bytes.size() - RUNG_CRC_BYTES;
  put(bytes, at,
      static_cast<std::uint32_t>(
          crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(at))),
      RUNG_CRC_BYTES);
  return bytes;
}

std::vector<std::uint8_t> operator+(std::vector<std::uint8_t> left,
                                    const std::vector<std::uint8_t>& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

Loaded::Loaded(std::string file) : file_(std::move(file)) {
  const auto* image = reinterpret_cast<const std::uint8_t*>(file_.data());
  error_ = rung_vm_needs(image, file_.size(), &memory_);
  if (error_ != RUNG_VM_OK) return;
  times_.resize(memory_.times_count);
  words_.resize(memory_.words_count);
  bits_.resize(memory_.bits_count);
  memory_.times = times_.data();
  memory_.words = words_.data();
  memory_.bits = bits_.data();
  error_ = rung_vm_load(&vm_, image, file_.size(), &memory_);
}

}  // namespace rung::tb
