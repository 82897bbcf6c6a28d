// SPDX-License-Identifier: Apache-2.0
// Random LDmicro programs: the three processors against the reference, scan by scan, bytes sent
// included.
//
// RUNG_SEED=N runs program N alone; RUNG_COUNT=N runs that many programs (5,000 if not given).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "agree/environment.hpp"
#include "agree/ldmicro_case.hpp"
#include "agree/processors.hpp"
#include "programs/shrink.hpp"

namespace rung::tb {
namespace {

constexpr std::uint64_t kDefaultCount = 5000;
// All scans of a case: a string takes two of them a byte.
constexpr std::size_t kMostScans = 30;

// Two tests, so that two cores share the programs.
class RandomLdmicro : public testing::TestWithParam<int> {
 protected:
  void check(std::uint64_t seed) {
    const std::string text = ldmicro_text_of(seed);
    std::string messages;
    const std::optional<Case> one = make_ldmicro_case(seed, text, messages);
    ASSERT_TRUE(one) << "seed " << seed << ": the generator made a file that is refused\n"
                     << messages << text;
    const std::string found = processors_.run(*one);
    if (found.empty()) return;
    const auto difference_of = [&](const std::string& part) {
      std::string ignored;
      const std::optional<Case> smaller = make_ldmicro_case(seed, part, ignored, &*one);
      return smaller ? processors_.run(*smaller) : std::string();
    };
    const std::string small =
        shrink_ldmicro(text, [&](const std::string& part) { return !difference_of(part).empty(); });
    FAIL() << found << "replay: RUNG_SEED=" << seed
           << " build/test/tb/agree/agree_ldmicro_processors\n"
           << text << "the same with fewer elements: " << difference_of(small) << small;
  }

  Processors processors_{kMostScans};
};

TEST_P(RandomLdmicro, ProcessorsAgree) {
  if (std::getenv("RUNG_SEED") != nullptr) {
    if (GetParam() == 0) check(from_environment("RUNG_SEED", 0));
    return;
  }
  const std::uint64_t count = from_environment("RUNG_COUNT", kDefaultCount);
  for (std::uint64_t seed = GetParam(); seed < count; seed += 2) {
    check(seed);
    if (HasFatalFailure()) return;
  }
  fmt::print("{} runs; {} programs too large for a processor\n", processors_.runs(),
             processors_.refused());
  EXPECT_LT(processors_.refused() * 20, processors_.runs());
}

INSTANTIATE_TEST_SUITE_P(Halves, RandomLdmicro, testing::Values(0, 1));

}  // namespace
}  // namespace rung::tb
