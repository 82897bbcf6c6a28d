// SPDX-License-Identifier: Apache-2.0
// Random programs on few devices, so that every hazard comes up again and again, against the step
// model. RUNG_SEED=n runs one seed; RUNG_PROGRAMS=n says how many programs a processor gets.
#include <fmt/format.h>

#include <cstdlib>

#include "unit/random_steps.hpp"

namespace rung::tb {
namespace {

int from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoi(text);
}

class RandomPrograms : public testing::TestWithParam<Target> {};

TEST_P(RandomPrograms, EqualTheStepModel) {
  constexpr int kSteps = 200;
  constexpr int kScans = 2;
  const int seed_only = from_environment("RUNG_SEED", -1);
  const int programs = seed_only >= 0 ? 1 : from_environment("RUNG_PROGRAMS", 40);
  Bench bench(GetParam());
  for (int i = 0; i < programs; ++i) {
    const int seed = seed_only >= 0 ? seed_only : 1 + i;
    RandomSteps random(GetParam(), static_cast<std::uint32_t>(seed));
    random.fill(bench);
    const std::string replay = fmt::format(
        "seed {}; replay: RUNG_SEED={} unit_rtl --gtest_filter='*RandomPrograms*/mpu{}_{}'", seed,
        seed, static_cast<int>(bench.mpu()), bench.config().name);
    const std::vector<Step> program = random.program(kSteps);
    ASSERT_TRUE(bench.scan(program)) << replay;
    for (int scan = 1; scan < kScans; ++scan) ASSERT_TRUE(bench.scan_again()) << replay;
    ASSERT_TRUE(bench.devices_equal()) << replay;
  }
}

INSTANTIATE_TEST_SUITE_P(Rtl, RandomPrograms, testing::ValuesIn(targets(kAllMpus)), target_name);

}  // namespace
}  // namespace rung::tb
