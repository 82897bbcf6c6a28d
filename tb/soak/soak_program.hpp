// SPDX-License-Identifier: Apache-2.0
// A random program with its I/O map, as a user would bring them to a board: what `make soak` swaps
// in and out.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/bind.hpp"
#include "io/modbus_map.hpp"
#include "load/latency.hpp"
#include "reliability/client.hpp"
#include "rungs/program.hpp"

namespace rung::tb {

// A client's write shows at an output: the device is copied to a pin of its own in every scan, so
// that the scan before which a write took effect is known.
struct Mark {
  Device device;  // a relay of the program; of words, the output is whether it is 1
  int pin = 0;
};

struct SoakProgram {
  std::uint64_t seed = 0;
  std::string text;
  std::string map;
  Program program;
  io::Bindings bindings;
  load::Timing timing;
  Words file;           // its watchdog trips at a scan of one clock more than the compiler says
  Words tripping_file;  // and here at some clock of the first scan, before its refresh
  std::int64_t tick_us = 0;
  Mark bit, word;
  std::vector<Device> named;          // that a client can read
  std::vector<Device> relays, words;  // that it writes: those below the marks, ascending
  // Levels of all pins where no program runs: known for all but those that keep their level.
  std::uint64_t safe = 0, held = 0;
  // Of the outputs' pins, those that are inverted.
  std::uint64_t inverted = 0;
};

// The program of `seed` for `board`. The same seed gives the same one everywhere.
std::shared_ptr<const SoakProgram> make_soak_program(const std::string& board,
                                                     std::uint64_t clocks_per_ms,
                                                     std::uint64_t seed);

}  // namespace rung::tb
