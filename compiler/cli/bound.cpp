// SPDX-License-Identifier: Apache-2.0
#include "cli/bound.hpp"

#include "load/load_file.hpp"
#include "reference/flow_run.hpp"
#include "rung_controller.hpp"
#include "rungs/devices.hpp"
#include "source/text_file.hpp"

namespace rung::cli {

std::optional<io::Map> read_io(Options& options, Diagnostics& diagnostics) {
  if (options.io.empty()) return std::nullopt;
  const auto bytes = read_bytes(options.io, diagnostics);
  if (!bytes) return std::nullopt;
  auto map = io::parse_map(*bytes, options.io, diagnostics);
  if (!map) return std::nullopt;
  if (options.config.empty()) options.config = map->board->config;
  options.default_mpu = map->board->mpu;
  return map;
}

std::int64_t clock_of(const Options& options, const image::Image& image) {
  return options.clock_hz.value_or(isa::find_config(image.config)->clock_hz);
}

Bound bind_image(const image::Image& image, const std::optional<io::Map>& map,
                 const Options& options, Diagnostics& diagnostics) {
  Bound bound;
  bound.subject = load::subject_of(image);
  bound.map = map ? *map : io::default_map(bound.subject, diagnostics);
  bound.bindings = io::bind(bound.map, bound.subject, diagnostics);
  bound.timing = load::timing_of(image, bound.bindings, clock_of(options, image));
  load::check_timing(bound.timing, bound.map, bound.bindings, image.program, diagnostics);
  return bound;
}

io::Subject subject_of(const Input& input, const Options& options) {
  const std::string_view config = config_of(options).name;
  if (input.image) return load::subject_of(*input.image);
  if (input.program) return io::subject_of(*input.program, config);
  io::Subject subject;
  subject.file = input.flow->file;
  subject.dialect = input.flow->dialect;
  subject.config = config;
  subject.flow = true;
  for (const Device device : visible_devices(*input.flow)) {
    const auto& comments = input.flow->ladder.comments;
    const auto comment = comments.find(device);
    subject.devices.push_back({device, device_name(device, subject.dialect),
                               comment == comments.end() ? std::string() : comment->second});
  }
  return subject;
}

void check_io(const Input& input, const std::optional<io::Map>& map, const Options& options,
              Diagnostics& diagnostics) {
  if (!map) return;
  if (input.image) {
    static_cast<void>(bind_image(*input.image, map, options, diagnostics));
  } else {
    static_cast<void>(io::bind(*map, subject_of(input, options), diagnostics));
  }
}

}  // namespace rung::cli
