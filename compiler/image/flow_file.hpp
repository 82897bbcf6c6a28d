// SPDX-License-Identifier: Apache-2.0
// Of the image file the part that programs with flow tasks have.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>

#include "image/image.hpp"

namespace rung::image {

namespace file {

// Throws what from_bytes() reports.
inline void require(bool condition, const char* what) {
  if (!condition) throw std::runtime_error(what);
}
inline bool inside(int address, int size) { return address >= 0 && address < size; }

}  // namespace file

nlohmann::json flow_to_json(const FlowImage& flow);
FlowImage flow_from_json(const nlohmann::json& in);

// Throws where image.flow, which is there, does not fit the image, the configuration or the task
// hardware.
void check_flow(const Image& image, const isa::Config& config);

}  // namespace rung::image
