// SPDX-License-Identifier: Apache-2.0
// Random lists: reference and byte code must agree on all devices after every scan.
//
// RUNG_SEED=N runs program N alone; RUNG_COUNT=N runs that many programs (2,000 if not given);
// RUNG_FAMILIES=timers,zones keeps to these families (programs/random_melsec.hpp).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "agree/case.hpp"
#include "agree/environment.hpp"
#include "agree/vm_run.hpp"
#include "programs/shrink.hpp"

namespace rung::tb {
namespace {

constexpr std::uint64_t kDefaultCount = 2000;

// The first difference, or nothing.
std::string run(const Case& one) {
  try {
    return difference(one, run_reference(one), run_as_bytecode(one), "byte code");
  } catch (const std::exception& error) {
    return fmt::format("seed {}: {}\n", one.seed, error.what());
  }
}

std::string difference_of(const Case& original, const std::string& text) {
  std::string messages;
  const std::optional<Case> one = make_case(original.seed, text, messages, &original);
  return one ? run(*one) : std::string();
}

void check(std::uint64_t seed, const std::vector<Family>& families) {
  const std::string text = text_of(seed, families);
  std::string messages;
  const std::optional<Case> one = make_case(seed, text, messages);
  ASSERT_TRUE(one) << "seed " << seed << ": the generator made a list that is refused\n"
                   << messages << text;
  const std::string found = run(*one);
  if (found.empty()) return;
  const auto differs = [&](const std::string& less) { return !difference_of(*one, less).empty(); };
  const std::string small = shrink(text, differs);
  FAIL() << found << "replay: " << replay_families() << "RUNG_SEED=" << seed
         << " build/test/tb/bytecode/bytecode_agree\n"
         << text << "the same with fewer lines: " << difference_of(*one, small) << small;
}

TEST(RandomMelsec, ReferenceAndByteCodeAgree) {
  const std::vector<Family> families = families_of_environment();
  if (std::getenv("RUNG_SEED") != nullptr) {
    return check(from_environment("RUNG_SEED", 0), families);
  }
  const std::uint64_t count = from_environment("RUNG_COUNT", kDefaultCount);
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    check(seed, families);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace rung::tb
