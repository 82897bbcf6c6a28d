// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/input.hpp"
#include "image/image_file.hpp"
#include "source/text_file.hpp"

namespace rung::cli {
namespace {

std::string to_json(const Compiled& compiled) {
  const image::Image& image = compiled.image;
  const image::Statistics& s = image.statistics;
  nlohmann::ordered_json out;
  out["program"] = image.program;
  out["mpu"] = static_cast<int>(image.mpu);
  out["dialect"] = image.dialect;
  out["config"] = image.config;
  out["paper"] = image.paper;
  out["rungs"] = s.rungs;
  out["instructions"] = s.instructions;
  out["contacts"] = s.contacts;
  out["runs"] = s.runs;
  if (image.dialect == dialect_name(Dialect::Ldmicro)) out["runs"] = nullptr;
  out["lookups"] = s.lookups;
  out["steps"] = image.steps.size();
  out["clocks"] = image.clocks;
  out["lut_rows"] = s.lut_rows;
  out["bit_devices"] = s.bit_devices;
  out["word_devices"] = s.word_devices;
  if (compiled.schedule) {
    const schedule::Report& r = *compiled.schedule;
    out["schedule"] = {{"slots", r.slots},
                       {"slots_used", r.operations},
                       {"holes", r.holes},
                       {"by_operations", r.by_operations},
                       {"by_dependence", r.by_dependence},
                       {"lower_bound", r.lower_bound},
                       {"above_lower_bound", r.steps - r.lower_bound}};
  }
  return out.dump() + "\n";
}

std::string summary(const Compiled& compiled) {
  const image::Image& image = compiled.image;
  std::string text = fmt::format("{}: {} instructions in {} rungs; MPU{}: {} clocks a scan, ",
                                 image.program, image.statistics.instructions,
                                 image.statistics.rungs, static_cast<int>(image.mpu), image.clocks);
  return text +
         (compiled.schedule ? schedule::to_string(*compiled.schedule)
                            : fmt::format("{} steps", image.steps.size())) +
         "\n";
}

}  // namespace

int compile_command(const Options& options) {
  Diagnostics diagnostics;
  const auto program = read_program(options, diagnostics);
  if (!program) return report(diagnostics);
  if (!options.dump.empty()) {
    CompileOptions how;
    how.paper = options.paper;
    const Dumps dumps = dump_passes(*program, how);
    fmt::print("{}", options.dump == "logic" ? dumps.logic : dumps.mapping);
    return report(diagnostics);
  }
  const auto compiled = compile_input(*program, options, diagnostics);
  if (!compiled) return report(diagnostics);
  if (!options.output.empty() &&
      !write_file(options.output, image::to_bytes(compiled->image), diagnostics)) {
    return report(diagnostics);
  }
  if (options.json) {
    fmt::print("{}", to_json(*compiled));
  } else if (options.listing) {
    fmt::print("{}", image::listing(compiled->image));
  } else if (options.output != "-") {
    fmt::print("{}", summary(*compiled));
  }
  return report(diagnostics);
}

}  // namespace rung::cli
