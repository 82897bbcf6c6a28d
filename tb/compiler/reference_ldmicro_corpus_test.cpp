// SPDX-License-Identifier: Apache-2.0
// LDmicro programs that nobody here wrote, if they are there: the reference shows what LDmicro's
// own simulator has shown, value for value and scan for scan.
#include <gtest/gtest.h>

#include "programs/ldmicro_corpus.hpp"
#include "reference/run.hpp"

namespace rung {
namespace {

// What 2.3 refuses is refused here too.
struct Refused {
  const char* name;
  const char* message;  // a part of ours
};
constexpr Refused kRefused[] = {
    {"probes/pwl_bad", "PIECEWISE_LINEAR"},
    {"probes/ton_short", "TON"},
    {"samples/frmt_escape", "escape"},
};

TEST(ReferenceLdmicroCorpus, ShowsWhatTheSimulatorShowed) {
  const auto samples = ldmicro_samples(RUNG_REPOSITORY "/../shared");
  if (samples.empty()) GTEST_SKIP() << "skipped: no corpus";
  std::size_t scans = 0;
  int refused = 0, deviations = 0;
  for (const LdmicroSample& sample : samples) {
    SCOPED_TRACE(sample.name);
    const LdmicroCase loaded = load_ldmicro(sample);
    const auto refusal =
        std::find_if(std::begin(kRefused), std::end(kRefused),
                     [&](const Refused& each) { return sample.name == each.name; });
    if (refusal != std::end(kRefused)) {
      EXPECT_FALSE(loaded.program);
      EXPECT_NE(loaded.messages.find(refusal->message), std::string::npos) << loaded.messages;
      ++refused;
      continue;
    }
    ASSERT_TRUE(loaded.program) << loaded.messages;
    ReferenceRun run(*loaded.program, true);
    const auto difference = compare_ldmicro(loaded, [&](auto events) { return run.scan(events); });
    EXPECT_FALSE(difference) << describe(*difference);
    for (const LdmicroDeviation& deviation : ldmicro_deviations()) {
      if (sample.name != deviation.name) continue;
      EXPECT_EQ(loaded.trace.scans.size(), deviation.scans) << deviation.why;
      EXPECT_TRUE(loaded.trace.stop);
      ++deviations;
    }
    scans += loaded.trace.scans.size();
  }
  EXPECT_EQ(refused, static_cast<int>(std::size(kRefused)));
  EXPECT_EQ(deviations, static_cast<int>(ldmicro_deviations().size()));
  // So many are there to be met.
  EXPECT_GT(scans, 24000U);
}

// The one deviation: the target keeps its value, and the error flag says so.
TEST(ReferenceLdmicroCorpus, DivisionByZeroGoesOn) {
  for (const LdmicroSample& sample : ldmicro_samples(RUNG_REPOSITORY "/../shared")) {
    if (sample.name != "probes/div0") continue;
    const LdmicroCase loaded = load_ldmicro(sample);
    ASSERT_TRUE(loaded.program) << loaded.messages;
    Reference reference(*loaded.program);
    const Device target = *DeviceNames(*loaded.program).device("d");
    for (std::uint64_t scan = 0; scan < loaded.stimulus.scans(); ++scan) {
      for (const StimulusEvent& event : loaded.stimulus.events(scan)) {
        reference.set(event.device, event.value);
      }
      reference.run_scan();
      EXPECT_EQ(reference.error(), scan > 0);
      EXPECT_EQ(reference.get(target), 7);
    }
    return;
  }
  GTEST_SKIP() << "skipped: no corpus";
}

}  // namespace
}  // namespace rung
