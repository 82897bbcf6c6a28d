// SPDX-License-Identifier: Apache-2.0
// LDmicro programs that nobody here wrote, if they are there, as C: each shows what LDmicro's own
// simulator has shown, value for value and scan for scan.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "agree/c_batch.hpp"
#include "backends/c_writer.hpp"
#include "programs/ldmicro_corpus.hpp"

namespace rung::tb {
namespace {

// Those that are not refused; the front end's tests know which ones are, and why.
std::vector<LdmicroCase> accepted() {
  std::vector<LdmicroCase> loaded;
  for (const LdmicroSample& sample : ldmicro_samples(RUNG_REPOSITORY "/../shared")) {
    LdmicroCase one = load_ldmicro(sample);
    if (one.program) loaded.push_back(std::move(one));
  }
  return loaded;
}

Case case_of(const LdmicroCase& loaded) {
  Case one;
  one.program = *loaded.program;
  for (const auto& [device, name] : one.program.names) {
    if (!is_hidden(device.kind)) one.devices.push_back(device);
  }
  for (std::uint64_t scan = 0; scan < loaded.stimulus.scans(); ++scan) {
    const auto events = loaded.stimulus.events(scan);
    one.events.emplace_back(events.begin(), events.end());
  }
  return one;
}

TEST(LdmicroCCorpus, ShowsWhatTheSimulatorShowed) {
  const std::vector<LdmicroCase> loaded = accepted();
  if (loaded.empty()) GTEST_SKIP() << "skipped: no corpus";
  std::vector<Case> cases;
  for (const LdmicroCase& one : loaded) cases.push_back(case_of(one));
  const CRun c = run_as_c(cases, CCompiler::Strict, RUNG_SCRATCH, "ldmicro_corpus");
  ASSERT_EQ(c.failure, "");
  ASSERT_EQ(c.behaviours.size(), loaded.size());
  std::size_t scans = 0;
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    SCOPED_TRACE(loaded[i].program->file);
    const Behaviour& behaviour = c.behaviours[i];
    std::size_t next = 0;
    const auto scan = [&](std::span<const StimulusEvent>) {
      TraceScan shown;
      shown.scan = static_cast<std::int64_t>(next);
      shown.state.emplace();
      for (std::size_t device = 0; device < cases[i].devices.size(); ++device) {
        shown.state->push_back({device_name(cases[i].devices[device], cases[i].program),
                                behaviour.states.at(next)[device]});
      }
      shown.tx = behaviour.sent.at(next++);
      return shown;
    };
    const auto difference = compare_ldmicro(loaded[i], scan);
    EXPECT_FALSE(difference) << describe(*difference);
    scans += loaded[i].trace.scans.size();
  }
  // So many are there to be met.
  EXPECT_GT(scans, 24000U);
}

// As users get them, with hooks.
TEST(LdmicroCCorpus, CompilesWithoutAWarning) {
  const std::vector<LdmicroCase> loaded = accepted();
  if (loaded.empty()) GTEST_SKIP() << "skipped: no corpus";
  const std::string base = RUNG_SCRATCH "/ldmicro_hooks";
  {
    std::ofstream file(base + ".c");
    for (std::size_t i = 0; i < loaded.size(); ++i) {
      file << write_c(*loaded[i].program, {.prefix = fmt::format("Program{}_", i)});
    }
  }
  const int failed = std::system(
      fmt::format("'{0}' -std=c99 -Wall -Wextra -pedantic -Wmissing-prototypes -Wconversion "
                  "-Werror -c -o '{1}.o' '{1}.c' >'{1}.log' 2>&1",
                  RUNG_C_COMPILER, base)
          .c_str());
  std::ifstream log(base + ".log");
  EXPECT_EQ(failed, 0) << std::string(std::istreambuf_iterator<char>(log), {}).substr(0, 4000);
}

}  // namespace
}  // namespace rung::tb
