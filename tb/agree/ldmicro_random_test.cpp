// SPDX-License-Identifier: Apache-2.0
// Random LDmicro programs: the reference, the C back end and the byte code must agree on all
// devices after every scan and on every byte sent. What the programs do is counted, so that nothing
// of compiler/LDMICRO.md goes untested.
//
// RUNG_SEED=N runs program N alone; RUNG_COUNT=N runs that many programs (5,000 if not given).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "agree/c_batch.hpp"
#include "agree/environment.hpp"
#include "agree/ldmicro_case.hpp"
#include "agree/vm_run.hpp"
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
      const std::string found = difference_of(cases_[i], expected, c.behaviours[i]);
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

  // Of C, or if it does the same, of byte code.
  static std::string difference_of(const Case& one, const Behaviour& expected, const Behaviour& c) {
    std::string found = difference(one, expected, c, "C");
    if (!found.empty()) return found;
    try {
      return difference(one, expected, run_as_bytecode(one), "byte code");
    } catch (const std::runtime_error& error) {
      return fmt::format("seed {}: byte code: {}\n", one.seed, error.what());
    }
  }

  std::string difference_of(const Case& original, const std::string& text) const {
    std::string messages;
    const std::optional<Case> one = make_ldmicro_case(original.seed, text, messages, &original);
    if (!one) return {};
    const CRun c = run_as_c({&*one, 1}, compiler_, RUNG_SCRATCH, name_ + "-shrink");
    if (c.behaviours.empty()) return {};
    return difference_of(*one, run_ldmicro_reference(*one), c.behaviours[0]);
  }

  std::string name_;
  std::vector<Case> cases_;
  LdmicroCoverage coverage_;
  CCompiler compiler_ = CCompiler::Strict;
  std::uint64_t batches_ = 0;
  std::uint64_t programs_ = 0;
};

// What each half of the programs does so often at least: the conditions that an element meets and
// gives, and what can happen in it.
constexpr std::uint64_t kLeastTimes = 20;
constexpr const char* kToHappen[] = {"CONTACTS 0>0",
                                     "CONTACTS 1>0",
                                     "CONTACTS 1>1",
                                     "CONTACTS negated 0>0",
                                     "CONTACTS negated 1>0",
                                     "CONTACTS negated 1>1",
                                     "COIL 0>0",
                                     "COIL 1>1",
                                     "COIL negated 0>0",
                                     "COIL negated 1>1",
                                     "COIL set 0>0",
                                     "COIL set 1>1",
                                     "COIL reset 0>0",
                                     "COIL reset 1>1",
                                     "SHORT 0>0",
                                     "SHORT 1>1",
                                     "OPEN 0>0",
                                     "OPEN 1>0",
                                     "OSR 0>0",
                                     "OSR 1>0",
                                     "OSR 1>1",
                                     "OSF 0>0",
                                     "OSF 0>1",
                                     "OSF 1>0",
                                     "EQU 0>0",
                                     "EQU 1>0",
                                     "EQU 1>1",
                                     "NEQ 0>0",
                                     "NEQ 1>0",
                                     "NEQ 1>1",
                                     "GRT 0>0",
                                     "GRT 1>0",
                                     "GRT 1>1",
                                     "GEQ 0>0",
                                     "GEQ 1>0",
                                     "GEQ 1>1",
                                     "LES 0>0",
                                     "LES 1>0",
                                     "LES 1>1",
                                     "LEQ 0>0",
                                     "LEQ 1>0",
                                     "LEQ 1>1",
                                     "MASTER_RELAY 0>0",
                                     "MASTER_RELAY 1>1",
                                     "rung on",
                                     "rung off",
                                     "TON 0>0",
                                     "TON 1>0",
                                     "TON 1>1",
                                     "TOF 0>0",
                                     "TOF 0>1",
                                     "TOF 1>1",
                                     "RTO 0>0",
                                     "RTO 0>1",
                                     "RTO 1>0",
                                     "RTO 1>1",
                                     "timer beyond its limit",
                                     "timer below zero",
                                     "RES 0>0",
                                     "RES 1>1",
                                     "CTU 0>0",
                                     "CTU 0>1",
                                     "CTU 1>0",
                                     "CTU 1>1",
                                     "CTU wraps",
                                     "CTD 0>0",
                                     "CTD 0>1",
                                     "CTD 1>0",
                                     "CTD 1>1",
                                     "CTD wraps",
                                     "CTC 0>0",
                                     "CTC 1>1",
                                     "CTC begins again",
                                     "MOVE 0>0",
                                     "MOVE 1>1",
                                     "ADD 0>0",
                                     "ADD 1>1",
                                     "ADD wraps",
                                     "SUB 0>0",
                                     "SUB 1>1",
                                     "SUB wraps",
                                     "MUL 0>0",
                                     "MUL 1>1",
                                     "MUL wraps",
                                     "DIV 0>0",
                                     "DIV 1>1",
                                     "DIV by zero",
                                     "DIV beyond 16 bits",
                                     "DIV rounds up",
                                     "SHIFT_REGISTER 0>0",
                                     "SHIFT_REGISTER 1>1",
                                     "SHIFT_REGISTER shifts",
                                     "LOOK_UP_TABLE 0>0",
                                     "LOOK_UP_TABLE row",
                                     "LOOK_UP_TABLE several rows",
                                     "LOOK_UP_TABLE beyond",
                                     "PIECEWISE_LINEAR 0>0",
                                     "PIECEWISE_LINEAR below",
                                     "PIECEWISE_LINEAR within",
                                     "PIECEWISE_LINEAR above",
                                     "PIECEWISE_LINEAR of one point",
                                     "READ_ADC 0>0",
                                     "READ_ADC 1>1",
                                     "SET_PWM 0>0",
                                     "SET_PWM 1>1",
                                     "PERSIST 0>0",
                                     "PERSIST 1>1",
                                     "PERSIST restores",
                                     "PERSIST keeps",
                                     "UART_SEND 0>0",
                                     "UART_SEND 0>1",
                                     "UART_SEND 1>1",
                                     "UART_SEND sends",
                                     "UART_RECV 0>0",
                                     "UART_RECV 1>0",
                                     "UART_RECV 1>1",
                                     "FORMATTED_STRING 0>0",
                                     "FORMATTED_STRING 0>1",
                                     "FORMATTED_STRING 1>0",
                                     "FORMATTED_STRING 1>1",
                                     "FORMATTED_STRING sends",
                                     "string below zero",
                                     "PARALLEL in 0",
                                     "PARALLEL in 1",
                                     "PARALLEL in 2",
                                     "PARALLEL of one branch",
                                     "branch without elements",
                                     "rung without elements",
                                     "name of both kinds",
                                     "COMMENT"};

// Two tests, so that two cores share the programs.
class RandomLdmicro : public testing::TestWithParam<int> {};

TEST_P(RandomLdmicro, ReferenceCAndByteCodeAgree) {
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
  if (count < kDefaultCount) return;
  for (const char* const key : kToHappen) {
    EXPECT_GE(agreement.coverage().of(key), kLeastTimes) << key;
  }
}

INSTANTIATE_TEST_SUITE_P(Halves, RandomLdmicro, testing::Values(0, 1));

}  // namespace
}  // namespace rung::tb
