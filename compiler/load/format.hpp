// SPDX-License-Identifier: Apache-2.0
// Numbers of the load file's format (hdl/controller/README.md), for its writer and its reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "isa/isa.hpp"
#include "rung_controller.hpp"

namespace rung::load {

inline constexpr std::uint16_t kMagic = 0x5250;  // "RP"
inline constexpr std::uint16_t kFormat = 1;
inline constexpr std::size_t kHeaderWords = 16;
inline constexpr std::size_t kMagicAt = 0, kFormatAt = 1, kTablesAt = 2, kConfigAt = 3,
                             kBoardAt = 4, kMpuAt = 5, kLengthAt = 6, kRetainAt = 8, kUnusedAt = 9,
                             kChunksAt = 10;
inline constexpr std::size_t kRecordWords = 255;
inline constexpr std::uint32_t kStepAddresses = 8;  // a step's chunks begin at a multiple
// A copy in the flash, less the sector of its header.
inline constexpr std::size_t kMostWords =
    (controller::flash_copy_sectors - 1) * controller::flash_sector_bytes / 2;

inline int config_id(std::string_view config) {
  for (const controller::ConfigId& each : controller::config_ids) {
    if (each.config == config) return each.id;
  }
  return 0;
}

inline int chunks_of(isa::Mpu mpu, const isa::Config& config) {
  return (isa::slots(mpu) * isa::slot_bits(mpu, config) + 15) / 16;
}

}  // namespace rung::load
