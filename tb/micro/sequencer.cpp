// SPDX-License-Identifier: Apache-2.0
#include "sequencer.hpp"

#include "Vmicro.h"

namespace rung::tb {

Sequencer::Sequencer() : model_(new Vmicro) {}
Sequencer::~Sequencer() { model_->final(); }

void Sequencer::clock() {
  model_->clk_i = 0;
  model_->eval();
  model_->clk_i = 1;
  model_->eval();
}

std::vector<Access> Sequencer::run(const std::vector<std::uint16_t>& words, std::size_t count,
                                   std::uint64_t clocks) {
  model_->rst_ni = 0;
  model_->mem_rdata_i = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    model_->test_write_i = 1;
    model_->test_addr_i = static_cast<std::uint16_t>(i);
    model_->test_data_i = words[i];
    clock();
  }
  model_->test_write_i = 0;
  clock();
  model_->rst_ni = 1;
  std::vector<Access> out;
  while (out.size() < count && clocks-- > 0) {
    model_->clk_i = 0;
    model_->eval();
    const bool reads = model_->mem_read_o != 0;
    const std::uint16_t address = model_->mem_addr_o;
    if (model_->mem_write_o != 0) out.push_back({true, address, model_->mem_wdata_o});
    model_->clk_i = 1;
    model_->eval();
    // Wrong at any other time than in the clock after the read.
    model_->mem_rdata_i = 0xDEAD;
    if (reads) {
      model_->mem_rdata_i = input(out.size(), address);
      out.push_back({false, address, model_->mem_rdata_i});
    }
  }
  return out;
}

}  // namespace rung::tb
