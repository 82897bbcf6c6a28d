// SPDX-License-Identifier: Apache-2.0
// MPU1, MPU2 or MPU3 that runs an image.
#pragma once

#include "lockstep/any_machine.hpp"

namespace rung::tb {

class Machine final : public AnyMachine {
 public:
  // Loads `image` into `processor`, which is its processor in its configuration; all devices are 0.
  // Both must outlive this.
  Machine(const image::Image& image, Processor& processor, std::int64_t tick_us = 10000);
  // Sets what it has used back to 0, so that the processor is as new for the next machine.
  ~Machine() override;

  // Also shows `observer` every retired instruction of the scans to come.
  void observe(RetireObserver observer) { observer_ = std::move(observer); }
  std::string describe(const MachineWrite& write) const override;

 private:
  ScanResult execute() override;
  void retire(const Retired& retired);

  Processor& processor_;
  std::vector<int> bit_devices_;  // address -> index into Image::devices, or -1
  std::vector<int> word_devices_;
  RetireObserver observer_;
};

}  // namespace rung::tb
