// SPDX-License-Identifier: Apache-2.0
// What the command line says.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "isa/isa.hpp"
#include "rungs/program.hpp"

namespace rung::cli {

// Exit codes of INTERFACES.md.
inline constexpr int kDone = 0;
inline constexpr int kRefused = 1;    // the program or a file
inline constexpr int kUsage = 2;      // wrong usage
inline constexpr int kDifferent = 3;  // a run differed from its golden trace or its reference

enum class Command {
  Compile,
  Run,
  Check,
  Translate,
  Export,
  Load,
  Info,
  Monitor,
  Force,
  Control,
  Device,
  View
};

inline constexpr int kDefaultSlots = 8;

struct Options {
  Command command = Command::Compile;
  std::string program;
  std::string dialect;       // empty: the program decides
  std::string config;        // empty: the I/O map's board's, or ecp5
  std::string comments;      // a file with the names of devices
  std::string io;            // a file: the I/O map
  std::string mpu;           // empty: the image's, or default_mpu
  int default_mpu = 3;       // what a program is compiled for if `mpu` does not say it
  std::optional<int> slots;  // of MPU4; kDefaultSlots if not given
  bool no_merge = false;     // MPU4
  bool paper = false;
  // compile
  std::string output;
  bool json = false;
  bool listing = false;
  std::string dump;
  std::uint64_t seed = 1;
  bool prove = false;
  bool bindings = false;
  std::string load_file;
  std::optional<std::int64_t> clock_hz;  // of the controller; else the configuration's
  // run, check
  std::string stimulus;
  std::optional<std::uint64_t> scans;
  std::string tick;
  std::string trace;
  bool state = false;
  std::string golden;
  // translate
  std::string target;
  std::string path_ns;
  // export
  std::string symbols;
  // the commands that talk to a controller
  std::string port;
  std::optional<int> baud;
  std::string parity;
  std::optional<int> unit;
  int timeout_ms = 1000;
  std::vector<std::string> devices;
  std::string csv;
  int interval_ms = 500;
  std::uint64_t count = 0;  // samples, 0: until stopped
  bool list = false;
  bool release_all = false;
  std::string action;
  // device
  std::string board;
  std::string flash;
  std::string link;
  std::optional<int> tcp_port;
  std::uint64_t clocks_per_ms = 250;
  bool fast = false;
  std::vector<std::string> inputs;
  bool watch = false;
  // view
  std::string listen;  // [ADDRESS:]PORT
  std::string token;
  bool text = false;
  bool no_browser = false;
};

// A wrong usage that CLI11 cannot see.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The dialect asked for, --paper included; nothing if the program decides.
std::optional<Dialect> dialect_of(const Options& options);
const isa::Config& config_of(const Options& options);
// 1 to 4, 0 for the reference; nothing if --mpu was not given.
std::optional<int> mpu_of(const Options& options);
// The options of MPU4 as they were given, for a command that replays a run.
std::string wide_options(const Options& options);
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
int export_command(const Options& options);
int load_command(const Options& options);
int info_command(const Options& options);
int monitor_command(const Options& options);
int force_command(const Options& options);
int control_command(const Options& options);
int device_command(const Options& options);
int view_command(const Options& options);

}  // namespace rung::cli
