// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/bound.hpp"
#include "image/image_file.hpp"
#include "load/flow_bound.hpp"
#include "load/load_file.hpp"
#include "prove/prove.hpp"
#include "rung_controller.hpp"
#include "source/text_file.hpp"

namespace rung::cli {
namespace {

nlohmann::ordered_json to_json(const Bound& bound) {
  const load::Timing& t = bound.timing;
  return {{"board", bound.bindings.board->name},
          {"clock_hz", t.clock_hz},
          {"latch_clocks", t.latch},
          {"scan_clocks", t.scan},
          {"refresh_clocks", t.refresh},
          {"exchange_clocks", t.exchange},
          {"cycle_clocks", t.cycle},
          {"period_clocks", t.period},
          {"edge_to_edge_least_clocks", t.best},
          {"edge_to_edge_most_clocks", t.worst}};
}

// With what surrounds a round, where a map has said it.
load::FlowBound flow_bound_of(const image::Image& image, const std::optional<Bound>& bound) {
  return load::flow_bound(image, bound ? load::phases_of(bound->timing, image) : load::Phases{});
}

nlohmann::ordered_json to_json(const prove::Proof& proof) {
  nlohmann::ordered_json open = nlohmann::ordered_json::array();
  for (const prove::Finding& finding : proof.findings) {
    if (!finding.wrong) open.push_back(finding.what);
  }
  return {{"writes", proof.writes},
          {"proven", proof.proven},
          {"wrong", proof.wrong()},
          {"not_proven", open},
          {"by_structure", proof.effort.structure},
          {"by_solver", proof.effort.solver},
          {"terms", proof.terms},
          {"seconds", proof.seconds}};
}

nlohmann::ordered_json to_json(const image::WideImage& wide) {
  const image::WideReport& r = wide.report;
  return {{"slots", wide.slots},           {"merged", wide.merged},
          {"latch_rows", wide.latch_rows}, {"bit_instructions", r.look_ups},
          {"word_instructions", r.words},  {"divisions", r.divisions},
          {"captures", r.captures},        {"near_values", r.near_values},
          {"by_look_ups", r.by_look_ups},  {"by_words", r.by_words},
          {"by_dividers", r.by_dividers},  {"by_dependence", r.by_dependence},
          {"binding", r.binding}};
}

std::string to_json(const Compiled& compiled, const std::optional<Bound>& bound,
                    const std::optional<prove::Proof>& proof, const Options& options) {
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
  out["steps"] = image.length();
  out["clocks"] = image.clocks;
  out["lut_rows"] = s.lut_rows;
  out["bit_devices"] = s.bit_devices;
  out["word_devices"] = s.word_devices;
  if (image.wide) out["wide"] = to_json(*image.wide);
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
  if (bound) out["controller"] = to_json(*bound);
  if (proof) out["proof"] = to_json(*proof);
  if (image.flow) {
    out["flow"] = load::to_json(flow_bound_of(image, bound), *image.flow, clock_of(options, image));
  }
  return out.dump() + "\n";
}

// What is made with the I/O map: false, with errors, if it is refused.
bool write_load_file(const Compiled& compiled, const Bound& bound, const Options& options,
                     Diagnostics& diagnostics) {
  const auto words = load::make(compiled.image, bound.bindings, bound.timing.clock_hz, diagnostics);
  return words && (options.load_file.empty() ||
                   write_file(options.load_file, load::to_bytes(*words), diagnostics));
}

// Of a program with flow tasks the bound too.
std::string flow_summary(const image::Image& image, const std::optional<Bound>& bound,
                         const Options& options) {
  return fmt::format(
      "{}: {} tasks of {} steps, {} instructions in {} rungs; MPU{}: {} instruction steps, {} of "
      "them the ladder's\n{}",
      image.program, image.flow->tasks.size(), image.flow->steps.size(),
      image.statistics.instructions, image.statistics.rungs, static_cast<int>(image.mpu),
      image.steps.size(), image.flow->ladder_steps,
      load::to_string(flow_bound_of(image, bound), *image.flow, clock_of(options, image)));
}

// "92 steps of 8 slots and 4 word units; 660 of 736 bit and 357 of 368 word places used; at least
// 90 steps (word units)"
std::string to_string(const image::WideImage& wide) {
  const image::WideReport& r = wide.report;
  const auto steps = static_cast<int>(wide.code.size());
  return fmt::format(
      "{} steps of {} slots and {} word units; {} of {} bit and {} of {} word places used, {} "
      "operands from other lanes; at least {} steps ({})\n",
      steps, wide.slots, wide.slots / 2, r.look_ups, steps * wide.slots, r.words,
      steps * wide.slots / 2, r.captures,
      std::max({r.by_look_ups, r.by_words, r.by_dividers, r.by_dependence}), r.binding);
}

std::string summary(const Compiled& compiled) {
  const image::Image& image = compiled.image;
  std::string text = fmt::format("{}: {} instructions in {} rungs; MPU{}: {} clocks a scan, ",
                                 image.program, image.statistics.instructions,
                                 image.statistics.rungs, static_cast<int>(image.mpu), image.clocks);
  if (image.wide) return text + to_string(*image.wide);
  return text +
         (compiled.schedule ? schedule::to_string(*compiled.schedule)
                            : fmt::format("{} steps", image.steps.size())) +
         "\n";
}

}  // namespace

int compile_command(const Options& given) {
  Options options = given;
  Diagnostics diagnostics;
  const auto map = read_io(options, diagnostics);
  if (is_flow_file(options.program) && !options.dump.empty()) {
    throw UsageError("--dump is for lists and LDmicro programs; this is a flow program");
  }
  const auto input = read_input(options, false, std::nullopt, diagnostics);
  if (!input || (diagnostics.has_errors() && !map)) return report(diagnostics);
  if (!options.dump.empty()) {
    CompileOptions how;
    how.paper = options.paper;
    const Dumps dumps = dump_passes(*input->program, how);
    fmt::print("{}", options.dump == "logic" ? dumps.logic : dumps.mapping);
    return report(diagnostics);
  }
  const auto compiled = compile_input(*input, options, diagnostics);
  if (!compiled) return report(diagnostics);
  std::optional<prove::Proof> proof;
  if (options.prove) {
    proof = prove::prove(compiled->image, compiled->meanings);
    prove::report(*proof, compiled->image, compiled->meanings, diagnostics);
    // Nothing is written of what is not proven; the numbers still are.
    if (!proof->holds()) {
      fmt::print("{}", options.json ? to_json(*compiled, std::nullopt, proof, options)
                                    : prove::to_string(*proof));
      return report(diagnostics);
    }
  }
  std::optional<Bound> bound;
  if (map || options.bindings || !options.load_file.empty()) {
    bound = bind_image(compiled->image, map, options, diagnostics);
    if (diagnostics.has_errors() || !write_load_file(*compiled, *bound, options, diagnostics)) {
      return report(diagnostics);
    }
  }
  if (!options.output.empty() &&
      !write_file(options.output, image::to_bytes(compiled->image), diagnostics)) {
    return report(diagnostics);
  }
  if (options.json) {
    fmt::print("{}", to_json(*compiled, bound, proof, options));
  } else if (options.listing) {
    fmt::print("{}", image::listing(compiled->image));
  } else if (options.bindings) {
    fmt::print("{}", io::table(bound->bindings, bound->subject));
  } else if (options.output != "-" && options.load_file != "-") {
    fmt::print(
        "{}{}{}",
        compiled->image.flow ? flow_summary(compiled->image, bound, options) : summary(*compiled),
        map ? load::to_string(bound->timing) : "", proof ? prove::to_string(*proof) : "");
  }
  return report(diagnostics);
}

}  // namespace rung::cli
