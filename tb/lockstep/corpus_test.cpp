// SPDX-License-Identifier: Apache-2.0
// Real programs that nobody here wrote, if they are there: each one that the front end takes runs
// 1,000 scans under random inputs on all three processors, beside the reference. Those it refuses
// are the front end's tests' matter; reports/programs.md names both kinds.
//
// RUNG_SCANS=N runs that many scans instead of 1,000.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "driver/compile.hpp"
#include "lockstep/lockstep.hpp"
#include "lockstep/machine.hpp"
#include "melsec/melsec.hpp"
#include "programs/random_source.hpp"
#include "rungs/special.hpp"

namespace rung::tb {
namespace {

namespace fs = std::filesystem;

int scans() {
  const char* text = std::getenv("RUNG_SCANS");
  return text == nullptr ? 1000 : std::atoi(text);
}

// False if the configuration is too small for the program.
bool run(const Program& program, isa::Mpu mpu, const isa::Config& config, std::uint64_t seed) {
  CompileOptions options;
  options.mpu = mpu;
  options.config = &config;
  Diagnostics diagnostics;
  const auto compiled = compile(program, options, diagnostics);
  if (!compiled) return false;
  const auto processor = make_processor(mpu, config);
  Machine machine(compiled->image, *processor);
  Lockstep lockstep(program, machine);
  RandomSource random(seed);
  for (int scan = 0, count = scans(); scan < count; ++scan) {
    std::vector<StimulusEvent> events;
    for (const Device device : named_devices(program)) {
      const SpecialRange* special = find_special(device, program.dialect);
      if (special != nullptr && is_driven(special->role)) continue;
      if (!random.percent(is_input(device) ? 40 : 5)) continue;
      const auto value = static_cast<std::int16_t>(random.bits());
      events.push_back({device, is_word(device) ? value : static_cast<std::int16_t>(value & 1)});
    }
    auto difference = lockstep.scan(events);
    if (!difference) difference = lockstep.compare_state();
    if (difference) {
      ADD_FAILURE() << program.file << ", seed " << seed << "\n" << describe(*difference);
      return true;
    }
  }
  return true;
}

TEST(Corpus, ProgramsRunAsTheReference) {
  const fs::path folder = fs::path(RUNG_REPOSITORY) / "../shared/programs/melsec";
  if (!fs::is_directory(folder)) GTEST_SKIP() << "skipped: no corpus";
  std::vector<fs::path> lists;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string suffix = entry.path().extension().string();
    if (suffix == ".lst" || suffix == ".esc" || suffix == ".txt" || suffix == ".csv") {
      lists.push_back(entry.path());
    }
  }
  std::sort(lists.begin(), lists.end());
  int ran = 0;
  for (const fs::path& list : lists) {
    Diagnostics diagnostics;
    const auto source = read_text(list.string(), diagnostics);
    ASSERT_TRUE(source) << list;
    const auto program = parse_melsec(*source, std::nullopt, diagnostics);
    if (!program) continue;
    SCOPED_TRACE(list.string());
    for (const isa::Config* config : distinct_configs()) {
      for (const isa::Mpu mpu : {isa::Mpu::Mpu1, isa::Mpu::Mpu2, isa::Mpu::Mpu3}) {
        const bool fits = run(*program, mpu, *config, 2013);
        EXPECT_TRUE(fits || config != isa::configs().data()) << "the largest holds them all";
        if (HasFailure()) return;
      }
    }
    ++ran;
  }
  EXPECT_GT(ran, 0) << "of " << lists.size() << " lists";
}

}  // namespace
}  // namespace rung::tb
