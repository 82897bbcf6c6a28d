// SPDX-License-Identifier: Apache-2.0
// Flow programs on the command line.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli_support.hpp"

namespace rung::cli {
namespace {

using nlohmann::json;

constexpr const char* kFlow = R"(ladder "line.il"
board PANEL = unit 1 board 1 panel
task LIFT start
step UP
  Y0 = X0
  D0 = D0 + 2
  wait X1
step DOWN
  read D10 count 2 from PANEL at 20
  M0 = failed
  goto UP
)";
constexpr const char* kLadder = "LD M0\nOUT Y1\nEND\n";

class CliFlow : public Cli {
 protected:
  std::string program(const std::string& text = kFlow) const {
    file("line.il", kLadder);
    return file("lift.flow", text);
  }
  static std::vector<json> lines(const std::string& text) {
    std::vector<json> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) all.push_back(json::parse(line));
    return all;
  }
};

TEST_F(CliFlow, CompilePrintsTheBound) {
  const Result r = rung("compile " + program());
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  // UP, its wait, and DOWN.
  for (const char* part : {"1 tasks of 3 steps", "MPU3", "LIFT", "DOWN (2)", "a round, in clocks",
                           "input to output in 1 turn:"}) {
    EXPECT_NE(r.out.find(part), std::string::npos) << part << " is not in\n" << r.out;
  }
}

TEST_F(CliFlow, CompileSaysItsCountsAsJson) {
  for (const int mpu : {1, 2, 3}) {
    const Result r = rung("compile " + program() + " --json --mpu " + std::to_string(mpu));
    ASSERT_EQ(r.code, 0) << r.err;
    const json out = json::parse(r.out);
    for (const char* key :
         {"program", "mpu", "dialect", "config", "rungs", "instructions", "contacts", "runs",
          "lookups", "steps", "clocks", "lut_rows", "bit_devices", "word_devices"}) {
      EXPECT_TRUE(out.contains(key)) << key;
    }
    EXPECT_EQ(out["mpu"], mpu);
    EXPECT_EQ(out["dialect"], "fx");
    const json& flow = out["flow"];
    ASSERT_EQ(flow["tasks"].size(), 1U);
    EXPECT_EQ(flow["tasks"][0]["task"], "LIFT");
    ASSERT_EQ(flow["steps"].size(), 3U);
    // The only task's longest turn is that of the step whose turn is the longest.
    std::int64_t most = 0;
    for (const json& step : flow["steps"])
      most = std::max(most, step["turn_clocks"].get<std::int64_t>());
    EXPECT_EQ(flow["tasks"][0]["turn_clocks"], most);
    EXPECT_EQ(flow["turns_clocks"], most);
    EXPECT_GT(flow["round_clocks"].get<std::int64_t>(), most);
    // A list has none.
    const Result list = rung("compile " + path("line.il") + " --json");
    EXPECT_FALSE(json::parse(list.out).contains("flow"));
  }
}

TEST_F(CliFlow, CompileWritesImageListingLoadFileAndBindings) {
  const Result r = rung("compile " + program() + " --load-file " + path("lift.load") + " -o " +
                        path("lift.img"));
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(read(path("lift.img")).substr(0, 7), "RUNGIMG");
  EXPECT_GT(read(path("lift.load")).size(), 100U);
  const Result listing = rung("compile " + program() + " --listing");
  EXPECT_EQ(listing.code, 0);
  for (const char* part : {"LIFT", "step UP", "step DOWN", "PANEL"}) {
    EXPECT_NE(listing.out.find(part), std::string::npos) << part << " is not in\n" << listing.out;
  }
  const std::string map =
      file("map.toml", "board = \"simulated\"\n[inputs]\nX0 = \"in0\"\n[outputs]\nY0 = \"out0\"\n");
  const Result bindings = rung("compile " + program() + " --io " + map + " --bindings");
  EXPECT_EQ(bindings.code, 0) << bindings.err;
  EXPECT_NE(bindings.out.find("X0"), std::string::npos) << bindings.out;
  const Result bound = rung("compile " + program() + " --io " + map);
  EXPECT_EQ(bound.code, 0) << bound.err;
  EXPECT_NE(bound.out.find("latch, refresh and exchange"), std::string::npos) << bound.out;
  // An image has tasks that a processor alone does not run.
  const std::string golden = file(
      "x", "{\"rung_trace\":1,\"program\":\"p\",\"dialect\":\"fx\",\"tick_ms\":10,\"mpu\":0}\n");
  for (const std::string& arguments : {std::string("run "), "check --golden " + golden + " "}) {
    const Result image = rung(arguments + path("lift.img"));
    EXPECT_EQ(image.code, 2) << arguments << image.err;
    EXPECT_NE(image.err.find("this image has flow tasks"), std::string::npos) << image.err;
  }
}

TEST_F(CliFlow, RunOnTheReference) {
  const std::string stimulus = file("s", "X0=1\n\nX1=1\n*5\n");
  const Result r = rung("run " + program() + " --mpu reference --state --trace " + path("t") +
                        " --stimulus " + stimulus);
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_NE(
      r.out.find("8 scans, rounds on the reference; transfers over links without an answer: 1"),
      std::string::npos)
      << r.out;
  const std::vector<json> trace = lines(read(path("t")));
  ASSERT_EQ(trace.size(), 9U);
  EXPECT_EQ(trace[0]["rung_trace"], 1);
  EXPECT_EQ(trace[0]["dialect"], "fx");
  EXPECT_EQ(trace[0]["mpu"], 0);
  // Round 0: UP; 1: waits; 2: the wait ends; 3: DOWN sends; 4: no answer; 5: UP again; 6 the wait;
  // 7: DOWN sends.
  EXPECT_EQ(trace[1]["in"], json::parse(R"({"X0":1})"));
  EXPECT_EQ(trace[1]["out"], json::parse(R"({"Y0":1})"));
  EXPECT_EQ(trace[1]["writes"], json::parse(R"([["Y0",1],["D0",2],["Y1",0]])"));
  EXPECT_EQ(trace[2]["writes"], json::parse(R"([["Y1",0]])"));
  EXPECT_EQ(trace[4]["writes"], json::parse(R"([["Y1",0]])"));
  EXPECT_EQ(trace[5]["writes"], json::parse(R"([["M0",1],["Y1",1]])"));
  EXPECT_EQ(trace[5]["out"], json::parse(R"({"Y1":1})"));
  EXPECT_EQ(trace[6]["writes"], json::parse(R"([["Y0",1],["D0",4],["Y1",1]])"));
  // Everything that the program names, with the words of its transfers, and the relay that is
  // always on, which its steps need.
  EXPECT_EQ(
      trace[8]["state"],
      json::parse(R"({"X0":1,"X1":1,"Y0":1,"Y1":1,"M0":1,"D0":4,"D10":0,"D11":0,"M8000":1})"));
}

TEST_F(CliFlow, RunWithoutAStimulus) {
  const Result one = rung("run " + program() + " --mpu reference");
  EXPECT_EQ(one.code, 0);
  EXPECT_NE(one.out.find(": 1 scans, rounds on the reference\n"), std::string::npos) << one.out;
  // A wait for a time follows --tick.
  const std::string text = "task A start\nstep S\nwait 20 ms\nY0 = on\nwait X7\n";
  for (const auto& [tick, scan] : {std::pair{"1", 24}, {"10", 6}}) {
    const Result r = rung("run " + program(text) + " --mpu reference --scans 40 --trace - --tick " +
                          std::string(tick));
    ASSERT_EQ(r.code, 0) << r.err;
    const std::vector<json> trace = lines(r.out);
    const auto on = std::find_if(trace.begin() + 1, trace.end(),
                                 [](const json& line) { return !line["out"].empty(); });
    ASSERT_NE(on, trace.end());
    EXPECT_EQ((*on)["scan"], scan - 1) << tick;
  }
}

TEST_F(CliFlow, WrongUsageIsExit2) {
  const std::string lift = program();
  for (const char* arguments : {"run", "run --mpu 1", "run --mpu 2", "run --mpu 3"}) {
    const Result r = rung(std::string(arguments) + " " + lift);
    EXPECT_EQ(r.code, 2) << arguments;
    EXPECT_NE(r.err.find("--mpu reference"), std::string::npos) << r.err;
  }
  for (const char* arguments : {"compile --paper", "compile --dialect q", "compile --dump logic",
                                "run --mpu reference --dialect fx"}) {
    const Result r = rung(std::string(arguments) + " " + lift);
    EXPECT_EQ(r.code, 2) << arguments;
    EXPECT_NE(r.err.find("flow program"), std::string::npos) << r.err;
  }
}

TEST_F(CliFlow, WhatIsRefusedIsExit1AndLeavesNothing) {
  const std::string lift = program();
  const std::size_t before = files();
  const Result check = rung("check " + lift + " --golden " + path("none"));
  EXPECT_EQ(check.code, 1);
  EXPECT_NE(check.err.find("lift.flow:1:1: error: golden traces of flow programs"),
            std::string::npos)
      << check.err;
  for (const char* form : {"c", "bytecode", "il", "ld"}) {
    const Result r = rung("translate " + lift + " -o " + path("out") + " --to " + form);
    EXPECT_EQ(r.code, 1);
    EXPECT_NE(r.err.find("lift.flow:1:1: error: flow tasks cannot be written"), std::string::npos)
        << r.err;
  }
  const std::string bad = program("task A start\nstep S\n  goto T\n");
  for (const char* arguments : {"compile -o out.img", "run --mpu reference --trace out"}) {
    const Result r = rung(std::string(arguments) + " " + bad);
    EXPECT_EQ(r.code, 1);
    EXPECT_NE(r.err.find("lift.flow:3:8: error: T: no step has this name"), std::string::npos)
        << r.err;
    EXPECT_EQ(r.out, "");
  }
  // No flow hardware there.
  const Result small = rung("compile " + program() + " --config hx8k -o " + path("out"));
  EXPECT_EQ(small.code, 1) << small.out;
  EXPECT_NE(small.err.find("lift.flow:"), std::string::npos) << small.err;
  EXPECT_EQ(files(), before);
}

TEST_F(CliFlow, NamesComeFromACommentFile) {
  const std::string names = file("names.csv", "\"X0\",\"go\"\n\"D11\",\"floor\"\n");
  const Result r = rung("run " + program() + " --mpu reference --trace - --comments " + names);
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(lines(r.out)[0]["comments"], json::parse(R"({"X0":"go","D11":"floor"})"));
  const Result symbols = rung("export --symbols - " + program() + " --comments " + names);
  EXPECT_EQ(symbols.code, 0) << symbols.err;
  EXPECT_NE(symbols.out.find("D11,floor,"), std::string::npos) << symbols.out;
}

}  // namespace
}  // namespace rung::cli
