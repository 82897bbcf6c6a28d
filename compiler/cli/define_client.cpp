// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/define.hpp"

namespace rung::cli {
namespace {

std::vector<std::string> config_names() {
  std::vector<std::string> names;
  for (const isa::Config& config : isa::configs()) names.emplace_back(config.name);
  return names;
}

void define_load(CLI::App& app, Options& options) {
  CLI::App* command = add_command(app, options, Command::Load, "load",
                                  "compile a program, download it to a controller and run it");
  command
      ->add_option("PROGRAM", options.program,
                   "instruction list, CSV export, LDmicro (.ld) or flow program (.flow), or image")
      ->required();
  define_common(*command, options);
  define_mpu(*command, options, false);
  define_line(*command, options, true);
  define_clock(*command, options);
}

void define_info(CLI::App& app, Options& options) {
  CLI::App* command =
      add_command(app, options, Command::Info, "info", "what a controller is, and how it does");
  define_line(*command, options, true);
}

void define_monitor(CLI::App& app, Options& options) {
  CLI::App* command = add_command(app, options, Command::Monitor, "monitor",
                                  "show devices of a controller as they change");
  command->add_option("DEVICES", options.devices,
                      "[PROGRAM] [DEVICES...]: devices, or names that PROGRAM has; a file that is "
                      "there is PROGRAM; of PROGRAM alone all devices");
  define_common(*command, options);
  define_line(*command, options, true);
  command->add_option("--csv", options.csv, "record the values there, with time stamps");
  command->add_option("--interval", options.interval_ms, "milliseconds from sample to sample")
      ->check(CLI::Range(0, 3'600'000))
      ->capture_default_str();
  command->add_option("--count", options.count, "samples; if not given until Ctrl-C");
}

void define_force(CLI::App& app, Options& options) {
  CLI::App* command = add_command(app, options, Command::Force, "force",
                                  "force inputs and outputs of a controller, or release them");
  command->add_option("DEVICES", options.devices, "X5=1, Y0=0, Y0=release; names with --program");
  command->add_option("--program", options.program, "program whose names may stand for devices");
  define_common(*command, options);
  define_line(*command, options, true);
  command->add_flag("--list", options.list, "show what is forced");
  command->add_flag("--release-all", options.release_all, "release all");
}

void define_control(CLI::App& app, Options& options) {
  CLI::App* command = add_command(app, options, Command::Control, "control",
                                  "run, stop or step the program of a controller");
  command
      ->add_option(
          "ACTION", options.action,
          "run, stop, scan (one, when stopped), clear-statistics, leave-fault, save (latched "
          "devices now), clear-latched (when stopped)")
      ->required()
      ->check(CLI::IsMember(
          {"run", "stop", "scan", "clear-statistics", "leave-fault", "save", "clear-latched"}));
  define_line(*command, options, true);
}

}  // namespace

void define_common(CLI::App& command, Options& options) {
  command.add_option("--dialect", options.dialect, "of the program; else it decides itself")
      ->check(CLI::IsMember({"paper", "fx", "q", "ldmicro"}));
  command
      .add_option("--config", options.config,
                  "memory sizes and latencies; if not given the I/O map's board's, or ecp5")
      ->check(CLI::IsMember(config_names()));
  command.add_option("--comments", options.comments,
                     "device comments as CSV: names for traces, listings and messages");
  command.add_option("--io", options.io,
                     "I/O map (TOML): which device is which pin of which board (compiler/io)");
}

void define_mpu(CLI::App& command, Options& options, bool with_reference) {
  std::vector<std::string> names{"1", "2", "3"};
  // MPU4 has no controller around it, and `rung view` no picture of it.
  const std::string& name = command.get_name();
  const bool wide = name == "compile" || name == "run" || name == "check";
  if (wide) names.emplace_back("4");
  if (with_reference) names.emplace_back("reference");
  command.add_option("--mpu", options.mpu, "processor; if not given the I/O map's board's, or 3")
      ->check(CLI::IsMember(names));
  if (!wide) return;
  command
      .add_option("--slots", options.slots,
                  fmt::format("slots of MPU4; {} if not given", kDefaultSlots))
      ->check(CLI::IsMember({4, 8, 16}));
  command.add_flag("--no-merge", options.no_merge,
                   "MPU4: make every write of the program, seen or not (compiler/values)");
}

void define_line(CLI::App& command, Options& options, bool required) {
  command
      .add_option("--port", options.port,
                  "serial port of the controller, such as /dev/ttyUSB0, or tcp:HOST:PORT")
      ->required(required);
  // What serial ports can be set to, of what the controller can.
  command
      .add_option("--baud", options.baud,
                  "19200 if not given (rung load: first as the I/O map says; so parity and unit)")
      ->check(CLI::IsMember(
          {9600, 19200, 38400, 57600, 115200, 230400, 460800, 500000, 576000, 921600}));
  command.add_option("--parity", options.parity, "even if not given")
      ->check(CLI::IsMember({"none", "odd", "even"}));
  command.add_option("--unit", options.unit, "Modbus unit address, 1 if not given")
      ->check(CLI::Range(1, 247));
  command.add_option("--timeout", options.timeout_ms, "milliseconds to wait for an answer")
      ->check(CLI::Range(1, 600'000))
      ->capture_default_str();
}

CLI::App* add_command(CLI::App& app, Options& options, Command which, const char* name,
                      const char* what) {
  CLI::App* command = app.add_subcommand(name, what);
  command->callback([&options, which] { options.command = which; });
  return command;
}

void define_clock(CLI::App& command, Options& options) {
  command
      .add_option("--clock", options.clock_hz,
                  "clocks a second of the controller, if not those of its board: of rung device")
      ->check(CLI::Range(std::int64_t{1000}, std::int64_t{1'000'000'000}));
}

void define_export(CLI::App& app, Options& options) {
  CLI::App* command = add_command(app, options, Command::Export, "export",
                                  "write names and Modbus addresses for a SCADA");
  command
      ->add_option("PROGRAM", options.program,
                   "instruction list, CSV export, LDmicro (.ld) or flow program (.flow), or image")
      ->required();
  define_common(*command, options);
  command->add_option("--symbols", options.symbols, "the CSV file; - is standard output")
      ->required();
}

void define_client_commands(CLI::App& app, Options& options) {
  define_load(app, options);
  define_info(app, options);
  define_monitor(app, options);
  define_force(app, options);
  define_control(app, options);
}

}  // namespace rung::cli
