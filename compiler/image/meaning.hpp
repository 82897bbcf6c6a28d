// SPDX-License-Identifier: Apache-2.0
// What an image is meant to do, for a check of it (prove/): the core program that each of its
// routines was made of, and where that one's devices are.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/program.hpp"

namespace rung::image {

// One straight piece of the image's code: a whole program, or of one with flow tasks the ladder or
// a step.
struct Meaning {
  core::Program program;
  std::string step;              // of a flow task: its name
  std::map<Device, int> places;  // addresses, in bit or in word memory
  int first_step = 0;
  int end_step = 0;
  int first_origin = 0;            // of the program's source instructions, in Image::source
  std::vector<std::size_t> rungs;  // the first source instruction of each rung
};

}  // namespace rung::image
