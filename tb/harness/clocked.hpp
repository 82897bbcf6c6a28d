// SPDX-License-Identifier: Apache-2.0
// A Verilated module with one clock (`clk_i`) and a synchronous reset (`rst_ni`).
#pragma once

#include <verilated.h>

#include <memory>

#include "harness/model_coverage.hpp"

namespace rung::tb {

template <typename Dut>
class Clocked {
 public:
  // Every register starts with a value drawn from `seed`: nothing may depend on it after reset().
  explicit Clocked(int seed = 1) : context_(std::make_unique<VerilatedContext>()) {
    context_->randReset(2);
    context_->randSeed(seed);
    dut_ = std::make_unique<Dut>(context_.get());
    dut_->clk_i = 0;
    dut_->rst_ni = 1;
  }
  ~Clocked() {
    // A model takes its scopes out of the context that its thread used last.
    Verilated::threadContextp(context_.get());
    dut_->final();
    count_coverage(*context_);
  }
  Clocked(const Clocked&) = delete;
  Clocked& operator=(const Clocked&) = delete;

  Dut* operator->() { return dut_.get(); }

  // One rising edge. It samples the inputs as they are; the outputs are then those of the clock
  // that begins with it.
  void tick() {
    dut_->clk_i = 0;
    dut_->eval();
    dut_->clk_i = 1;
    dut_->eval();
  }

  // Long enough for every processor (see hdl/mpu1.v).
  void reset() {
    dut_->rst_ni = 0;
    for (int i = 0; i < 8; ++i) tick();
    dut_->rst_ni = 1;
  }

 private:
  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Dut> dut_;
};

}  // namespace rung::tb
