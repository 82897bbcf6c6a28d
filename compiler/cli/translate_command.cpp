// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "backends/c_writer.hpp"
#include "backends/ld_writer.hpp"
#include "backends/list_writer.hpp"
#include "cli/input.hpp"
#include "source/text_file.hpp"

namespace rung::cli {
namespace {

std::optional<std::string> translate(const Program& program, const Options& options,
                                     Diagnostics& diagnostics) {
  const bool is_ld = program.dialect == Dialect::Ldmicro;
  if (options.target == "c") return to_c(program);
  if (options.target == "ld" && is_ld) return to_ld(program, diagnostics);
  if (options.target == "il" && !is_ld) return to_list(program);
  diagnostics.error(options.program, {},
                    is_ld ? "an LDmicro program cannot be written as an instruction list: lists "
                            "lack elements that it has"
                          : "an instruction list cannot be written as an LDmicro program: LDmicro "
                            "lacks instructions that lists have",
                    "translate it to c, or to " + std::string(is_ld ? "ld" : "il"));
  return std::nullopt;
}

}  // namespace

int translate_command(const Options& options) {
  Diagnostics diagnostics;
  const auto program = read_program(options, diagnostics);
  if (!program) return report(diagnostics);
  const auto text = translate(*program, options, diagnostics);
  if (text) write_file(options.output.empty() ? "-" : options.output, *text, diagnostics);
  return report(diagnostics);
}

}  // namespace rung::cli
