// SPDX-License-Identifier: Apache-2.0
// rung with --mpu 4.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli_support.hpp"

namespace rung::cli {
namespace {

// M0 is written twice, and what the first write says nobody sees.
constexpr const char* kTwice = "LD X0\nOUT M0\nLD X1\nOUT M0\nOUT Y0\nLDI M9\nADD D0 K1 D0\nEND\n";
constexpr const char* kStimulus = "X0=1\nX1=1\nX0=0\n\n";

std::vector<nlohmann::json> lines_of(const std::string& text) {
  std::vector<nlohmann::json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

TEST_F(Cli, WideTracesSayTheirProcessorAndClocks) {
  const std::string program = file("twice.il", kTwice);
  const std::string stimulus = " --stimulus " + file("twice.stim", kStimulus);
  for (const char* slots : {"", "4", "8", "16"}) {
    for (const bool merge : {true, false}) {
      const std::string on = std::string(" --mpu 4") + (*slots == 0 ? "" : " --slots ") + slots +
                             (merge ? "" : " --no-merge");
      const Result compiled = rung("compile " + program + on + " --json");
      ASSERT_EQ(compiled.code, 0) << compiled.err;
      const auto json = nlohmann::json::parse(compiled.out);
      EXPECT_EQ(json.at("mpu"), 4);
      EXPECT_EQ(json.at("wide").at("slots"), *slots == 0 ? 8 : std::stoi(slots));
      EXPECT_EQ(json.at("wide").at("merged"), merge);
      const Result run = rung("run " + program + on + stimulus + " --state --trace -");
      ASSERT_EQ(run.code, 0) << run.err;
      const auto lines = lines_of(run.out);
      ASSERT_EQ(lines.size(), 5U);
      EXPECT_EQ(lines[0].at("mpu"), 4);
      EXPECT_EQ(lines[0].at("slots"), json.at("wide").at("slots"));
      EXPECT_EQ(lines[0].at("merged"), merge);
      for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_EQ(lines[i].at("clocks"), json.at("clocks"));
        EXPECT_EQ(lines[i].at("state").at("D0"), i);
      }
    }
  }
}

TEST_F(Cli, WideWithoutMergingEveryWriteIsTraced) {
  const std::string program = file("twice.il", kTwice);
  const std::string stimulus = " --stimulus " + file("twice.stim", kStimulus);
  const auto trace = [&](const std::string& on) {
    const Result run = rung("run " + program + on + stimulus + " --trace -");
    EXPECT_EQ(run.code, 0) << run.err;
    file("t" + on, run.out);
    std::vector<int> values;
    const auto lines = lines_of(run.out);
    for (const auto& write : lines.at(1).at("writes")) {
      if (write.at(0) == "M0") values.push_back(write.at(1));
    }
    return values;
  };
  const std::vector<int> both{1, 0}, last{0};
  EXPECT_EQ(trace(" --mpu reference"), both);
  EXPECT_EQ(trace(" --mpu 4 --no-merge"), both);
  EXPECT_EQ(trace(" --mpu 4"), last);
  // Each of the three agrees with each.
  for (const char* golden : {" --mpu reference", " --mpu 4 --no-merge", " --mpu 4"}) {
    for (const char* on : {" --mpu reference", " --mpu 3", " --mpu 4 --no-merge", " --mpu 4"}) {
      const Result r =
          rung("check " + program + on + " --golden '" + path("t" + std::string(golden)) + "'");
      EXPECT_EQ(r.code, 0) << golden << " on" << on << "\n" << r.err;
    }
  }
  // A write within the scan that is not the program's: seen where every write is made.
  std::string bad = read(path("t --mpu reference"));
  bad.replace(bad.find("[\"M0\",1]"), 8, "[\"M0\",0]");
  const std::string golden = " --golden " + file("bad.golden", bad);
  EXPECT_EQ(rung("check " + program + " --mpu 4 --no-merge" + golden).code, 3);
  const Result merged = rung("check " + program + " --mpu 4" + golden);
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_NE(merged.out.find("by the values after each scan"), std::string::npos) << merged.out;
}

TEST_F(Cli, WideDifferencesSayWhereAndHowToReplay) {
  const std::string program = file("twice.il", kTwice);
  const std::string stimulus = " --stimulus " + file("twice.stim", kStimulus);
  ASSERT_EQ(rung("run " + program + stimulus + " --trace " + path("t")).code, 0);
  std::string golden = read(path("t"));
  golden.replace(golden.find("[\"D0\",1]"), 8, "[\"D0\",2]");
  const std::string bad = " --golden " + file("bad.golden", golden);
  for (const char* on : {" --slots 16", " --slots 4 --no-merge"}) {
    const Result r = rung("check " + program + " --mpu 4" + on + bad);
    EXPECT_EQ(r.code, 3);
    for (const char* part : {"bad.golden:2:1", "scan 0", "D0", "expected 2", "got 1", "step ",
                             "slot ", "ADD D0 K1 D0", "replay: rung check", "--mpu 4", on}) {
      EXPECT_NE(r.err.find(part), std::string::npos) << part << " is not in\n" << r.err;
    }
  }
}

TEST_F(Cli, WideWrongUsageIsExit2) {
  const std::string program = file("twice.il", kTwice);
  ASSERT_EQ(rung("compile " + program + " --mpu 4 --slots 4 -o " + path("w.img")).code, 0);
  ASSERT_EQ(rung("compile " + program + " --mpu 3 -o " + path("n.img")).code, 0);
  for (const char* on :
       {" --mpu 4 --slots 5", " --mpu 4 --slots", " --mpu 4 --slots many", " --slots 8",
        " --mpu 3 --slots 8", " --mpu 1 --no-merge", " --mpu 4 --paper"}) {
    EXPECT_EQ(rung("compile " + program + on).code, 2) << on;
  }
  for (const std::string& arguments :
       {"run " + program + " --no-merge", "compile " + file("f.flow", "") + " --mpu 4",
        "compile " + program + " --mpu 4 --bindings",
        "compile " + program + " --mpu 4 --load-file " + path("l"),
        "run " + program + " --mpu reference --slots 4", "run " + path("w.img") + " --slots 8",
        "run " + path("w.img") + " --no-merge", "run " + path("w.img") + " --mpu 3",
        "run " + path("n.img") + " --slots 8", "run " + path("n.img") + " --no-merge",
        "export " + path("w.img") + " --symbols " + path("s"), "device " + path("w.img"),
        "view " + program + " --mpu 4"}) {
    const Result r = rung(arguments);
    EXPECT_EQ(r.code, 2) << arguments << "\n" << r.err;
    EXPECT_FALSE(r.err.empty()) << arguments;
  }
  EXPECT_EQ(rung("run " + path("w.img") + " --slots 4 --mpu 4").code, 0);
  EXPECT_FALSE(fs::exists(path("l")));
}

// 512 steps are what there is, and too many instructions are refused with what helps.
TEST_F(Cli, WideProgramThatIsTooLongIsRefused) {
  std::string text;
  for (int i = 0; i < 700; ++i)
    text += "LD X0\nADD D0 K1 D" + std::to_string(i) + "\nMUL D0 D1 D0\n";
  const Result r =
      rung("compile " + file("long.il", text + "END\n") + " --mpu 4 --slots 4 -o " + path("i"));
  EXPECT_EQ(r.code, 1);
  EXPECT_NE(r.err.find("MPU4 with 4 slots has 512"), std::string::npos) << r.err;
  EXPECT_NE(r.err.find("--slots"), std::string::npos) << r.err;
  EXPECT_FALSE(fs::exists(path("i")));
}

}  // namespace
}  // namespace rung::cli
