// SPDX-License-Identifier: Apache-2.0
// MPU1 from the netlist of the known faults, in the place of all processors
// (harness/processor.cpp).
#include <Vsample_mpu1.h>

#include "harness/verilated_processor.hpp"

namespace rung::tb {

std::unique_ptr<Processor> make_processor(isa::Mpu mpu, const isa::Config& config) {
  if (mpu != isa::Mpu::Mpu1 || config.name != "hx8k") {
    throw std::invalid_argument("the netlist is MPU1's, configuration hx8k");
  }
  return std::make_unique<VerilatedProcessor<Vsample_mpu1, isa::Mpu::Mpu1>>(config);
}

std::vector<const isa::Config*> distinct_configs() { return {isa::find_config("hx8k")}; }

}  // namespace rung::tb
