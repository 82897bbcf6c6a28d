// SPDX-License-Identifier: Apache-2.0
#include "golden/golden.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "driver/compile.hpp"
#include "ldmicro/ldmicro.hpp"
#include "melsec/melsec.hpp"
#include "melsec/paper.hpp"
#include "trace/compare.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;

// What a reader or the compiler gives, or its first complaint as an exception.
template <typename T>
T need(std::optional<T> value, const Diagnostics& diagnostics, const std::string& name) {
  if (value) return std::move(*value);
  throw std::runtime_error(
      name + ": " + (diagnostics.all().empty() ? "nothing" : diagnostics.all().front().what));
}

std::optional<Program> read_program(const std::string& source, Dialect dialect,
                                    Diagnostics& diagnostics) {
  const auto bytes = read_bytes(source, diagnostics);
  if (!bytes) return std::nullopt;
  const bool ld = dialect == Dialect::Ldmicro;
  const auto text =
      ld ? decode_ldmicro(*bytes, source, diagnostics) : decode_text(*bytes, source, diagnostics);
  if (!text) return std::nullopt;
  return ld ? parse_ldmicro(*text, diagnostics) : parse_melsec(*text, dialect, diagnostics);
}

}  // namespace

std::vector<std::string> golden_names() {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(RUNG_GOLDEN_PROGRAMS)) {
    if (entry.path().extension() == ".golden") found.push_back(entry.path().stem().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

GoldenProgram::GoldenProgram(const std::string& name) : name_(name) {
  const fs::path path = fs::path(RUNG_GOLDEN_PROGRAMS) / name;
  Diagnostics diagnostics;
  const auto bytes = need(read_bytes(path.string() + ".golden", diagnostics), diagnostics, name);
  golden_ = need(read_trace(bytes, name, diagnostics), diagnostics, name);
  dialect_ = find_dialect(golden_.header.dialect).value_or(Dialect::Fx);
  // The program stands beside it, as a list, as an export or as LDmicro writes it.
  for (const char* suffix : {".il", ".csv", ".ld"}) {
    if (fs::exists(path.string() + suffix)) source_ = path.string() + suffix;
  }
  program_ = need(read_program(source_, dialect_, diagnostics), diagnostics, name);
  stimulus_ = need(stimulus_of(golden_, program_, name, diagnostics), diagnostics, name);
}

bool GoldenProgram::in_table_4() const {
  Diagnostics diagnostics;
  return dialect_ == Dialect::Paper && check_paper(program_, diagnostics);
}

std::optional<image::Image> GoldenProgram::compile(isa::Mpu mpu, bool paper,
                                                   const isa::Config& config) const {
  CompileOptions options;
  options.mpu = mpu;
  options.paper = paper;
  options.config = &config;
  Diagnostics diagnostics;
  auto compiled = rung::compile(program_, options, diagnostics);
  if (!compiled && program_.instructions.size() > 40) return std::nullopt;
  return need(std::move(compiled), diagnostics, name_).image;
}

image::Image GoldenProgram::compile_wide(int slots, bool merge) const {
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu4;
  options.slots = slots;
  options.merge = merge;
  options.search.tries = 4;
  Diagnostics diagnostics;
  return need(rung::compile(program_, options, diagnostics), diagnostics, name_).image;
}

std::optional<std::string> GoldenProgram::difference(const image::Image& image,
                                                     AnyMachine& machine) const {
  const auto found = [&](const std::string& what) {
    const std::string processor = image.wide ? fmt::format("4 --slots {}", image.wide->slots)
                                             : fmt::format("{}", static_cast<int>(image.mpu));
    return fmt::format(
        "{}, MPU{}, {}: {}; replay: build/bin/rung check {} --golden "
        "tb/golden/programs/{}.golden --mpu {} --config {}{}{}",
        name_, static_cast<int>(image.mpu), image.config, what, source_, name_, processor,
        image.config, image.paper ? " --paper" : "",
        image.wide && !image.wide->merged ? " --no-merge" : "");
  };
  MachineRun engine(machine, true);
  TraceComparison comparison(false, engine.header().merged);
  for (std::size_t k = 0; k < golden_.scans.size(); ++k) {
    const TraceScan got = engine.scan(stimulus_.events(k));
    const auto difference = comparison.next(golden_.scans[k], got);
    if (difference) return found(describe(*difference));
    if (got.clocks != image.clocks) {
      return found(
          fmt::format("scan {}: {} clocks instead of {}", k, got.clocks.value_or(0), image.clocks));
    }
  }
  return std::nullopt;
}

}  // namespace rung::tb
