// SPDX-License-Identifier: Apache-2.0
// What the tests of the compiler's passes share.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "driver/compile.hpp"
#include "lower/lower.hpp"
#include "melsec/list.hpp"

namespace rung {

// A list that must parse.
inline Program parse(const std::string& text, Dialect dialect = Dialect::Fx) {
  Diagnostics diagnostics;
  const auto source = decode_text(text, "test.il", diagnostics);
  std::optional<Program> program;
  if (source) program = parse_list(*source, dialect, diagnostics);
  if (program) return std::move(*program);
  std::ostringstream errors;
  diagnostics.print(errors);
  throw std::runtime_error(errors.str() + text);
}

// The same, lowered.
inline core::Program lowered(const std::string& text, Dialect dialect = Dialect::Fx) {
  return lower::lower(parse(text, dialect));
}

inline const isa::Config& ecp5() { return *isa::find_config("ecp5"); }

inline Compiled compile_for(const Program& program, isa::Mpu mpu, bool paper = false) {
  CompileOptions options;
  options.mpu = mpu;
  options.paper = paper;
  Diagnostics diagnostics;
  auto compiled = compile(program, options, diagnostics);
  if (!compiled) throw std::runtime_error("does not fit");
  return std::move(*compiled);
}

}  // namespace rung
