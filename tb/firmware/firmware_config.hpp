// SPDX-License-Identifier: Apache-2.0
// The configuration that this build of the tests is for: RUNG_CONFIG.
#pragma once

#include <string_view>

#include "rung_controller.h"
#include "rung_controller.hpp"

#define RUNG_PASTE(a, b) a##b
#define RUNG_OF_CONFIG(name, config) RUNG_PASTE(name, config)
#define RUNG_STRING(a) #a
#define RUNG_STRING_OF(a) RUNG_STRING(a)

namespace rung::tb {

inline constexpr int kBitDevices = RUNG_OF_CONFIG(BIT_DEVICES_, RUNG_CONFIG);
inline constexpr int kWordDevices = RUNG_OF_CONFIG(WORD_DEVICES_, RUNG_CONFIG);
inline constexpr int kBitPoints = RUNG_OF_CONFIG(BIT_POINTS_, RUNG_CONFIG);
inline constexpr int kWordPoints = RUNG_OF_CONFIG(WORD_POINTS_, RUNG_CONFIG);
inline constexpr bool kFlow = RUNG_OF_CONFIG(FLOW_, RUNG_CONFIG) != 0;  // has flow tasks
inline constexpr std::string_view kConfig = RUNG_STRING_OF(RUNG_CONFIG);

inline int config_id() {
  for (const auto& row : controller::config_ids) {
    if (row.config == kConfig) return row.id;
  }
  return 0;
}

}  // namespace rung::tb
