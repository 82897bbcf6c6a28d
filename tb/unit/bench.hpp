// SPDX-License-Identifier: Apache-2.0
// A Verilated processor beside the step model: everything is done to both, and a scan compares
// them.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "harness/processor.hpp"
#include "unit/step_model.hpp"

namespace rung::tb {

// One processor in one configuration; the parameter of the parameterised tests.
struct Target {
  isa::Mpu mpu;
  const isa::Config* config;
};
// These processors in every configuration.
std::vector<Target> targets(const std::vector<isa::Mpu>& mpus);
inline const std::vector<isa::Mpu> kAllMpus{isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3};
inline const std::vector<isa::Mpu> kLookUpMpus{isa::Mpu::Mpu2, isa::Mpu::Mpu3};
// "mpu3_ecp5", as gtest wants the name of a parameter.
std::string target_name(const testing::TestParamInfo<Target>& info);

class Bench {
 public:
  // Devices are 0, LUT rows are 0. Benches of one target share its Verilated model, one at a time.
  explicit Bench(const Target& target);

  isa::Mpu mpu() const { return target_.mpu; }
  const isa::Config& config() const { return *target_.config; }
  int slots() const { return isa::slots(target_.mpu); }
  Processor& rtl() { return *rtl_; }
  const StepModel& model() const { return model_; }

  void set_bit(int address, bool value);
  void set_word(int address, std::uint16_t value);
  void set_lut(int row, std::uint8_t function);

  // A step with `instruction` in `slot` and NOP in the others.
  Step step(const isa::SlotInstruction& instruction, int slot = 0) const;
  // Loads `program`, runs one scan on both, and compares every retired instruction, the clocks and
  // the error flag. The result says what differed first.
  testing::AssertionResult scan(const std::vector<Step>& program);
  // Runs the program loaded last once more.
  testing::AssertionResult scan_again();
  // Runs steps `entry` to `end` - 1 of the program loaded last alone.
  testing::AssertionResult scan_range(std::size_t entry, std::size_t end);
  // Reads every device back through the load port.
  testing::AssertionResult devices_equal();

  // What the RTL retired in the last scan, by step and slot.
  const std::vector<Retired>& retired() const { return retired_; }

 private:
  // Runs `program`, which is what lies from step `first` on, on both by `run`, and compares.
  testing::AssertionResult compare(const std::vector<Step>& program, std::size_t first,
                                   const std::function<ScanResult(const RetireObserver&)>& run);

  Target target_;
  std::shared_ptr<Processor> rtl_;
  StepModel model_;
  std::vector<Step> program_;
  std::vector<Retired> retired_;
};

}  // namespace rung::tb
