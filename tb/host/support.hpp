// SPDX-License-Identifier: Apache-2.0
// What the tests of I/O maps and load files share.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>

#include "driver/compile.hpp"
#include "io/bind.hpp"
#include "ldmicro/ldmicro.hpp"
#include "load/load_file.hpp"
#include "melsec/melsec.hpp"
#include "rung_controller.hpp"
#include "source/text_file.hpp"

namespace rung::tb {

inline std::string printed(const Diagnostics& diagnostics) {
  std::ostringstream out;
  diagnostics.print(out);
  return out.str();
}

// A program that must be good.
inline Program program_of(const std::string& text, const std::string& file = "t.il",
                          std::optional<Dialect> dialect = std::nullopt) {
  Diagnostics diagnostics;
  std::optional<Program> program;
  if (file.ends_with(".ld")) {
    if (const auto source = decode_ldmicro(text, file, diagnostics)) {
      program = parse_ldmicro(*source, diagnostics);
    }
  } else if (const auto source = decode_text(text, file, diagnostics)) {
    program = parse_melsec(*source, dialect, diagnostics);
  }
  if (!program) throw std::runtime_error(printed(diagnostics) + text);
  return std::move(*program);
}

inline image::Image image_of(const Program& program, int mpu = 3, const char* config = "ecp5") {
  CompileOptions options;
  options.mpu = static_cast<isa::Mpu>(mpu);
  options.config = isa::find_config(config);
  Diagnostics diagnostics;
  auto compiled = compile(program, options, diagnostics);
  if (!compiled) throw std::runtime_error(printed(diagnostics));
  return std::move(compiled->image);
}

}  // namespace rung::tb
