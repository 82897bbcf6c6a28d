// SPDX-License-Identifier: Apache-2.0
// Frames of Modbus RTU and their CRC.
#pragma once

#include <cstdint>
#include <vector>

namespace rung::tb {

using Frame = std::vector<std::uint8_t>;

// CRC-16 of Modbus by its definition, bit by bit.
inline std::uint16_t modbus_crc(const Frame& bytes) {
  unsigned crc = 0xffff;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int i = 0; i < 8; ++i) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xa001 : crc >> 1;
  }
  return static_cast<std::uint16_t>(crc);
}

inline Frame with_crc(Frame bytes) {
  const std::uint16_t crc = modbus_crc(bytes);
  bytes.push_back(static_cast<std::uint8_t>(crc & 0xff));
  bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
  return bytes;
}

}  // namespace rung::tb
