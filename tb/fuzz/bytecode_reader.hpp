// SPDX-License-Identifier: Apache-2.0
// Byte code files, as the interpreter loads and runs them.
#pragma once

#include <string_view>

namespace rung::fuzz {

// The bytes as they are, and with the right beginning, size and check sum, which would keep nearly
// everything else out.
void read_bytecode(std::string_view bytes);

}  // namespace rung::fuzz
