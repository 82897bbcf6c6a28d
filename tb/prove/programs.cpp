// SPDX-License-Identifier: Apache-2.0
#include "prove/programs.hpp"

#include <algorithm>
#include <filesystem>

#include "ldmicro/ldmicro.hpp"
#include "melsec/list.hpp"
#include "melsec/melsec.hpp"
#include "programs/random_ldmicro.hpp"
#include "programs/random_melsec.hpp"
#include "programs/random_program.hpp"
#include "source/text_file.hpp"

namespace rung::tb {

namespace fs = std::filesystem;

std::optional<Program> read_program(const std::string& file) {
  Diagnostics diagnostics;
  const auto bytes = read_bytes(file, diagnostics);
  if (!bytes) return std::nullopt;
  const bool ld = fs::path(file).extension() == ".ld";
  const auto text =
      ld ? decode_ldmicro(*bytes, file, diagnostics) : decode_text(*bytes, file, diagnostics);
  if (!text) return std::nullopt;
  return ld ? parse_ldmicro(*text, diagnostics) : parse_melsec(*text, std::nullopt, diagnostics);
}

std::vector<std::string> program_files(const std::string& folder) {
  std::vector<std::string> found;
  if (!fs::is_directory(folder)) return found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string suffix = entry.path().extension().string();
    for (const char* ours : {".il", ".csv", ".ld", ".lst", ".esc", ".txt"}) {
      if (suffix == ours) found.push_back(entry.path().string());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

namespace {

Program parse_all(const std::string& text, Dialect dialect) {
  Diagnostics diagnostics;
  const bool ld = dialect == Dialect::Ldmicro;
  const auto source =
      ld ? decode_ldmicro(text, "random", diagnostics) : decode_text(text, "random", diagnostics);
  auto program = !source ? std::nullopt
                 : ld    ? parse_ldmicro(*source, diagnostics)
                         : parse_list(*source, dialect, diagnostics);
  if (program) return std::move(*program);
  std::ostringstream errors;
  diagnostics.print(errors);
  throw std::runtime_error(errors.str() + text);
}

}  // namespace

Program random_case(std::uint64_t seed) {
  switch (seed % 4) {
    case 2:
      return parse_all(random_ldmicro(seed, ldmicro_options(seed)), Dialect::Ldmicro);
    case 3:
      return parse_all(random_program(seed, paper_options()), Dialect::Paper);
    default: {
      const RandomMelsecOptions options = melsec_options(seed);
      return parse_all(random_melsec(seed, options), options.dialect);
    }
  }
}

std::optional<Compiled> compiled_for(const Program& program, isa::Mpu mpu, bool paper, bool small) {
  CompileOptions options;
  options.mpu = mpu;
  options.paper = paper;
  options.config = isa::find_config(small ? "hx8k" : "ecp5");
  options.search.tries = 4;
  Diagnostics diagnostics;
  return compile(program, options, diagnostics);
}

std::optional<Compiled> compiled_wide(const Program& program, int slots, bool merge) {
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu4;
  options.slots = slots;
  options.merge = merge;
  options.search.tries = 4;
  Diagnostics diagnostics;
  return compile(program, options, diagnostics);
}

}  // namespace rung::tb
