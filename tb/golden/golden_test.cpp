// SPDX-License-Identifier: Apache-2.0
// Every program of tb/golden/programs against its golden trace, on every engine.
#include "golden/golden.hpp"

#include <gtest/gtest.h>

#include "reference/run.hpp"
#include "trace/compare.hpp"

namespace rung::tb {
namespace {

class Golden : public testing::TestWithParam<std::string> {
 protected:
  void run(const image::Image& image) {
    const LoadedMachine loaded = load_machine(image, program_.golden().header.tick_us);
    const auto difference = program_.difference(image, *loaded.machine);
    ASSERT_FALSE(difference) << *difference;
    ++ran_;
  }

  GoldenProgram program_{GetParam()};
  int ran_ = 0;
};

TEST_P(Golden, Reference) {
  const Trace& golden = program_.golden();
  ReferenceRun engine(program_.program(), true, golden.header.tick_us);
  TraceComparison comparison(false);
  for (std::size_t k = 0; k < golden.scans.size(); ++k) {
    const auto difference =
        comparison.next(golden.scans[k], engine.scan(program_.stimulus().events(k)));
    ASSERT_FALSE(difference) << describe(*difference);
  }
  EXPECT_GE(golden.scans.size(), 5U);
}

TEST_P(Golden, Processors) {
  for (const isa::Config* config : distinct_configs()) {
    for (const isa::Mpu mpu : {isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3}) {
      for (const bool paper : {false, true}) {
        if (paper && !program_.in_table_4()) continue;
        const auto image = program_.compile(mpu, paper, *config);
        if (!image) continue;
        ASSERT_NO_FATAL_FAILURE(run(*image));
      }
    }
  }
  EXPECT_GE(ran_, 3) << "every program fits the largest configuration";
}

TEST_P(Golden, WideProcessor) {
  for (const int slots : {4, 8, 16}) {
    for (const bool merge : {true, false}) {
      ASSERT_NO_FATAL_FAILURE(run(program_.compile_wide(slots, merge)));
    }
  }
  EXPECT_EQ(ran_, 6);
}

INSTANTIATE_TEST_SUITE_P(Programs, Golden, testing::ValuesIn(golden_names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace rung::tb
