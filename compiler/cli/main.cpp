// SPDX-License-Identifier: Apache-2.0
// rung: compile, run, check, translate and show ladder programs, and talk to the controllers that
// run them.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "cli/options.hpp"

namespace {

int execute(const rung::cli::Options& options) {
  using namespace rung::cli;
  switch (options.command) {
    case Command::Compile:
      return compile_command(options);
    case Command::Run:
      return run_command(options);
    case Command::Check:
      return check_command(options);
    case Command::Translate:
      return translate_command(options);
    case Command::Export:
      return export_command(options);
    case Command::Load:
      return load_command(options);
    case Command::Info:
      return info_command(options);
    case Command::Monitor:
      return monitor_command(options);
    case Command::Force:
      return force_command(options);
    case Command::Control:
      return control_command(options);
    case Command::Device:
      return device_command(options);
    case Command::View:
      return view_command(options);
  }
  return kUsage;
}

}  // namespace

int main(int argc, char** argv) {
  rung::cli::Options options;
  if (const auto code = rung::cli::parse(argc, argv, options)) return *code;
  try {
    return execute(options);
  } catch (const rung::cli::UsageError& error) {
    fmt::print(stderr, "rung: {}\n", error.what());
    return rung::cli::kUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}:1:1: error: {}\n",
               options.program.empty() ? options.port : options.program, error.what());
    return rung::cli::kRefused;
  }
}
