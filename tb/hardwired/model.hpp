// SPDX-License-Identifier: Apache-2.0
// The Verilated model of this test's programs: RUNG_MODEL, in RUNG_MODEL_HEADER.
#pragma once

#include RUNG_MODEL_HEADER

#include "hardwired/bench.hpp"

namespace rung::tb {

class VerilatedBatch : public BatchModel {
 public:
  VerilatedBatch() {
    start = top_.start_i.data();
    state_load = top_.state_load_i.data();
    in = top_.in_i.data();
    clocks = top_.clocks_i.data();
    ticks = top_.ticks_i.data();
    state_in = top_.state_i.data();
    busy = top_.busy_o.data();
    done = top_.done_o.data();
    error = top_.error_o.data();
    out = top_.out_o.data();
    state = top_.state_o.data();
  }
  ~VerilatedBatch() override { top_.final(); }
  void clock(bool reset) override {
    top_.rst_i = reset ? 1 : 0;
    top_.clk_i = 0;
    top_.eval();
    top_.clk_i = 1;
    top_.eval();
  }

 private:
  RUNG_MODEL top_;
};

}  // namespace rung::tb
