// SPDX-License-Identifier: Apache-2.0
// The I/O map of the command line, and a program bound to it.
#pragma once

#include <optional>
#include <vector>

#include "cli/input.hpp"
#include "io/bind.hpp"
#include "load/latency.hpp"

namespace rung::cli {

// Reads --io, if it was given. Where the options name no configuration or processor, they get the
// board's. Nothing if there is no map or, with errors, it cannot be read.
std::optional<io::Map> read_io(Options& options, Diagnostics& diagnostics);

struct Bound {
  io::Map map;
  io::Subject subject;
  io::Bindings bindings;
  load::Timing timing;
};
// An image with its map, or the default one (board simulated) without.
Bound bind_image(const image::Image& image, const std::optional<io::Map>& map,
                 const Options& options, Diagnostics& diagnostics);
// What a map may name.
io::Subject subject_of(const Input& input, const Options& options);
// For commands on which a map has no effect: it is checked.
void check_io(const Input& input, const std::optional<io::Map>& map, const Options& options,
              Diagnostics& diagnostics);

// The clock of the controller.
std::int64_t clock_of(const Options& options, const image::Image& image);

}  // namespace rung::cli
