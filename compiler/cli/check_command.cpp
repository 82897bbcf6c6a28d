// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/input.hpp"
#include "reference/run.hpp"
#include "source/text_file.hpp"
#include "trace/compare.hpp"

namespace rung::cli {
namespace {

// The last instruction that wrote the device in this scan, for the message.
std::string writer_of(const tb::Machine& machine, const std::string& device) {
  const auto& writes = machine.writes();
  for (auto write = writes.rbegin(); write != writes.rend(); ++write) {
    if (machine.image().devices[write->device].name != device) continue;
    return "  processor: " + machine.describe(write->step, write->slot) + "\n";
  }
  return {};
}

// Runs one scan a golden scan with `next`; kDifferent at the first difference.
template <typename Next, typename Explain>
int compare(const Options& options, const Trace& golden, const Stimulus& stimulus, bool clocks,
            Next&& next, Explain&& explain) {
  TraceComparison comparison(clocks);
  for (std::size_t k = 0; k < golden.scans.size(); ++k) {
    const auto difference = comparison.next(golden.scans[k], next(stimulus.events(k)));
    if (!difference) continue;
    fmt::print(stderr, "{}:{}:1: {}\n{}  replay: rung check {} --golden {}{}{}{} --config {}\n",
               options.golden, golden.scans[k].line, describe(*difference),
               explain(difference->device), options.program, options.golden,
               options.mpu.empty() ? "" : " --mpu " + options.mpu, options.paper ? " --paper" : "",
               options.stimulus.empty() ? "" : " --stimulus " + options.stimulus, options.config);
    return kDifferent;
  }
  return kDone;
}

}  // namespace

int check_command(const Options& options) {
  const auto asked_tick = tick_of(options);
  Diagnostics diagnostics;
  const auto bytes = read_bytes(options.golden, diagnostics);
  if (!bytes) return report(diagnostics);
  const auto golden = read_trace(*bytes, options.golden, diagnostics);
  if (!golden) return report(diagnostics);
  auto input = read_input(options, true, find_dialect(golden->header.dialect), diagnostics);
  if (!input) return report(diagnostics);
  const auto stimulus = options.stimulus.empty()
                            ? stimulus_of(*golden, input->dialect, options.golden, diagnostics)
                            : read_stimulus(options.stimulus, input->dialect, diagnostics);
  if (!stimulus) return report(diagnostics);

  const std::int64_t tick_us = asked_tick.value_or(golden->header.tick_us);
  int code = kDone;
  std::string what = "the reference";
  if (!input->image && mpu_of(options) == 0) {
    ReferenceRun run(*input->program, true, tick_us);
    code = compare(
        options, *golden, *stimulus, false, [&](auto events) { return run.scan(events); },
        [](const std::string&) { return std::string(); });
  } else {
    if (!input->image) {
      auto compiled = compile_input(*input->program, options, diagnostics);
      if (!compiled) return report(diagnostics);
      input->image = std::move(compiled->image);
    }
    const auto target = make_target(std::move(*input->image), tick_us);
    const int mpu = static_cast<int>(target->image.mpu);
    what = fmt::format("MPU{}", mpu);
    tb::MachineRun run(*target->machine, true);
    code = compare(
        options, *golden, *stimulus, golden->header.mpu == mpu,
        [&](auto events) { return run.scan(events); },
        [&](const std::string& device) { return writer_of(*target->machine, device); });
  }
  if (code != kDone) return code;
  fmt::print("{}: {} scans on {}, as in {}\n", options.program, golden->scans.size(), what,
             options.golden);
  return report(diagnostics);
}

}  // namespace rung::cli
