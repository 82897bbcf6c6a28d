// SPDX-License-Identifier: Apache-2.0
#include "backends/c_writer.hpp"
#include "backends/list_writer.hpp"
#include "cli/input.hpp"
#include "source/text_file.hpp"

namespace rung::cli {

int translate_command(const Options& options) {
  Diagnostics diagnostics;
  const auto program = read_program(options, diagnostics);
  if (!program) return report(diagnostics);
  const std::string text = options.target == "c" ? to_c(*program) : to_list(*program);
  write_file(options.output.empty() ? "-" : options.output, text, diagnostics);
  return report(diagnostics);
}

}  // namespace rung::cli
