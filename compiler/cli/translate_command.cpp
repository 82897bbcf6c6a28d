// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include "backends/c_writer.hpp"
#include "backends/ld_writer.hpp"
#include "backends/list_writer.hpp"
#include "bytecode/listing.hpp"
#include "bytecode/writer.hpp"
#include "cli/bound.hpp"
#include "hardwired/verilog.hpp"
#include "lower/lower.hpp"
#include "source/text_file.hpp"

namespace rung::cli {
namespace {

std::optional<std::string> to_bytecode(const Program& program, const Options& options,
                                       Diagnostics& diagnostics) {
  auto file = bytecode::write(program, lower::lower(program), {}, diagnostics);
  return file && options.listing ? bytecode::listing(*file) : std::move(file);
}

std::optional<std::string> to_verilog(const Program& program, const Options& options,
                                      Diagnostics& diagnostics) {
  hardwired::Options how;
  if (!options.path_ns.empty()) how.step_ns = std::stod(options.path_ns);
  const auto module = hardwired::to_verilog(program, how, diagnostics);
  return module ? std::optional(module->text) : std::nullopt;
}

// Bytes are not for a terminal, and a listing there is only of byte code.
void check_usage(const Options& options) {
  const bool bytecode = options.target == "bytecode";
  if (!options.path_ns.empty() && options.target != "verilog") {
    throw UsageError("--path-ns is for --to verilog");
  }
  if (options.listing && !bytecode) throw UsageError("--listing is for --to bytecode");
  const bool to_output = options.output.empty() || options.output == "-";
  if (bytecode && !options.listing && to_output && isatty(STDOUT_FILENO) != 0) {
    throw UsageError("byte code is no text for a terminal: give it a file with -o, or --listing");
  }
}

std::optional<std::string> translate(const Program& program, const Options& options,
                                     Diagnostics& diagnostics) {
  const bool is_ld = program.dialect == Dialect::Ldmicro;
  if (options.target == "c") return to_c(program);
  if (options.target == "bytecode") return to_bytecode(program, options, diagnostics);
  if (options.target == "verilog") return to_verilog(program, options, diagnostics);
  if (options.target == "ld" && is_ld) return to_ld(program, diagnostics);
  if (options.target == "il" && !is_ld) return to_list(program);
  diagnostics.error(
      options.program, {},
      is_ld ? "an LDmicro program cannot be written as an instruction list: lists "
              "lack elements that it has"
            : "an instruction list cannot be written as an LDmicro program: LDmicro "
              "lacks instructions that lists have",
      "translate it to c, bytecode or verilog, or to " + std::string(is_ld ? "ld" : "il"));
  return std::nullopt;
}

}  // namespace

int translate_command(const Options& given) {
  Options options = given;
  check_usage(options);
  Diagnostics diagnostics;
  if (is_flow_file(options.program)) {
    diagnostics.error(options.program, {},
                      "flow tasks cannot be written in another form: none has steps that wait",
                      "compile the program for a controller: rung compile; its ladder is a list of "
                      "its own that can be translated");
    return report(diagnostics);
  }
  const auto map = read_io(options, diagnostics);
  auto input = read_input(options, false, std::nullopt, diagnostics);
  if (!input) return report(diagnostics);
  check_io(*input, map, options, diagnostics);
  if (diagnostics.has_errors()) return report(diagnostics);
  const auto& program = input->program;
  const auto text = translate(*program, options, diagnostics);
  if (text) write_file(options.output.empty() ? "-" : options.output, *text, diagnostics);
  return report(diagnostics);
}

}  // namespace rung::cli
