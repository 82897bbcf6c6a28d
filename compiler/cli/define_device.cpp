// SPDX-License-Identifier: Apache-2.0
#include "cli/define.hpp"
#include "controller/simulated_controller.hpp"

namespace rung::cli {

void define_device(CLI::App& app, Options& options) {
  CLI::App* command =
      add_command(app, options, Command::Device, "device",
                  "simulate a controller as a device that clients open as a serial port");
  command->add_option("PROGRAM", options.program,
                      "program or image that is in its flash; else what --flash holds, or nothing");
  define_common(*command, options);
  command->add_option("--board", options.board, "if not given the I/O map's board, or simulated")
      ->check(CLI::IsMember({"simulated", "hx8k"}));
  command->add_option("--flash", options.flash,
                      "the flash's contents: read if the file is there, written at the end");
  command->add_option("--link", options.link, "a symbolic link to the pseudo-terminal");
  command
      ->add_option("--tcp", options.tcp_port,
                   "Modbus TCP gateway on this port of 127.0.0.1; 0 for any free one")
      ->check(CLI::Range(0, 65535));
  command
      ->add_option("--clocks-per-ms", options.clocks_per_ms,
                   "clocks of a simulated millisecond; serial timing scales with it")
      ->check(CLI::IsMember(tb::SimulatedController::built_clocks_per_ms()))
      ->capture_default_str();
  command->add_flag("--fast", options.fast,
                    "as fast as it goes, not in real time; the line waits for it");
  command
      ->add_option("--baud", options.baud,
                   "of the client's line; if not given it follows the controller's setting")
      ->check(CLI::Range(300, 921'600));
  command->add_option("--parity", options.parity, "with --baud; even if not given")
      ->check(CLI::IsMember({"none", "odd", "even"}));
  command->add_option("--inputs", options.inputs, "levels and samples at the start: in0=1,adc0=512")
      ->delimiter(',');
  command->add_flag("--watch", options.watch, "print each change of an output, with its time");
  command->footer(
      "Standard input takes commands: in3=1, adc0=512, power off, power on, switch stop, switch "
      "run,\n"
      "show, help, quit. SIGINT and SIGTERM end it; the flash is then in --flash.");
}

}  // namespace rung::cli
