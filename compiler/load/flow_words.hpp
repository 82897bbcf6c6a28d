// SPDX-License-Identifier: Apache-2.0
// What a load file sets in the spaces of the task hardware (hdl/isa/flow.toml).
#pragma once

#include <cstdint>
#include <vector>

#include "image/flow.hpp"
#include "io/map.hpp"

namespace rung::load {

struct SpaceWord {
  int space = 0;
  std::uint32_t address = 0;
  std::uint16_t value = 0;
};

// Step, transfer and task tables, and the registers with the boards of this unit. `panel_step`: of
// the panel's UART. A program without flow tasks has none of these: `enable` is 0 before a program
// is loaded.
std::vector<SpaceWord> flow_words(const image::FlowImage& flow, const io::FlowSettings& settings,
                                  std::int64_t panel_step);

}  // namespace rung::load
