// SPDX-License-Identifier: Apache-2.0
// What comes to the programs on a PC over their lines: Modbus TCP to the gateway of `rung device`,
// what is typed there, and commands of a page to `rung view`.
#pragma once

#include <string_view>

namespace rung::fuzz {

void read_mbap(std::string_view bytes);
void read_console(std::string_view bytes);
void read_view(std::string_view bytes);

}  // namespace rung::fuzz
