// SPDX-License-Identifier: Apache-2.0
// What the command line says.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "isa/isa.hpp"
#include "rungs/program.hpp"

namespace rung::cli {

// Exit codes of INTERFACES.md.
inline constexpr int kDone = 0;
inline constexpr int kRefused = 1;    // the program or a file
inline constexpr int kUsage = 2;      // wrong usage
inline constexpr int kDifferent = 3;  // a run differed from its golden trace or its reference

enum class Command { Compile, Run, Check, Translate };

struct Options {
  Command command = Command::Compile;
  std::string program;
  std::string dialect;  // empty: the program decides
  std::string config = "ecp5";
  std::string comments;  // a file with the names of devices
  std::string mpu;       // empty: MPU3, or the image's
  bool paper = false;
  // compile
  std::string output;
  bool json = false;
  bool listing = false;
  std::string dump;
  std::uint64_t seed = 1;
  // run, check
  std::string stimulus;
  std::optional<std::uint64_t> scans;
  std::string tick;
  std::string trace;
  bool state = false;
  std::string golden;
  // translate
  std::string target;
};

// A wrong usage that CLI11 cannot see.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The dialect asked for, --paper included; nothing if the program decides.
std::optional<Dialect> dialect_of(const Options& options);
const isa::Config& config_of(const Options& options);
// 1 to 3, 0 for the reference; nothing if --mpu was not given.
std::optional<int> mpu_of(const Options& options);
// Microseconds of --tick, if it was given.
std::optional<std::int64_t> tick_of(const Options& options);

// Reads the command line. An exit code when there is nothing to do: help was asked for and printed,
// or the usage was wrong and has been reported.
std::optional<int> parse(int argc, char** argv, Options& options);

// The commands; each gives its exit code.
int compile_command(const Options& options);
int run_command(const Options& options);
int check_command(const Options& options);
int translate_command(const Options& options);

}  // namespace rung::cli
