// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/bound.hpp"
#include "reference/run.hpp"
#include "source/text_file.hpp"
#include "trace/compare.hpp"
#include "trace/ldmicro_trace.hpp"

namespace rung::cli {
namespace {

// The last instruction that wrote the device in this scan, for the message.
std::string writer_of(const tb::AnyMachine& machine, const std::string& device) {
  const auto& writes = machine.writes();
  for (auto write = writes.rbegin(); write != writes.rend(); ++write) {
    if (machine.image().devices[write->device].name != device) continue;
    return "  processor: " + machine.describe(*write) + "\n";
  }
  return {};
}

std::string name_of(const image::Image& image) {
  std::string name = fmt::format("MPU{}", static_cast<int>(image.mpu));
  if (image.wide) name += fmt::format(" with {} slots", image.wide->slots);
  if (image.wide && image.wide->merged) name += ", by the values after each scan";
  return name;
}

// What the run must give: a golden trace of ours, or one of LDmicro's simulator.
struct Golden {
  TraceHeader header;  // of a trace of ours
  std::vector<TraceScan> scans;
  bool ldmicro = false;
  std::optional<LdmicroTrace::Stop> stop = {};
};

std::optional<Golden> read_golden(const Options& options, Diagnostics& diagnostics) {
  const auto bytes = read_bytes(options.golden, diagnostics);
  if (!bytes) return std::nullopt;
  if (!is_ldmicro_trace(*bytes)) {
    auto trace = read_trace(*bytes, options.golden, diagnostics);
    if (!trace) return std::nullopt;
    return Golden{std::move(trace->header), std::move(trace->scans)};
  }
  if (options.stimulus.empty()) {
    throw UsageError("a trace of LDmicro does not say what its program was given: --stimulus");
  }
  auto trace = read_ldmicro_trace(*bytes, options.golden, diagnostics);
  if (!trace) return std::nullopt;
  return Golden{{}, std::move(trace->scans), true, std::move(trace->stop)};
}

// Runs one scan a golden scan with `next`; kDifferent at the first difference.
template <typename Next, typename Explain>
int compare(const Options& options, const Golden& golden, const Stimulus& stimulus,
            const TraceHeader& engine, Next&& next, Explain&& explain) {
  TraceComparison comparison(golden.header.same_processor(engine),
                             golden.header.merged || engine.merged);
  for (std::size_t k = 0; k < golden.scans.size(); ++k) {
    const TraceScan& expected = golden.scans[k];
    const TraceScan got = next(stimulus.events(k));
    const auto difference =
        golden.ldmicro ? compare_shown(expected, got) : comparison.next(expected, got);
    if (!difference) continue;
    fmt::print(stderr, "{}:{}:1: {}\n{}  replay: rung check {} --golden {}{}{}{}{} --config {}\n",
               options.golden, expected.line, describe(*difference), explain(difference->device),
               options.program, options.golden, options.mpu.empty() ? "" : " --mpu " + options.mpu,
               options.paper ? " --paper" : "",
               options.stimulus.empty() ? "" : " --stimulus " + options.stimulus,
               wide_options(options), config_of(options).name);
    return kDifferent;
  }
  return kDone;
}

}  // namespace

int check_command(const Options& given) {
  Options options = given;
  Diagnostics diagnostics;
  if (is_flow_file(options.program)) {
    diagnostics.error(options.program, {}, "golden traces of flow programs are not compared",
                      "write the program's trace and compare the two files: rung run PROGRAM.flow "
                      "--mpu reference --trace FILE");
    return report(diagnostics);
  }
  const auto map = read_io(options, diagnostics);
  const auto golden = read_golden(options, diagnostics);
  if (!golden) return report(diagnostics);
  const auto dialect = find_dialect(golden->header.dialect);
  auto input = read_input(options, true, dialect, diagnostics);
  if (!input) return report(diagnostics);
  refuse_flow_image(*input);
  check_io(*input, map, options, diagnostics);
  if (diagnostics.has_errors()) return report(diagnostics);
  const auto asked_tick = tick_of(options, *input);
  const DeviceNames names = names_of(*input);
  const auto stimulus =
      options.stimulus.empty()
          ? stimulus_of({golden->header, golden->scans}, names, options.golden, diagnostics)
          : read_stimulus(options.stimulus, names, diagnostics);
  if (!stimulus) return report(diagnostics);

  const std::int64_t tick_us = asked_tick.value_or(golden->header.tick_us);
  int code = kDone;
  std::string what = "the reference";
  if (!input->image && mpu_of(options) == 0) {
    ReferenceRun run(*input->program, true, tick_us);
    code = compare(
        options, *golden, *stimulus, run.header(), [&](auto events) { return run.scan(events); },
        [](const std::string&) { return std::string(); });
  } else {
    if (!input->image) {
      auto compiled = compile_input(*input, options, diagnostics);
      if (!compiled) return report(diagnostics);
      input->image = std::move(compiled->image);
    }
    const auto target = make_target(std::move(*input->image), tick_us);
    what = name_of(target->image);
    tb::MachineRun run(target->machine(), true);
    code = compare(
        options, *golden, *stimulus, run.header(), [&](auto events) { return run.scan(events); },
        [&](const std::string& device) { return writer_of(target->machine(), device); });
  }
  if (code != kDone) return code;
  if (golden->stop) {
    diagnostics.note(options.golden, {golden->stop->line, 1},
                     fmt::format("LDmicro's simulator stopped here ({}): nothing behind it is "
                                 "compared",
                                 golden->stop->what));
  }
  fmt::print("{}: {} scans on {}, as in {}\n", options.program, golden->scans.size(), what,
             options.golden);
  return report(diagnostics);
}

}  // namespace rung::cli
