// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>

#include "cli/define.hpp"

namespace rung::cli {
namespace {

void define_compile(CLI::App& app, Options& options) {
  CLI::App* command =
      add_command(app, options, Command::Compile, "compile", "compile a program for a processor");
  command
      ->add_option(
          "PROGRAM", options.program,
          "instruction list, CSV export, LDmicro (.ld) or flow program (.flow); - is standard "
          "input")
      ->required();
  define_common(*command, options);
  define_mpu(*command, options, false);
  command->add_flag("--paper", options.paper, "only the paper's instruction forms and step counts");
  command->add_option("-o,--output", options.output, "write the image there; - is standard output");
  CLI::Option* json = command->add_flag("--json", options.json, "print sizes and counts as JSON");
  CLI::Option* listing =
      command->add_flag("--listing", options.listing, "print the code with its source lines");
  CLI::Option* dump = command->add_option("--dump", options.dump, "print what a pass has made")
                          ->check(CLI::IsMember({"logic", "mapping"}));
  json->excludes(listing)->excludes(dump);
  listing->excludes(dump);
  command->add_option("--seed", options.seed, "of the search for a schedule")
      ->capture_default_str();
  command
      ->add_flag("--prove", options.prove,
                 "prove that the code does what the program says, for every start of a scan")
      ->excludes(dump);
  command->add_flag("--bindings", options.bindings, "print what is bound where")
      ->excludes(json)
      ->excludes(listing)
      ->excludes(dump);
  command->add_option("--load-file", options.load_file,
                      "write what the controller's flash holds, for other loaders than rung load");
  define_clock(*command, options);
}

void define_run(CLI::App& app, Options& options) {
  CLI::App* command = add_command(app, options, Command::Run, "run", "run a program or an image");
  command
      ->add_option("PROGRAM", options.program,
                   "instruction list, CSV export, LDmicro (.ld) or flow program (.flow), or image")
      ->required();
  define_common(*command, options);
  define_mpu(*command, options, true);
  command->add_flag("--paper", options.paper, "compile with the paper's instruction forms only");
  command->add_option("--stimulus", options.stimulus, "inputs, a line a scan");
  command->add_option("--scans", options.scans, "number of scans");
  command->add_option("--tick", options.tick, "milliseconds from scan to scan; 10 if not given");
  command->add_option("--trace", options.trace, "write the golden sequence trace there");
  command->add_flag("--state", options.state,
                    "with every device's value in each scan of the trace");
}

void define_check(CLI::App& app, Options& options) {
  CLI::App* command =
      add_command(app, options, Command::Check, "check", "run and compare with a golden trace");
  command
      ->add_option("PROGRAM", options.program,
                   "instruction list, CSV export, LDmicro program (.ld) or image")
      ->required();
  define_common(*command, options);
  define_mpu(*command, options, true);
  command->add_flag("--paper", options.paper, "compile with the paper's instruction forms only");
  command->add_option("--golden", options.golden, "golden sequence trace, or LDmicro's own")
      ->required();
  command->add_option("--stimulus", options.stimulus, "inputs instead of those in the trace");
  command->add_option("--tick", options.tick, "milliseconds from scan to scan; else the trace's");
}

void define_translate(CLI::App& app, Options& options) {
  CLI::App* command =
      add_command(app, options, Command::Translate, "translate", "write a program in another form");
  command
      ->add_option("PROGRAM", options.program,
                   "instruction list, CSV export or LDmicro program (.ld)")
      ->required();
  define_common(*command, options);
  command
      ->add_option("--to", options.target,
                   "c: ANSI C; bytecode: for the interpreter of compiler/bytecode; il: normalised "
                   "instruction list; ld: LDmicro program; verilog: hard-wired logic")
      ->required()
      ->check(CLI::IsMember({"c", "bytecode", "il", "ld", "verilog"}));
  command->add_option("-o,--output", options.output, "file; else standard output");
  command->add_flag("--listing", options.listing, "print byte code as text");
  command
      ->add_option("--path-ns", options.path_ns,
                   "verilog: of a program with words, the longest path of a clock, as estimated "
                   "for an ECP5; default 8")
      ->check(CLI::Range(1.0, 1000.0));
}

}  // namespace

std::optional<Dialect> dialect_of(const Options& options) {
  if (options.paper) {
    if (!options.dialect.empty() && options.dialect != "paper") {
      throw UsageError(fmt::format("--paper implies --dialect paper, not {}", options.dialect));
    }
    return Dialect::Paper;
  }
  return find_dialect(options.dialect);
}

const isa::Config& config_of(const Options& options) {
  return *isa::find_config(options.config.empty() ? "ecp5" : options.config);
}

std::optional<int> mpu_of(const Options& options) {
  if (options.mpu.empty()) return std::nullopt;
  return options.mpu == "reference" ? 0 : options.mpu[0] - '0';
}

std::string wide_options(const Options& options) {
  return (options.slots ? fmt::format(" --slots {}", *options.slots) : "") +
         (options.no_merge ? " --no-merge" : "");
}

std::optional<std::int64_t> tick_of(const Options& options) {
  if (options.tick.empty()) return std::nullopt;
  const auto refuse = [&] {
    return UsageError(fmt::format(
        "--tick {}: a decimal number of milliseconds above 0, with at most three decimals",
        options.tick));
  };
  const std::size_t point = options.tick.find('.');
  const std::string whole = options.tick.substr(0, point);
  std::string fraction = point == std::string::npos ? "" : options.tick.substr(point + 1);
  if (fraction.size() > 3 || (whole.empty() && fraction.empty())) throw refuse();
  fraction.resize(3, '0');
  const std::string digits = whole + fraction;
  std::int64_t microseconds = 0;
  if (digits.find_first_not_of("0123456789") != std::string::npos) throw refuse();
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), microseconds);
  if (error != std::errc{} || end != digits.data() + digits.size() || microseconds == 0) {
    throw refuse();
  }
  return microseconds;
}

std::optional<int> parse(int argc, char** argv, Options& options) {
  CLI::App app("Rung: ladder programs on FPGA processors", "rung");
  app.require_subcommand(1);
  define_compile(app, options);
  define_run(app, options);
  define_check(app, options);
  define_translate(app, options);
  define_export(app, options);
  define_client_commands(app, options);
  define_device(app, options);
  define_view(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kUsage;
  }
  return std::nullopt;
}

}  // namespace rung::cli
