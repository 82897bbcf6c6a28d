// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>

#include "cli/bound.hpp"
#include "lockstep/lockstep.hpp"
#include "reference/flow_run.hpp"
#include "reference/run.hpp"
#include "source/text_file.hpp"

namespace rung::cli {
namespace {

// What the scans of a run are given, and what comes out.
struct Session {
  Stimulus stimulus;
  std::uint64_t scans = 1;
  std::int64_t tick_us = 10000;
  Trace trace;
  bool keep = false;  // the trace is wanted
};

void keep(Session& session, TraceScan scan) {
  if (session.keep) session.trace.scans.push_back(std::move(scan));
}

void run_reference(const Program& program, bool state, Session& session) {
  ReferenceRun run(program, state, session.tick_us);
  session.trace.header = run.header();
  for (std::uint64_t k = 0; k < session.scans; ++k) {
    keep(session, run.scan(session.stimulus.events(k)));
  }
}

// Rounds, of which each is a scan; gives what to say of them.
std::string run_rounds(const flowchart::Flowchart& chart, const Options& options,
                       Session& session) {
  FlowRun run(chart, options.state, session.tick_us, std::string(config_of(options).name));
  session.trace.header = run.header();
  for (std::uint64_t k = 0; k < session.scans; ++k) {
    keep(session, run.scan(session.stimulus.events(k)));
  }
  const int lost = run.without_answer();
  return "rounds on the reference" +
         (lost == 0 ? "" : fmt::format("; transfers over links without an answer: {}", lost));
}

// An image has no source to compare with: the processor alone.
void run_image(tb::AnyMachine& machine, bool state, Session& session) {
  tb::MachineRun run(machine, state);
  session.trace.header = run.header();
  for (std::uint64_t k = 0; k < session.scans; ++k) {
    keep(session, run.scan(session.stimulus.events(k)));
  }
}

std::string replay_command(const Options& options, std::int64_t scan) {
  std::string command =
      fmt::format("rung run {} --mpu {} --config {} --scans {}", options.program,
                  options.mpu.empty() ? std::to_string(options.default_mpu) : options.mpu,
                  config_of(options).name, scan + 1);
  if (!options.dialect.empty()) command += " --dialect " + options.dialect;
  if (options.paper) command += " --paper";
  if (!options.stimulus.empty()) command += " --stimulus " + options.stimulus;
  if (!options.tick.empty()) command += " --tick " + options.tick;
  command += wide_options(options);
  return command;
}

// The processor with the reference beside it, to the first difference.
int run_lockstep(const Program& program, tb::AnyMachine& machine, const Options& options,
                 Session& session) {
  tb::Lockstep lockstep(program, machine);
  tb::MachineRun run(machine, options.state);
  session.trace.header = run.header();
  for (std::uint64_t k = 0; k < session.scans; ++k) {
    const auto events = session.stimulus.events(k);
    auto difference = lockstep.scan(events);
    if (!difference) difference = lockstep.compare_state();
    if (difference) {
      fmt::print(stderr, "{}: processor and reference differ\n{}  replay: {}\n", options.program,
                 tb::describe(*difference), replay_command(options, difference->scan));
      return kDifferent;
    }
    if (session.keep) keep(session, run.record(events, lockstep.result()));
  }
  return kDone;
}

bool read_session(const Options& options, const Input& input, Session& session,
                  Diagnostics& diagnostics) {
  session.tick_us = tick_of(options, input).value_or(10000);
  session.keep = !options.trace.empty();
  if (!options.stimulus.empty()) {
    auto stimulus = read_stimulus(options.stimulus, names_of(input), diagnostics);
    if (!stimulus) return false;
    session.stimulus = std::move(*stimulus);
    session.scans = session.stimulus.scans();
  }
  if (options.scans) session.scans = *options.scans;
  return true;
}

}  // namespace

int run_command(const Options& given) {
  Options options = given;
  const auto mpu = mpu_of(options);
  if (is_flow_file(options.program) && mpu != 0) {
    throw UsageError(
        "flow tasks run in rounds, which a processor alone does not make: --mpu reference runs "
        "them "
        "here, a controller after rung load");
  }
  Diagnostics diagnostics;
  const auto map = read_io(options, diagnostics);
  Session session;
  auto input = read_input(options, true, std::nullopt, diagnostics);
  if (!input || !read_session(options, *input, session, diagnostics)) {
    return report(diagnostics);
  }
  refuse_flow_image(*input);
  check_io(*input, map, options, diagnostics);
  if (diagnostics.has_errors()) return report(diagnostics);

  std::string what;
  if (input->image) {
    const auto target = make_target(std::move(*input->image), session.tick_us);
    run_image(target->machine(), options.state, session);
    what = fmt::format("{} clocks each", target->image.clocks);
  } else if (input->flow) {
    what = run_rounds(*input->flow, options, session);
  } else if (mpu == 0) {
    run_reference(*input->program, options.state, session);
    what = "on the reference";
  } else {
    auto compiled = compile_input(*input, options, diagnostics);
    if (!compiled) return report(diagnostics);
    const auto target = make_target(std::move(compiled->image), session.tick_us);
    const int code = run_lockstep(*input->program, target->machine(), options, session);
    if (code != kDone) return code;
    what = fmt::format("{} clocks each, equal to the reference", target->image.clocks);
  }
  if (session.keep && !write_file(options.trace, to_json_lines(session.trace), diagnostics)) {
    return report(diagnostics);
  }
  if (options.trace != "-") fmt::print("{}: {} scans, {}\n", options.program, session.scans, what);
  return report(diagnostics);
}

}  // namespace rung::cli
