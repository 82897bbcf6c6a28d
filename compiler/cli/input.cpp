// SPDX-License-Identifier: Apache-2.0
#include "cli/input.hpp"

#include <filesystem>
#include <iostream>

#include "driver/compile_flow.hpp"
#include "flowchart/read.hpp"
#include "image/image_file.hpp"
#include "ldmicro/ldmicro.hpp"
#include "melsec/comments.hpp"
#include "melsec/melsec.hpp"
#include "melsec/paper.hpp"
#include "source/text_file.hpp"

namespace rung::cli {
namespace {

std::optional<std::map<Device, std::string>> read_comments(const std::string& file, Dialect dialect,
                                                           Diagnostics& diagnostics) {
  const auto bytes = read_bytes(file, diagnostics);
  if (!bytes) return std::nullopt;
  const auto text = decode_text(*bytes, file, diagnostics);
  return text ? parse_comments(*text, dialect, diagnostics) : std::nullopt;
}

std::optional<Program> parse_list_or_csv(std::string_view bytes, const Options& options,
                                         std::optional<Dialect> dialect, Diagnostics& diagnostics) {
  const auto text = decode_text(bytes, options.program, diagnostics);
  if (!text) return std::nullopt;
  auto program = parse_melsec(*text, dialect, diagnostics);
  if (program && options.paper && !check_paper(*program, diagnostics)) return std::nullopt;
  if (program && !options.comments.empty()) {
    auto comments = read_comments(options.comments, program->dialect, diagnostics);
    if (!comments) return std::nullopt;
    program->comments = std::move(*comments);
  }
  return program;
}

std::optional<Program> parse_ld_file(std::string_view bytes, const Options& options,
                                     Diagnostics& diagnostics) {
  if (!options.comments.empty()) {
    throw UsageError("--comments is for lists; an LDmicro program has names of its own");
  }
  const auto text = decode_ldmicro(bytes, options.program, diagnostics);
  return text ? parse_ldmicro(*text, diagnostics) : std::nullopt;
}

// A flow program says its dialect itself; names come from a comment file as those of a list do.
std::optional<flowchart::Flowchart> parse_flow_file(std::string_view bytes, const Options& options,
                                                    Diagnostics& diagnostics) {
  if (options.paper) throw UsageError("--paper is for lists; this is a flow program");
  if (!options.dialect.empty()) {
    throw UsageError("--dialect is for lists; a flow program says its dialect in its first lines");
  }
  const auto text = decode_text(bytes, options.program, diagnostics);
  if (!text) return std::nullopt;
  auto chart = flowchart::parse(*text, diagnostics);
  if (chart && !options.comments.empty()) {
    auto comments = read_comments(options.comments, chart->dialect, diagnostics);
    if (!comments) return std::nullopt;
    chart->ladder.comments = std::move(*comments);
  }
  return chart;
}

bool has_suffix(const std::string& file, std::string_view lower, std::string_view upper) {
  const std::string suffix = std::filesystem::path(file).extension().string();
  return suffix == lower || suffix == upper;
}

bool is_ld_file(const std::string& file) { return has_suffix(file, ".ld", ".LD"); }

// The dialect that the program's suffix or an option gives; nothing if the program decides.
std::optional<Dialect> known_dialect(const Options& options, std::optional<Dialect> fallback) {
  const std::optional<Dialect> asked = dialect_of(options);
  if (!is_ld_file(options.program)) return asked ? asked : fallback;
  if (options.paper) throw UsageError("--paper is for lists; this is an LDmicro program");
  return asked ? asked : Dialect::Ldmicro;
}

constexpr const char* kNoMap = "an I/O map is for a controller, which MPU4 does not have yet";

// An image is for one processor and was compiled once: what would change that is wrong usage.
void check_image_options(const Options& options, const image::Image& image) {
  const std::optional<int> mpu = mpu_of(options);
  if (mpu && *mpu != static_cast<int>(image.mpu)) {
    throw UsageError("an image runs on the processor that it was compiled for, MPU" +
                     std::to_string(static_cast<int>(image.mpu)));
  }
  if (options.paper) throw UsageError("--paper is for compiling; this is an image");
  if (image.wide && options.command != Command::Run && options.command != Command::Check) {
    throw UsageError(
        "an image for MPU4 is for rung run and rung check; there is no controller with MPU4 yet");
  }
  if (!image.wide && (options.slots || options.no_merge)) {
    throw UsageError("--slots and --no-merge are for MPU4; this image is for MPU" +
                     std::to_string(static_cast<int>(image.mpu)));
  }
  if (image.wide && options.slots.value_or(image.wide->slots) != image.wide->slots) {
    throw UsageError("the image was compiled for " + std::to_string(image.wide->slots) + " slots");
  }
  if (image.wide && !options.io.empty()) throw UsageError(kNoMap);
  if (image.wide && options.no_merge && image.wide->merged) {
    throw UsageError("the image was compiled with merging; compile it with --no-merge");
  }
  if (!options.dialect.empty() && options.dialect != image.dialect) {
    throw UsageError("the image was compiled from dialect " + image.dialect);
  }
}

// What MPU4 does not have.
void check_wide_options(const Options& options) {
  if (options.mpu != "4") return;
  if (options.paper) throw UsageError("--paper is for MPU1 to MPU3");
  if (is_flow_file(options.program)) throw UsageError("flow tasks are for MPU1 to MPU3");
  if (!options.io.empty()) {
    throw UsageError(kNoMap);
  }
  if (options.bindings || !options.load_file.empty()) {
    throw UsageError("--bindings and --load-file are for controllers, of which MPU4 has none yet");
  }
}

}  // namespace

int report(const Diagnostics& diagnostics) {
  diagnostics.print(std::cerr);
  return diagnostics.has_errors() ? kRefused : kDone;
}

std::optional<Input> read_input(const Options& options, bool images,
                                std::optional<Dialect> fallback, Diagnostics& diagnostics) {
  // Wrong usage before a file that cannot be read.
  static_cast<void>(dialect_of(options));
  check_wide_options(options);
  const auto bytes = read_bytes(options.program, diagnostics);
  if (!bytes) return std::nullopt;
  Input input;
  if (images && image::is_image(*bytes)) {
    input.image = image::from_bytes(*bytes, options.program, diagnostics);
    if (!input.image) return std::nullopt;
    check_image_options(options, *input.image);
    input.dialect = *find_dialect(input.image->dialect);
    return input;
  }
  if (options.mpu != "4" && (options.slots || options.no_merge)) {
    throw UsageError("--slots and --no-merge are for MPU4: --mpu 4");
  }
  if (is_flow_file(options.program)) {
    input.flow = parse_flow_file(*bytes, options, diagnostics);
    if (!input.flow) return std::nullopt;
    input.dialect = input.flow->dialect;
    return input;
  }
  const std::optional<Dialect> dialect = known_dialect(options, fallback);
  input.program = dialect == Dialect::Ldmicro
                      ? parse_ld_file(*bytes, options, diagnostics)
                      : parse_list_or_csv(*bytes, options, dialect, diagnostics);
  if (!input.program) return std::nullopt;
  input.dialect = input.program->dialect;
  return input;
}

bool is_flow_file(const std::string& file) { return has_suffix(file, ".flow", ".FLOW"); }

void refuse_flow_image(const Input& input) {
  if (!input.image || !input.image->flow) return;
  throw UsageError(
      "this image has flow tasks, which only a controller runs (rung load); the program itself "
      "runs "
      "with `rung run PROGRAM.flow --mpu reference`");
}

std::optional<Compiled> compile_input(const Input& input, const Options& options,
                                      Diagnostics& diagnostics) {
  CompileOptions how;
  how.mpu = static_cast<isa::Mpu>(mpu_of(options).value_or(options.default_mpu));
  how.paper = options.paper;
  how.config = &config_of(options);
  how.search.seed = options.seed;
  how.slots = options.slots.value_or(kDefaultSlots);
  how.merge = !options.no_merge;
  return input.flow ? compile_flow(*input.flow, how, diagnostics)
                    : compile(*input.program, how, diagnostics);
}

DeviceNames names_of(const Input& input) {
  if (input.flow) return {input.flow->dialect};
  return input.program ? DeviceNames(*input.program) : tb::names_of(*input.image);
}

std::optional<std::int64_t> tick_of(const Options& options, const Input& input) {
  const auto tick = tick_of(options);
  if (tick && input.dialect == Dialect::Ldmicro) {
    throw UsageError("--tick is for lists; the CYCLE of an LDmicro program is in its file");
  }
  return tick;
}

std::optional<Stimulus> read_stimulus(const std::string& file, const DeviceNames& names,
                                      Diagnostics& diagnostics) {
  const auto bytes = read_bytes(file, diagnostics);
  if (!bytes) return std::nullopt;
  const auto text = decode_text(*bytes, file, diagnostics);
  return text ? parse_stimulus(*text, names, diagnostics) : std::nullopt;
}

std::unique_ptr<Target> make_target(image::Image image, std::int64_t tick_us) {
  auto target = std::make_unique<Target>();
  target->image = std::move(image);
  target->loaded = tb::load_machine(target->image, tick_us);
  return target;
}

}  // namespace rung::cli
