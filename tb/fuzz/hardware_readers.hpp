// SPDX-License-Identifier: Apache-2.0
// What comes to the hardware over its lines, as choices of an input (input.hpp): to Verilated
// modules, and to the firmware, compiled as it is for this machine.
#pragma once

#include <string_view>

namespace rung::fuzz {

void read_rtu_line(std::string_view bytes);
void read_panel(std::string_view bytes);
void read_link(std::string_view bytes);
// The whole controller with its firmware, at the bytes of its line.
void read_controller(std::string_view bytes);
// Requests to the firmware, and a flash with anything in it at its start.
void read_modbus(std::string_view bytes);
void read_flash(std::string_view bytes);

}  // namespace rung::fuzz
