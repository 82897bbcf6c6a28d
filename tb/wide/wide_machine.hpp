// SPDX-License-Identifier: Apache-2.0
// An image for MPU4 on its simulator: devices by name instead of by address.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "rungs/special.hpp"
#include "trace/stimulus.hpp"
#include "wide/simulate.hpp"

namespace rung::tb {

// One executed write of a device that the program names.
struct WideWritten {
  int device = 0;  // index into Image::devices
  std::int16_t value = 0;
  int step = 0;
  int lane = 0;
};

class WideMachine {
 public:
  // All devices are 0. `image` must outlive this.
  explicit WideMachine(const image::Image& image, std::int64_t tick_us = 10000);

  // Gives devices their values before a scan; devices that the image does not have are ignored.
  void apply(std::span<const StimulusEvent> events);
  void set(Device device, std::int16_t value);
  void run_scan();

  const std::vector<WideWritten>& writes() const { return writes_; }
  std::int16_t value(std::size_t device) const;
  int find(Device device) const;
  std::int64_t clocks() const { return simulator_.clocks(); }
  bool error() const { return simulator_.error(); }
  const image::Image& image() const { return image_; }
  std::string describe(const WideWritten& write) const;

 private:
  void put(Device device, int address, std::int16_t value);

  const image::Image& image_;
  const image::WideImage& wide_;
  const wide::Machine& machine_;
  wide::Simulator simulator_;
  std::map<Device, int> by_device_;
  std::map<Device, int> ports_;
  std::map<int, int> latched_;  // device -> position
  std::vector<std::uint8_t> inputs_;
  std::vector<std::int16_t> values_;
  std::vector<WideWritten> writes_;
  std::vector<std::pair<int, const SpecialRange*>> driven_;
  ScanTime time_;
};

}  // namespace rung::tb
