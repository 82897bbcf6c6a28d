// SPDX-License-Identifier: Apache-2.0
// Random programs of all instructions: the reference and the C back end are two readings of
// compiler/SEMANTICS.md, and all devices must be equal after every scan.
//
// RUNG_SEED=N runs program N alone; RUNG_COUNT=N runs that many programs (10,000 if not given);
// RUNG_FAMILIES=timers,zones keeps to these families (programs/random_melsec.hpp).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "agree/c_batch.hpp"
#include "agree/case.hpp"
#include "agree/environment.hpp"
#include "melsec/instructions.hpp"
#include "programs/shrink.hpp"

namespace rung::tb {
namespace {

constexpr std::uint64_t kDefaultCount = 10000;
// Programs in one translation unit: what the compiler needs to begin counts less than a program.
constexpr std::uint64_t kBatch = 100;
// Every form of every instruction is used so often at least in each dialect and half.
constexpr std::uint64_t kLeastUses = 10;
// One batch in so many goes through the strict compiler.
constexpr std::uint64_t kStrictEvery = 10;

class Agreement {
 public:
  explicit Agreement(std::string name)
      : name_(std::move(name)), families_(families_of_environment()) {}

  // Adds program number `seed` to the batch that run() takes.
  void add(std::uint64_t seed) {
    const std::string text = text_of(seed, families_);
    std::string messages;
    std::optional<Case> one = make_case(seed, text, messages);
    ASSERT_TRUE(one) << "seed " << seed << ": the generator made a list that is refused\n"
                     << messages << text;
    coverage_[one->program.dialect].count(text);
    cases_.push_back(std::move(*one));
  }

  void run() {
    compiler_ = batches_++ % kStrictEvery == 0 ? CCompiler::Strict : CCompiler::Fast;
    const CRun c = run_as_c(cases_, compiler_, RUNG_SCRATCH, name_);
    for (std::size_t i = 0; i < cases_.size() && i < c.behaviours.size(); ++i) {
      const std::string found =
          difference(cases_[i], run_reference(cases_[i]), c.behaviours[i], "C");
      if (!found.empty()) return report(cases_[i], found);
    }
    ASSERT_EQ(c.failure, "");
    programs_ += cases_.size();
    cases_.clear();
  }

  std::uint64_t programs() const { return programs_; }
  const MelsecCoverage& coverage(Dialect dialect) { return coverage_[dialect]; }

 private:
  // Differs even after lines were taken out.
  void report(const Case& one, const std::string& found) {
    const auto differs = [&](const std::string& text) { return !difference_of(one, text).empty(); };
    const std::string small = shrink(one.text, differs);
    FAIL() << found << "replay: " << replay_families() << "RUNG_SEED=" << one.seed
           << " build/test/tb/agree/agree_random\n"
           << one.text << "the same with fewer lines: " << difference_of(one, small) << small;
  }

  std::string difference_of(const Case& original, const std::string& text) const {
    std::string messages;
    const std::optional<Case> one = make_case(original.seed, text, messages, &original);
    if (!one) return {};
    const CRun c = run_as_c({&*one, 1}, compiler_, RUNG_SCRATCH, name_ + "-shrink");
    return c.behaviours.empty() ? "" : difference(*one, run_reference(*one), c.behaviours[0], "C");
  }

  std::string name_;
  std::vector<Family> families_;
  std::vector<Case> cases_;
  std::map<Dialect, MelsecCoverage> coverage_;
  CCompiler compiler_ = CCompiler::Strict;
  std::uint64_t batches_ = 0;
  std::uint64_t programs_ = 0;
};

void expect_every_instruction(const MelsecCoverage& coverage, Dialect dialect) {
  for (const std::string_view name : instruction_names()) {
    const auto forms = find_instruction(name);
    if (std::any_of(forms.begin(), forms.end(), [&](const InstructionForm& form) {
          return (form.row->dialects & dialect_bit(dialect)) != 0;
        })) {
      EXPECT_GT(coverage.of(std::string(name)), kLeastUses)
          << name << " in " << dialect_name(dialect);
    }
  }
  for (const char* const key : {"OUT T", "OUT C", "OUT D", "RST T", "RST C", "RST D", "SET D",
                                "LD D", "word bit", "index", "digits"}) {
    EXPECT_GT(coverage.of(key), kLeastUses) << key << " in " << dialect_name(dialect);
  }
}

// Two tests, so that two cores share the programs.
class RandomMelsec : public testing::TestWithParam<int> {};

TEST_P(RandomMelsec, ReferenceAndCAgree) {
  Agreement agreement(fmt::format("agree{}", GetParam()));
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
  if (count < kDefaultCount || std::getenv("RUNG_FAMILIES") != nullptr) return;
  for (const Dialect dialect : {Dialect::Fx, Dialect::Q}) {
    expect_every_instruction(agreement.coverage(dialect), dialect);
  }
}

INSTANTIATE_TEST_SUITE_P(Halves, RandomMelsec, testing::Values(0, 1));

}  // namespace
}  // namespace rung::tb
