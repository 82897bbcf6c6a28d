// SPDX-License-Identifier: Apache-2.0
// Reads the stages of one Verilated processor, clock by clock.
#pragma once

#include <deque>
#include <memory>

#include "harness/processor.hpp"
#include "image/image.hpp"
#include "view/recording.hpp"

namespace rung::tb {

// A processor that calls an observer in every clock of a scan, and the probes into it.
class RecordedProcessor {
 public:
  virtual ~RecordedProcessor() = default;
  virtual Processor& processor() = 0;
  // Begins the recording of a scan of `image`, which its processor has loaded.
  virtual void begin(const image::Image& image) = 0;
  virtual const std::vector<view::RecordedClock>& clocks() const = 0;
};

std::unique_ptr<RecordedProcessor> make_recorded_processor(isa::Mpu mpu, const isa::Config& config);

// The code, as the page shows it.
std::vector<std::vector<view::RecordedCode>> recorded_code(const image::Image& image);

}  // namespace rung::tb
