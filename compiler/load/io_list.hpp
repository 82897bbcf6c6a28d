// SPDX-License-Identifier: Apache-2.0
// The latch and refresh list of a program and its bindings.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.hpp"
#include "io/bind.hpp"

namespace rung::load {

struct IoEntry {
  std::uint16_t address = 0;  // of the device
  bool word = false;
  int kind = 0;  // controller::latch_* or refresh_*
  int index = 0;

  std::uint16_t second_word() const {
    return static_cast<std::uint16_t>((word ? 0x8000 : 0) | kind << 8 | index);
  }
};

struct IoList {
  std::vector<IoEntry> latch, refresh;
};

// Latch: every X device that the program names (without a pin: to be forced), driven special
// relays, ticks, a list's analogue words. Refresh: bound Y devices, a list's PWM.
IoList io_list(const image::Image& image, const io::Bindings& bindings);

}  // namespace rung::load
