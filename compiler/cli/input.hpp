// SPDX-License-Identifier: Apache-2.0
// What a command works on: a program from its source, one of flow tasks too, or an image.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "cli/options.hpp"
#include "driver/compile.hpp"
#include "flowchart/flowchart.hpp"
#include "lockstep/any_machine.hpp"
#include "trace/stimulus.hpp"

namespace rung::cli {

// Prints what has been collected on standard error; the exit code that it means.
int report(const Diagnostics& diagnostics);

struct Input {
  std::optional<Program> program;
  std::optional<flowchart::Flowchart> flow;
  std::optional<image::Image> image;
  Dialect dialect = Dialect::Fx;
};

// Reads PROGRAM, or an image if `images`. `fallback` is the dialect without --dialect, before the
// program itself is asked. Nothing, with errors, when it is refused.
std::optional<Input> read_input(const Options& options, bool images,
                                std::optional<Dialect> fallback, Diagnostics& diagnostics);

// The suffix says that PROGRAM is one of flow tasks.
bool is_flow_file(const std::string& file);
// Flow tasks run in rounds, which a processor alone does not make: wrong usage for an image that
// has some.
void refuse_flow_image(const Input& input);

// The compiled program with the options' processor (3 if none is given); `input` is no image.
std::optional<Compiled> compile_input(const Input& input, const Options& options,
                                      Diagnostics& diagnostics);

// What a stimulus may name.
DeviceNames names_of(const Input& input);
// Reads --stimulus.
std::optional<Stimulus> read_stimulus(const std::string& file, const DeviceNames& names,
                                      Diagnostics& diagnostics);
// Microseconds of --tick, if it was given. An LDmicro program's scans follow its CYCLE: with one it
// is wrong usage.
std::optional<std::int64_t> tick_of(const Options& options, const Input& input);

// The image and its processor, in the order in which they must live.
struct Target {
  image::Image image;
  tb::LoadedMachine loaded;
  tb::AnyMachine& machine() { return *loaded.machine; }
};
// `tick_us` is the time from scan to scan.
std::unique_ptr<Target> make_target(image::Image image, std::int64_t tick_us);

}  // namespace rung::cli
