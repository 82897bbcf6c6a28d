// SPDX-License-Identifier: Apache-2.0
// Programs for a simulated controller, made as `rung compile` makes them.
#pragma once

#include <string>

#include "image/image.hpp"
#include "io/bind.hpp"
#include "load/latency.hpp"
#include "reliability/client.hpp"

namespace rung::tb {

struct Made {
  Words words;
  image::Image image;
  io::Bindings bindings;
  load::Timing timing;
};
// A list or an LDmicro program, and an I/O map, that must be good, for the clock of the simulated
// controller.
Made make_program(const std::string& list, const std::string& map);

}  // namespace rung::tb
