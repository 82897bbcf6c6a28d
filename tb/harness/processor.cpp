// SPDX-License-Identifier: Apache-2.0
#include "harness/processor.hpp"

#include <Vecp5_mpu1.h>
#include <Vecp5_mpu2.h>
#include <Vecp5_mpu3.h>
#include <Vhx8k_mpu1.h>
#include <Vhx8k_mpu2.h>
#include <Vhx8k_mpu3.h>

#include <algorithm>
#include <tuple>

#include "harness/verilated_processor.hpp"

namespace rung::tb {
namespace {

template <typename Dut1, typename Dut2, typename Dut3>
std::unique_ptr<Processor> make(isa::Mpu mpu, const isa::Config& config) {
  switch (mpu) {
    case isa::Mpu::Mpu1:
      return std::make_unique<VerilatedProcessor<Dut1, isa::Mpu::Mpu1>>(config);
    case isa::Mpu::Mpu2:
      return std::make_unique<VerilatedProcessor<Dut2, isa::Mpu::Mpu2>>(config);
    case isa::Mpu::Mpu3:
      return std::make_unique<VerilatedProcessor<Dut3, isa::Mpu::Mpu3>>(config);
    case isa::Mpu::Mpu4:
      break;  // it has a bench of its own (tb/wide)
  }
  throw std::invalid_argument("no such processor");
}

// Of what a processor is made.
auto sizes(const isa::Config& config) {
  return std::tuple(config.steps_mpu1, config.steps_mpu2, config.steps_mpu3, config.bit_devices,
                    config.word_devices, config.mul_latency, config.div_latency,
                    config.mul32_latency, config.div32_latency);
}

}  // namespace

std::unique_ptr<Processor> make_processor(isa::Mpu mpu, const isa::Config& config) {
  if (config.name == "ecp5") return make<Vecp5_mpu1, Vecp5_mpu2, Vecp5_mpu3>(mpu, config);
  // gw2a has the sizes of the HX8K (hdl/isa/configs.toml).
  if (config.name == "hx8k" || config.name == "gw2a") {
    return make<Vhx8k_mpu1, Vhx8k_mpu2, Vhx8k_mpu3>(mpu, config);
  }
  throw std::invalid_argument(fmt::format("no Verilated model of configuration {}", config.name));
}

std::vector<const isa::Config*> distinct_configs() {
  std::vector<const isa::Config*> distinct;
  for (const isa::Config& config : isa::configs()) {
    const auto same = [&](const isa::Config* other) { return sizes(*other) == sizes(config); };
    if (std::none_of(distinct.begin(), distinct.end(), same)) distinct.push_back(&config);
  }
  return distinct;
}

}  // namespace rung::tb
