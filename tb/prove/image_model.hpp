// SPDX-License-Identifier: Apache-2.0
// What an image does with one start of a scan, by the step model of the RTL's unit tests: the judge
// of what a proof has said.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "image/image.hpp"
#include "prove/start.hpp"
#include "unit/step_model.hpp"

namespace rung::tb {

struct Memory {
  std::vector<bool> bits;
  std::vector<std::uint16_t> words;
};

// Of each place that is written, the values in their order; and the error flag.
struct Effect {
  std::map<prove::Place, std::vector<std::uint16_t>> writes;
  bool error = false;
  bool operator==(const Effect&) const = default;
};

// Only of `places`, and of wherever an index leads.
Effect run_model(const image::Image& image, const Memory& start,
                 const std::vector<prove::Place>& places);

// The same by the RTL, which knows latencies.
Effect run_rtl(Processor& processor, const image::Image& image, const Memory& start,
               const std::vector<prove::Place>& places);

// The step model does not: whether what uses ix, or collects a result, comes late enough
// in every slot, so that it need not.
bool keeps_latencies(const image::Image& image);

// Of each place the instructions that may write it, in their order, by their numbers: `numbers`
// gives that of each step. Indexed ones are left out.
std::map<prove::Place, std::vector<std::size_t>> writers(const image::Image& image,
                                                         const std::vector<std::size_t>& numbers);

}  // namespace rung::tb
