// SPDX-License-Identifier: Apache-2.0
// Random programs of all instructions: the three processors against the reference, scan by scan.
//
// RUNG_SEED=N runs program N alone; RUNG_COUNT=N runs that many programs (10,000 if not given);
// RUNG_FAMILIES=timers,zones keeps to these families (programs/random_melsec.hpp).
#include "agree/processors.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "agree/case.hpp"
#include "agree/environment.hpp"
#include "programs/shrink.hpp"

namespace rung::tb {
namespace {

constexpr std::uint64_t kDefaultCount = 10000;
// Of the up to 20 scans that the C back end is compared over: what a processor does in one scan
// does not depend on how many came before.
constexpr std::size_t kMostScans = 8;

// Two tests, so that two cores share the programs.
class RandomMelsec : public testing::TestWithParam<int> {
 protected:
  void check(std::uint64_t seed) {
    const std::string text = text_of(seed, families_);
    std::string messages;
    const std::optional<Case> one = make_case(seed, text, messages);
    ASSERT_TRUE(one) << "seed " << seed << ": the generator made a list that is refused\n"
                     << messages << text;
    const std::string found = processors_.run(*one);
    if (found.empty()) return;
    const auto difference_of = [&](const std::string& part) {
      std::string ignored;
      const std::optional<Case> smaller = make_case(seed, part, ignored, &*one);
      return smaller ? processors_.run(*smaller) : std::string();
    };
    const std::string small =
        shrink(text, [&](const std::string& part) { return !difference_of(part).empty(); });
    FAIL() << found << "replay: " << replay_families() << "RUNG_SEED=" << seed
           << " build/test/tb/agree/agree_processors\n"
           << text << "the same with fewer lines: " << difference_of(small) << small;
  }

  std::vector<Family> families_ = families_of_environment();
  Processors processors_{kMostScans};
};

TEST_P(RandomMelsec, ProcessorsAgree) {
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
  // A few nest too deep for MPU1's stacks, or need more words than there are.
  EXPECT_LT(processors_.refused() * 20, processors_.runs());
}

// Indexed pairs that overlap: which one is written last depends on the indexes.
TEST(OverlappingPairs, AreExchangedAsTheReferenceDoes) {
  Processors processors(20);
  for (const char* text : {"LDI D0.B\nDXCH D0Z0 D3Z1\nEND\n", "LD X0\nDXCH D2 D1Z0\nEND\n",
                           "LD X0\nDXCH D4Z1 D5\nXCH D1Z0 D1\nEND\n"}) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      std::string messages;
      const std::optional<Case> one = make_case(seed, text, messages);
      ASSERT_TRUE(one) << messages;
      ASSERT_EQ(processors.run(*one), "") << text;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Halves, RandomMelsec, testing::Values(0, 1));

}  // namespace
}  // namespace rung::tb
