// SPDX-License-Identifier: Apache-2.0
// How often a program puts the pipeline's hazards to the test.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "harness/processor.hpp"
#include "image/image.hpp"

namespace rung::tb {

// Counts over the steps of images and over retired instructions. A distance is the number of steps
// from a write to a read of the same device; beyond the longest one the memory itself answers.
struct Hazards {
  static constexpr int kDistances = 5;

  // [same slot, other slot][distance - 1]
  using ByDistance = std::array<std::array<std::uint64_t, kDistances>, 2>;
  ByDistance bit_read_after_write{};
  ByDistance word_read_after_write{};
  ByDistance bit_rewritten{};  // a write after a write: of the other slot, the other bank
  ByDistance word_rewritten{};
  std::uint64_t read_in_step_of_write = 0;   // the read must give the old value
  std::uint64_t both_slots_write = 0;        // in one step
  std::array<std::uint64_t, 4> n0_chains{};  // look-ups fed by N0: 1, 2, 3, 4 or more in a row
  std::uint64_t gated_writes_done = 0;       // SET, RST and word instructions, executed or not
  std::uint64_t gated_writes_held = 0;
  std::uint64_t collected_at_latency = 0;  // MVL or MVH as early as it may come

  // Counts what the code of `image` does each scan.
  void count(const image::Image& image);
  // Counts one retired instruction of a run.
  void count(const image::Image& image, const Retired& retired);

  std::string to_string() const;
};

}  // namespace rung::tb
