// SPDX-License-Identifier: Apache-2.0
// The controller's part of the flash (hdl/controller/README.md, Flash), as a programmer would write
// it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rung_controller.hpp"

namespace rung::device {

// Writes a load file as copy 0 of a board's flash and erases copy 1, so that this is the program
// that starts. Saved values stay: they are restored if their layout is the program's.
void put_program(std::span<std::uint8_t> flash, const controller::Board& board,
                 std::span<const std::uint16_t> words);

}  // namespace rung::device
