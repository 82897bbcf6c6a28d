// SPDX-License-Identifier: Apache-2.0
// What an image for MPU4 has in place of steps and LUT: its own instructions, inputs in rows, and
// where each device is written. Addresses of devices are row * lanes + lane.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rungs/device.hpp"

namespace rung::image {

// The word or bit computed in this place is written to a device of the program.
struct WideWrite {
  int step = 0;
  int lane = 0;
  int device = 0;      // index into Image::devices
  bool quiet = false;  // writing the value that is there already is no write
};

// A device port or a word of ticks: not among the devices with names.
struct WidePort {
  Device device;
  int address = 0;
};

// How well the units were used, for people.
struct WideReport {
  int look_ups = 0;  // bit instructions, of steps x slots
  int words = 0;     // word instructions, of steps x units
  int divisions = 0;
  int captures = 0;     // results that a slot or unit takes from another one's lane
  int near_values = 0;  // operands that come from a register, not from a row
  int by_look_ups = 0;  // steps that no schedule can go below, by reason
  int by_words = 0;
  int by_dividers = 0;
  int by_dependence = 0;
  std::string binding;  // the reason that gives the most
};

struct WideImage {
  int slots = 8;
  std::vector<std::vector<std::vector<std::uint16_t>>> code;  // [step][slot]: chunks
  std::vector<std::vector<int>> origins;  // [step][slot]: index into Image::source, or -1
  int first_latch_row = 0;
  std::vector<int> latched;  // by position: index into Image::devices
  int latch_rows = 0;
  std::vector<WideWrite> writes;  // those of one device in the order of the program
  std::vector<WidePort> ports;
  bool merged = true;  // writes that nobody can see may be missing
  WideReport report;
};

}  // namespace rung::image
