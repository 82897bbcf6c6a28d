// SPDX-License-Identifier: Apache-2.0
// Programs of flow tasks from text to what a unit is loaded with, and the bounds that the compiler
// prints of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "load/flow_bound.hpp"

namespace rung::tb {

struct FlowBuilt {
  image::Image image;
  std::vector<std::uint16_t> words;  // of its load file
  load::FlowBound bound;
};

// Compiles a `.flow` file for MPU3 with an I/O map. Throws std::runtime_error with all diagnostics
// if anything is refused.
FlowBuilt build_flow(const std::string& file, const std::string& map);

// A folder of its own for programs, gone with it.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  // Writes a file into it; gives its name.
  std::string put(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

}  // namespace rung::tb
