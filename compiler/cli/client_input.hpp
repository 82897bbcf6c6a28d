// SPDX-License-Identifier: Apache-2.0
// What the commands that talk to a controller share.
#pragma once

#include <functional>
#include <optional>

#include "cli/bound.hpp"
#include "client/controller.hpp"

namespace rung::cli {

// The line as the options say, else as the I/O map does, else the controller's own after reset.
client::LineOptions line_of(const Options& options, const std::optional<io::Map>& map);

// Runs `talk`; what goes wrong on the line is an error at 1:1 of the port.
int with_controller(const Options& options, Diagnostics& diagnostics,
                    const std::function<int()>& talk);

// The devices that names may mean: of the program, or without one of the dialect alone (fx if the
// options name none). Nothing, with errors, if the program is refused.
std::optional<io::Subject> names_for(const Options& options, const std::string& program,
                                     Diagnostics& diagnostics);

}  // namespace rung::cli
