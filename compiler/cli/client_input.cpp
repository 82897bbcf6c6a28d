// SPDX-License-Identifier: Apache-2.0
#include "cli/client_input.hpp"

#include "load/load_file.hpp"

namespace rung::cli {

client::LineOptions line_of(const Options& options, const std::optional<io::Map>& map) {
  const io::Settings settings = map ? map->settings : io::Settings{};
  const std::string parity = !options.parity.empty()               ? options.parity
                             : settings.parity == io::Parity::None ? "none"
                             : settings.parity == io::Parity::Odd  ? "odd"
                                                                   : "even";
  client::LineOptions line;
  line.port = options.port;
  line.baud = options.baud.value_or(settings.baud);
  line.parity = parity == "none" ? 'N' : parity == "odd" ? 'O' : 'E';
  line.unit = options.unit.value_or(settings.unit);
  line.timeout_ms = options.timeout_ms;
  return line;
}

int with_controller(const Options& options, Diagnostics& diagnostics,
                    const std::function<int()>& talk) {
  int code = kDone;
  try {
    code = talk();
  } catch (const client::ClientError& error) {
    std::string what = error.what();
    // The port is the message's place already.
    if (what.starts_with(options.port + ": ")) what = what.substr(options.port.size() + 2);
    diagnostics.error(options.port, {}, std::move(what), error.mend);
  }
  const int reported = report(diagnostics);
  return reported == kDone ? code : reported;
}

std::optional<io::Subject> names_for(const Options& options, const std::string& program,
                                     Diagnostics& diagnostics) {
  if (program.empty()) {
    io::Subject subject;
    subject.dialect = dialect_of(options).value_or(Dialect::Fx);
    return subject;
  }
  Options of_program = options;
  of_program.program = program;
  const auto map = read_io(of_program, diagnostics);
  const auto input = read_input(of_program, true, std::nullopt, diagnostics);
  if (!input || diagnostics.has_errors()) return std::nullopt;
  check_io(*input, map, of_program, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return subject_of(*input, of_program);
}

}  // namespace rung::cli
