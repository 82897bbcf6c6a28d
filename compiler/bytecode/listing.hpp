// SPDX-License-Identifier: Apache-2.0
// Byte code for people to read.
#pragma once

#include <string>
#include <string_view>

namespace rung::bytecode {

// A line for what the file needs and has, then one for each instruction: its place in the code, its
// name and its operands, by their names where the file has them. `file` is one that write() made.
std::string listing(std::string_view file);

}  // namespace rung::bytecode
