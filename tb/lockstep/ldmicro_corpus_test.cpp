// SPDX-License-Identifier: Apache-2.0
// LDmicro programs that nobody here wrote, if they are there: each one runs on all four processors
// as LDmicro's own simulator has shown it, value for value and scan for scan, and as the reference.
#include "programs/ldmicro_corpus.hpp"

#include <gtest/gtest.h>

#include "driver/compile.hpp"
#include "lockstep/lockstep.hpp"
#include "lockstep/machine.hpp"
#include "lockstep/wide_machine.hpp"

namespace rung::tb {
namespace {

class LdmicroCorpus : public testing::TestWithParam<isa::Mpu> {};

TEST_P(LdmicroCorpus, RunsAsTheSimulatorShowed) {
  const auto samples = ldmicro_samples(RUNG_REPOSITORY "/../shared");
  if (samples.empty()) GTEST_SKIP() << "skipped: no corpus";
  const isa::Config& config = isa::configs().front();
  CompileOptions options;
  options.mpu = GetParam();
  options.config = &config;
  const bool wide = GetParam() == isa::Mpu::Mpu4;
  const auto processor = wide ? nullptr : make_processor(GetParam(), config);
  const auto wide_processor = wide ? make_wide_processor(options.slots) : nullptr;
  std::size_t scans = 0;
  for (const LdmicroSample& sample : samples) {
    SCOPED_TRACE(sample.name);
    const LdmicroCase loaded = load_ldmicro(sample);
    if (!loaded.program) continue;  // the front end's tests know which ones, and why
    Diagnostics diagnostics;
    const auto compiled = compile(*loaded.program, options, diagnostics);
    ASSERT_TRUE(compiled);
    std::unique_ptr<AnyMachine> machine;
    if (wide) {
      machine = std::make_unique<WideMachine>(compiled->image, *wide_processor);
    } else {
      machine = std::make_unique<Machine>(compiled->image, *processor);
    }
    Lockstep lockstep(*loaded.program, *machine);
    MachineRun run(*machine, true);
    const auto scan = [&](std::span<const StimulusEvent> events) {
      const auto difference = lockstep.scan(events);
      EXPECT_FALSE(difference) << describe(*difference);
      return run.record(events, lockstep.result());
    };
    const auto difference = compare_ldmicro(loaded, scan);
    ASSERT_FALSE(difference) << describe(*difference);
    const auto ports = lockstep.compare_state();
    ASSERT_FALSE(ports) << describe(*ports);
    ASSERT_FALSE(HasFailure());
    scans += loaded.trace.scans.size();
  }
  EXPECT_GT(scans, 24000U);
}

INSTANTIATE_TEST_SUITE_P(Processors, LdmicroCorpus,
                         testing::Values(isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3,
                                         isa::Mpu::Mpu4),
                         [](const auto& info) {
                           return "Mpu" + std::to_string(static_cast<int>(info.param));
                         });

}  // namespace
}  // namespace rung::tb
