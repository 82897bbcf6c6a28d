// SPDX-License-Identifier: Apache-2.0
// Functional coverage of random steps and of the golden programs, on the RTL of the three
// processors. RUNG_PROGRAMS=n says how many random programs a processor gets in each configuration;
// RUNG_COVERAGE=FOLDER has functional.json written, with each hole by its name (`make cov`).
#include "coverage/functional.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "golden/golden.hpp"
#include "lockstep/machine.hpp"
#include "unit/random_steps.hpp"

namespace rung::tb {
namespace {

constexpr int kSteps = 200;
constexpr int kScans = 2;
// With so many nearly all must come up.
constexpr int kMany = 200;

int programs() {
  const char* text = std::getenv("RUNG_PROGRAMS");
  return text == nullptr ? 20 : std::atoi(text);
}

// Counts scans, beside those of each kind of run.
struct Counted {
  FunctionalCoverage coverage;
  std::uint64_t random_scans = 0;
  std::uint64_t golden_scans = 0;
};

void run_random(const Target& target, Counted& counted) {
  Bench bench(target);
  for (int seed = 1; seed <= programs(); ++seed) {
    RandomSteps random(target, static_cast<std::uint32_t>(seed));
    random.fill(bench);
    const std::vector<Step> program = random.program(kSteps);
    for (int scan = 0; scan < kScans; ++scan) {
      ASSERT_TRUE(scan == 0 ? bench.scan(program) : bench.scan_again()) << "seed " << seed;
      counted.coverage.scan(program, bench.retired());
      ++counted.random_scans;
    }
  }
}

void run_golden(const Target& target, Counted& counted) {
  const auto processor = make_processor(target.mpu, *target.config);
  for (const std::string& name : golden_names()) {
    const GoldenProgram program(name);
    const auto image = program.compile(target.mpu, false, *target.config);
    if (!image) continue;
    const std::int64_t tick = program.golden().header.tick_us;
    Machine machine(*image, *processor, tick);
    std::vector<Retired> retired;
    machine.observe([&](const Retired& each) {
      // A scan begins with step 0.
      if (!retired.empty() && each.step < retired.back().step) {
        counted.coverage.scan(image->steps, retired);
        ++counted.golden_scans;
        retired.clear();
      }
      retired.push_back(each);
    });
    const auto difference = program.difference(*image, machine);
    ASSERT_FALSE(difference) << *difference;
    counted.coverage.scan(image->steps, retired);
    ++counted.golden_scans;
  }
}

nlohmann::json report(isa::Mpu mpu, const Counted& counted) {
  std::map<std::string, std::pair<int, int>> by_opcode;  // hit, all
  std::vector<std::string> holes;
  for (const Situation& situation : counted.coverage.universe()) {
    auto& [hit, all] = by_opcode[std::string(isa::info(situation.opcode).name)];
    ++all;
    if (counted.coverage.count(situation) > 0) {
      ++hit;
    } else {
      holes.push_back(describe(mpu, situation));
    }
  }
  nlohmann::json out = {{"mpu", static_cast<int>(mpu)},
                        {"random_scans", counted.random_scans},
                        {"golden_scans", counted.golden_scans},
                        {"holes", holes}};
  int hit = 0;
  int all = 0;
  for (const auto& [name, count] : by_opcode) {
    out["opcodes"][name] = {{"hit", count.first}, {"all", count.second}};
    hit += count.first;
    all += count.second;
  }
  out["hit"] = hit;
  out["all"] = all;
  return out;
}

TEST(FunctionalCoverage, OfRandomAndGoldenRuns) {
  nlohmann::json reports = nlohmann::json::array();
  for (const isa::Mpu mpu : kAllMpus) {
    Counted counted{FunctionalCoverage(mpu)};
    for (const Target& target : targets({mpu})) {
      ASSERT_NO_FATAL_FAILURE(run_random(target, counted));
      ASSERT_NO_FATAL_FAILURE(run_golden(target, counted));
    }
    for (const Situation& situation : counted.coverage.impossible()) {
      ADD_FAILURE() << "not possible by the rules: " << describe(mpu, situation);
    }
    reports.push_back(report(mpu, counted));
    const nlohmann::json& made = reports.back();
    fmt::print("MPU{}: {} of {} situations\n", static_cast<int>(mpu), made["hit"].get<int>(),
               made["all"].get<int>());
    const int hit = made["hit"].get<int>();
    const int all = made["all"].get<int>();
    const int least = programs() >= kMany ? 90 : 55;  // per cent
    EXPECT_GE(100 * hit, least * all);
  }
  if (const char* folder = std::getenv("RUNG_COVERAGE"); folder != nullptr) {
    const nlohmann::json all = {{"programs", programs()}, {"steps", kSteps}, {"mpus", reports}};
    std::ofstream(std::string(folder) + "/functional.json") << all.dump(1) << "\n";
  }
}

}  // namespace
}  // namespace rung::tb
