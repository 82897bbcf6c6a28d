// SPDX-License-Identifier: Apache-2.0
// Random LDmicro programs: the reference, the C back end and the byte code must agree on all
// devices after every scan and on every byte sent. What the programs do is counted, so that nothing
// of compiler/LDMICRO.md goes untested.
//
// RUNG_SEED=N runs program N alone; RUNG_COUNT=N runs that many programs (5,000 if not given).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "agree/c_batch.hpp"
#include "agree/environment.hpp"
#include "agree/ldmicro_case.hpp"
#include "programs/shrink.hpp"

namespace rung::tb {
namespace {

constexpr std::uint64_t kDefaultCount = 5000;
// Programs in one translation unit: what the compiler needs to begin counts less than a program.
constexpr std::uint64_t kBatch = 100;
// One batch in so many goes through the strict compiler.
constexpr std::uint64_t kStrictEvery = 10;

class Agreement {
 public:
  explicit Agreement(std::string name) : name_(std::move(name)) {}

  // Adds program number `seed` to the batch that run() takes.
  void add(std::uint64_t seed) {
    const std::string text = ldmicro_text_of(seed);
    std::string messages;
    std::optional<Case> one = make_ldmicro_case(seed, text, messages);
    ASSERT_TRUE(one) << "seed " << seed << ": the generator made a file that is refused\n"
                     << messages << text;
    cases_.push_back(std::move(*one));
  }

  void run() {
    compiler_ = batches_++ % kStrictEvery == 0 ? CCompiler::Strict : CCompiler::Fast;
    const CRun c = run_as_c(cases_, compiler_, RUNG_SCRATCH, name_);
    for (std::size_t i = 0; i < cases_.size() && i < c.behaviours.size(); ++i) {
      const Behaviour expected = run_ldmicro_reference(cases_[i], &coverage_);
      const std::string found = difference(cases_[i], expected, c.behaviours[i], "C");
      if (!found.empty()) return report(cases_[i], found);
    }
    ASSERT_EQ(c.failure, "");
    programs_ += cases_.size();
    cases_.clear();
  }

  std::uint64_t programs() const { return programs_; }
  const LdmicroCoverage& coverage() const { return coverage_; }

 private:
  // Differs even after elements were taken out.
  void report(const Case& one, const std::string& found) {
    const auto differs = [&](const std::string& text) { return !difference_of(one, text).empty(); };
    const std::string small = shrink_ldmicro(one.text, differs);
    FAIL() << found << "replay: RUNG_SEED=" << one.seed
           << " build/test/tb/agree/agree_ldmicro_random\n"
           << one.text << "the same with fewer elements: " << difference_of(one, small) << small;
  }

  std::string difference_of(const Case& original, const std::string& text) const {
    std::string messages;
    const std::optional<Case> one = make_ldmicro_case(original.seed, text, messages, &original);
    if (!one) return {};
    const CRun c = run_as_c({&*one, 1}, compiler_, RUNG_SCRATCH, name_ + "-shrink");
    if (c.behaviours.empty()) return {};
    return difference(*one, run_ldmicro_reference(*one), c.behaviours[0], "C");
  }

  std::string name_;
  std::vector<Case> cases_;
  LdmicroCoverage coverage_;
  CCompiler compiler_ = CCompiler::Strict;
  std::uint64_t batches_ = 0;
  std::uint64_t programs_ = 0;
};

// Two tests, so that two cores share the programs.
class RandomLdmicro : public testing::TestWithParam<int> {};

TEST_P(RandomLdmicro, ReferenceAndCAgree) {
  Agreement agreement(fmt::format("ldmicro{}", GetParam()));
  if (std::getenv("RUNG_SEED") != nullptr) {
    if (GetParam() != 0) return;
    agreement.add(from_environment("RUNG_SEED", 0));
    if (!HasFatalFailure()) agreement.run();
    return;
  }
  const std::uint64_t count = from_environment("RUNG_COUNT", kDefaultCount);
  std::uint64_t waiting = 0;
  for (std::uint64_t seed = GetParam(); seed < count; seed += 2) {
    agreement.add(seed);
    if (HasFatalFailure()) return;
    if (++waiting < kBatch && seed + 2 < count) continue;
    agreement.run();
    if (HasFatalFailure()) return;
    waiting = 0;
  }
  fmt::print("{} programs\n", agreement.programs());
  if (std::getenv("RUNG_COVERAGE") != nullptr) {
    for (const auto& [key, times] : agreement.coverage().all()) fmt::print("{:8} {}\n", times, key);
  }
}

INSTANTIATE_TEST_SUITE_P(Halves, RandomLdmicro, testing::Values(0, 1));

}  // namespace
}  // namespace rung::tb
