// SPDX-License-Identifier: Apache-2.0
#include "reliability/program.hpp"

#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "driver/compile.hpp"
#include "ldmicro/ldmicro.hpp"
#include "load/load_file.hpp"
#include "melsec/melsec.hpp"
#include "source/text_file.hpp"

namespace rung::tb {
namespace {

[[noreturn]] void fail(const Diagnostics& diagnostics) {
  std::ostringstream out;
  diagnostics.print(out);
  throw std::runtime_error(out.str());
}

}  // namespace

Made make_program(const std::string& list, const std::string& map_text) {
  Diagnostics diagnostics;
  std::optional<Program> program;
  if (list.starts_with("LDmicro")) {
    const auto source = decode_ldmicro(list, "test.ld", diagnostics);
    if (source) program = parse_ldmicro(*source, diagnostics);
  } else if (const auto source = decode_text(list, "test.il", diagnostics)) {
    program = parse_melsec(*source, std::nullopt, diagnostics);
  }
  const auto map = io::parse_map(map_text, "test.toml", diagnostics);
  if (!program || !map) fail(diagnostics);
  CompileOptions options;
  options.mpu = static_cast<isa::Mpu>(map->board->mpu);
  options.config = isa::find_config(map->board->config);
  auto compiled = compile(*program, options, diagnostics);
  if (!compiled) fail(diagnostics);
  Made made;
  made.image = std::move(compiled->image);
  made.bindings = io::bind(*map, load::subject_of(made.image), diagnostics);
  const auto clock_hz = static_cast<std::int64_t>(1000 * ControllerSetup{}.clocks_per_ms);
  made.timing = load::timing_of(made.image, made.bindings, clock_hz);
  const auto words = load::make(made.image, made.bindings, clock_hz, diagnostics);
  if (!words || diagnostics.has_errors()) fail(diagnostics);
  made.words = *words;
  return made;
}

}  // namespace rung::tb
