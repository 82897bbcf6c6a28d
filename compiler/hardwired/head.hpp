// SPDX-License-Identifier: Apache-2.0
// The beginning of a hard-wired program's file: how it is used, what each bit of its ports is, the
// ports, and the counter of clocks.
#pragma once

#include <string>

#include "hardwired/verilog.hpp"

namespace rung::hardwired {

std::string head(const Program& source, const Interface& interface, const Plan& plan,
                 const Options& options);

// Text that can stand in a Verilog line comment.
std::string plain(const std::string& text);

}  // namespace rung::hardwired
