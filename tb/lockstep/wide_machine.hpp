// SPDX-License-Identifier: Apache-2.0
// MPU4 that runs an image.
#pragma once

#include "lockstep/any_machine.hpp"
#include "lockstep/wide_processor.hpp"

namespace rung::tb {

class WideMachine final : public AnyMachine {
 public:
  // Loads `image` into `processor`, which has as many slots; all devices are 0. Both must outlive
  // this.
  WideMachine(const image::Image& image, WideProcessor& processor, std::int64_t tick_us = 10000);

  std::int16_t value(std::size_t device) override;
  std::string describe(const MachineWrite& write) const override;

 private:
  ScanResult execute() override;
  void put(int device, std::int16_t value) override;
  void read_back();

  const image::WideImage& wide_;
  WideProcessor& processor_;
  std::map<int, int> latched_;  // index into Image::devices -> position in the latch
  std::vector<std::uint8_t> inputs_;
  std::vector<int> bits_, words_;  // indices of the devices that are read back
  std::vector<int> bit_places_, word_places_;
  // Of Image::devices, as they were read back; nothing if something has changed since.
  std::vector<std::int16_t> read_;
};

}  // namespace rung::tb
