// SPDX-License-Identifier: Apache-2.0
// That the suite sees a wrong netlist: with one entry of one LUT wrong (scripts/flow/gate.py
// chooses them), some program's run must differ from its golden trace or from the RTL. Writes which
// did, if RUNG_GATE_FAULTS names a folder.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gate/netlists.hpp"
#include "golden/golden.hpp"

namespace rung::tb {
namespace {

struct Subject {
  const GoldenProgram* program;
  image::Image image;
};

// What the first program that sees the fault says, or nothing.
std::optional<std::string> caught(const NetlistInfo& netlist,
                                  const std::vector<Subject>& subjects) {
  for (const Subject& subject : subjects) {
    try {
      const LoadedMachine loaded =
          load_netlist(netlist, subject.image, subject.program->golden().header.tick_us);
      const QuietEnd quiet_end;
      const auto difference = subject.program->difference(subject.image, *loaded.machine);
      if (difference) return difference;
      read_all(netlist, subject.image, *loaded.processor);
    } catch (const std::runtime_error& error) {
      return fmt::format("{}: {}", subject.image.program, error.what());
    }
  }
  return std::nullopt;
}

class GateFaults : public testing::TestWithParam<NetlistInfo> {};

TEST_P(GateFaults, AreCaught) {
  const NetlistInfo& netlist = GetParam();
  std::ifstream file(std::string(RUNG_GATE_NETLISTS) + "/" + netlist.name + ".json");
  nlohmann::json faults = nlohmann::json::parse(file);

  std::vector<GoldenProgram> programs;
  for (const std::string& name : golden_names()) programs.emplace_back(name);
  std::vector<Subject> subjects;
  for (const GoldenProgram& program : programs) {
    auto image = program.compile(netlist.mpu, false, *netlist.config);
    if (image) subjects.push_back({&program, std::move(*image)});
  }
  // The fault is most often seen at once: short programs first.
  std::stable_sort(subjects.begin(), subjects.end(), [](const Subject& a, const Subject& b) {
    return a.image.steps.size() < b.image.steps.size();
  });

  ASSERT_FALSE(caught(netlist, subjects)) << "without a fault";
  int seen = 0;
  std::string missed;
  for (auto& fault : faults) {
    gate_state.fault = fault["number"].get<std::uint8_t>();
    const auto how = caught(netlist, subjects);
    fault["caught"] = how.has_value();
    if (how) {
      fault["how"] = *how;
      ++seen;
    } else {
      missed += fmt::format("\n{}: {} entry {}", fault["number"].get<int>(),
                            fault["cell"].get<std::string>(), fault["entry"].get<int>());
    }
  }
  gate_state.fault = 0;
  RecordProperty("caught", seen);
  fmt::print("{}: {} of {} faults are seen; not:{}\n", netlist.name, seen, faults.size(), missed);
  EXPECT_GE(faults.size(), 40U);
  // Entries that no state of the processor selects cannot be seen by any test.
  EXPECT_GE(seen * 10, static_cast<int>(faults.size()) * RUNG_GATE_SEEN_OF_TEN) << missed;
  if (const char* folder = std::getenv("RUNG_GATE_FAULTS"); folder != nullptr) {
    std::ofstream(std::string(folder) + "/" + netlist.name + "-caught.json") << faults.dump(1);
  }
}

INSTANTIATE_TEST_SUITE_P(Netlists, GateFaults, testing::ValuesIn(netlists()), [](const auto& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace rung::tb
