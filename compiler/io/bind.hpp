// SPDX-License-Identifier: Apache-2.0
// An I/O map brought together with a program: which of its devices meets which pin, channel and
// line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/map.hpp"
#include "io/subject.hpp"

namespace rung::io {

struct Bindings {
  struct Input {
    Device device;
    int pin = 0;
    int filter = 0;
    bool invert = false;
  };
  struct Output {
    Device device;
    int pin = 0;
    Safe safe = Safe::Low;
    bool invert = false;
  };
  struct Analog {
    Device device;  // a word of a list, or an analogue channel of an LDmicro program
    int channel = 0;
  };
  struct Pwm {
    Device device;  // the word that is the duty in per cent
    int pin = 0;
    std::int64_t hz = 0;
  };

  const controller::Board* board = nullptr;
  Settings settings;  // the period is the program's CYCLE where the map gives none
  std::vector<Input> inputs;
  std::vector<Output> outputs;
  std::vector<Analog> analog;
  std::optional<Pwm> pwm;  // of a list
  bool ladder_uart = false, ladder_pwm = false;
  std::vector<Device> latched;  // devices of the program, ascending
};

// The map without --io: board `simulated`, inputs in order at in0 and up, outputs at out0 and up. A
// warning where the board has too few pins.
Map default_map(const Subject& subject, Diagnostics& diagnostics);

// Errors, each where it stands in the map: what the board or the program does not have, what is
// bound twice or as the wrong thing, a program for another board.
Bindings bind(const Map& map, const Subject& subject, Diagnostics& diagnostics);

// The devices of the program that keep their values over STOP and power loss where the map does not
// say which (README.md).
std::vector<Device> latched_by_default(const Subject& subject);
// Those that the map names.
std::vector<Device> latched_of(const Map& map, const Subject& subject, Diagnostics& diagnostics);

// What is bound where, as a table for people.
std::string table(const Bindings& bindings, const Subject& subject);

}  // namespace rung::io
