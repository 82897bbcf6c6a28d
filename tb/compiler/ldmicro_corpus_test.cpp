// SPDX-License-Identifier: Apache-2.0
// Real and random LDmicro programs, where they are present beside the repository: all are read and
// written but those that LDmicro 2.3 refuses. The files are no part of the project.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "ldmicro_support.hpp"

namespace rung {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(RUNG_REPOSITORY) / "../shared/programs/ldmicro";

// How the first message begins behind the file's name.
const std::map<std::string, std::string> kRefused = {
    {"probes/ton_short.ld", ":13:12: error: TON Ta 10000: 10000 us is too short for a CYCLE"},
    {"probes/pwl_bad.ld", ":13:26: error: PIECEWISE_LINEAR: between x = 0 and 300 the distances"},
    {"samples/frmt_escape/prog.ld", ":19:27: error: FORMATTED_STRING: \\a is no escape"},
};

TEST(LdmicroCorpus, ProgramsAreReadAndWrittenOrRefusedByLine) {
  if (!fs::exists(kFolder)) GTEST_SKIP() << "skipped: no corpus";
  int accepted = 0;
  std::size_t refused = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kFolder)) {
    if (entry.path().extension() != ".ld") continue;
    const std::string file = entry.path().string();
    Diagnostics diagnostics;
    const auto bytes = read_bytes(file, diagnostics);
    ASSERT_TRUE(bytes) << file;
    const ParseResult result = parse_ld(*bytes, file);
    const auto refusal = kRefused.find(fs::relative(entry.path(), kFolder).string());
    if (refusal != kRefused.end()) {
      const std::string start = file + refusal->second;
      EXPECT_FALSE(result.program) << file;
      EXPECT_EQ(result.messages.substr(0, start.size()), start);
      ++refused;
      continue;
    }
    ASSERT_TRUE(result.program) << result.messages;
    expect_ld_round_trip(*result.program);
    ASSERT_FALSE(HasFailure()) << file;
    ++accepted;
  }
  EXPECT_EQ(refused, kRefused.size());
  EXPECT_GE(accepted, 67);
}

}  // namespace
}  // namespace rung
