// SPDX-License-Identifier: Apache-2.0
#include "cli/define.hpp"

namespace rung::cli {

void define_view(CLI::App& app, Options& options) {
  CLI::App* command = add_command(app, options, Command::View, "view",
                                  "show a program as a ladder diagram and run it, in a browser");
  command->add_option("PROGRAM", options.program,
                      "instruction list, CSV export, LDmicro (.ld) or flow program (.flow); an "
                      "example if not given");
  define_common(*command, options);
  define_mpu(*command, options, true);
  command->add_flag("--paper", options.paper, "compile with the paper's instruction forms only");
  command->add_option("--tick", options.tick, "milliseconds from scan to scan; 10 if not given");
  command->add_option("--listen", options.listen,
                      "[ADDRESS:]PORT of the page; 127.0.0.1:8310 if not given, or the next free "
                      "one. Another address needs the token that is then printed");
  command->add_option("--token", options.token, "this one, instead of one made by chance");
  command->add_flag("--no-browser", options.no_browser, "only print the page's address");
  command->add_flag("--text", options.text,
                    "in the terminal instead; if that is none, print the ladder after --scans");
  command->add_option("--scans", options.scans, "with --text: scans before the ladder is printed");
  command->add_option("--stimulus", options.stimulus, "with --text: inputs, a line a scan");
  define_line(*command, options, false);
  command->footer(
      "With --port it shows a controller that runs the program, through Modbus; else it runs the\n"
      "program on --mpu, with the reference beside it.");
}

}  // namespace rung::cli
