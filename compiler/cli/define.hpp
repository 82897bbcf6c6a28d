// SPDX-License-Identifier: Apache-2.0
// How the command line is defined: what the commands share.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/options.hpp"

namespace rung::cli {

CLI::App* add_command(CLI::App& app, Options& options, Command which, const char* name,
                      const char* what);
// --dialect, --config, --comments, --io
void define_common(CLI::App& command, Options& options);
void define_mpu(CLI::App& command, Options& options, bool with_reference);
// --clock
void define_clock(CLI::App& command, Options& options);

void define_export(CLI::App& app, Options& options);
// load, info, monitor, force, control
void define_client_commands(CLI::App& app, Options& options);
void define_device(CLI::App& app, Options& options);
void define_view(CLI::App& app, Options& options);
// --port and what is set on the line.
void define_line(CLI::App& command, Options& options, bool required);

}  // namespace rung::cli
