// SPDX-License-Identifier: Apache-2.0
#include "agree/processors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "driver/compile.hpp"
#include "lockstep/lockstep.hpp"
#include "lockstep/machine.hpp"

namespace rung::tb {

Processors::Processors(std::size_t most_scans) : most_scans_(most_scans) {
  const isa::Config& config = *isa::find_config("ecp5");
  for (int mpu = 1; mpu <= 3; ++mpu) {
    processors_[mpu - 1] = make_processor(static_cast<isa::Mpu>(mpu), config);
  }
}

std::string Processors::run(const Case& one) {
  try {
    return run_all(one);
  } catch (const std::logic_error& error) {
    return fmt::format("seed {}: {}\n", one.seed, error.what());
  }
}

std::string Processors::run_all(const Case& one) {
  for (const auto& processor : processors_) {
    std::string found = run_on(*processor, one);
    if (!found.empty()) return found;
  }
  return {};
}

std::string Processors::run_on(Processor& processor, const Case& one) {
  CompileOptions options;
  options.mpu = processor.mpu();
  options.config = &processor.config();
  options.search.tries = 1;
  options.waiting_muldiv = one.seed % 4 == 0;  // the other way to compile, now and then
  Diagnostics diagnostics;
  const auto compiled = compile(one.program, options, diagnostics);
  if (!compiled) {
    ++refused_;
    return {};
  }
  ++runs_;
  Machine machine(compiled->image, processor, one.tick_us);
  Lockstep lockstep(one.program, machine);
  const std::size_t scans = std::min(one.events.size(), most_scans_);
  for (std::size_t scan = 0; scan < scans; ++scan) {
    auto difference = lockstep.scan(one.events[scan]);
    if (!difference && scan + 1 == scans) difference = lockstep.compare_state();
    if (difference) {
      return fmt::format("seed {}, MPU{}, tick {} us: {}", one.seed, static_cast<int>(options.mpu),
                         one.tick_us, describe(*difference));
    }
  }
  return {};
}

}  // namespace rung::tb
