// SPDX-License-Identifier: Apache-2.0
// What a run keeps and does: forces, breakpoints, history, text, without a browser.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "melsec/melsec.hpp"
#include "source/text_file.hpp"
#include "view/commands.hpp"
#include "view/frame.hpp"
#include "view/terminal.hpp"

namespace rung::view {
namespace {

using nlohmann::json;

constexpr const char* kMotor =
    "; holds itself\nLD X0\nOR M0\nANI X1\nOUT M0\nOUT Y0\nLD M0\nOUT T0 K2\nLD T0\nOUT Y1\n"
    "LD X2\nINC D0\nEND\n";

class SessionTest : public testing::Test {
 protected:
  void SetUp() override {
    Diagnostics diagnostics;
    const auto text = decode_text(kMotor, "motor.il", diagnostics);
    program_ = parse_melsec(*text, Dialect::Fx, diagnostics);
    ASSERT_TRUE(program_);
    std::vector<std::string> lines;
    for (const auto& line : text->lines) lines.push_back(to_utf8(line));
    view_ = std::make_unique<ProgramView>(*program_, lines, 6);
    run_ = std::make_unique<view::Run>(
        *view_, std::vector<std::string>{"reference"},
        [this](const std::string&) { return make_reference_engine(*program_, 100'000); });
  }

  int device(const char* name) const { return view_->find(std::string_view(name)); }
  int value(const char* name) const {
    return run_->values()[static_cast<std::size_t>(device(name))];
  }
  void scan(int count = 1) {
    for (int i = 0; i < count; ++i) run_->one_scan();
  }

  std::optional<Program> program_;
  std::unique_ptr<ProgramView> view_;
  std::unique_ptr<view::Run> run_;
};

TEST_F(SessionTest, AnInputHolds) {
  run_->set(device("X0"), 1);
  EXPECT_EQ(value("Y0"), 0);
  scan();
  EXPECT_EQ(value("Y0"), 1);
  scan(5);
  EXPECT_EQ(value("Y1"), 1);
}

TEST_F(SessionTest, AForceWinsAndIsReleased) {
  run_->set(device("X0"), 1);
  run_->force(device("X0"), 0);
  scan();
  EXPECT_EQ(value("Y0"), 0);
  run_->force(device("Y0"), 1);
  scan();
  EXPECT_EQ(value("Y0"), 1);  // though its coil has no power
  EXPECT_EQ(value("M0"), 0);
  run_->release_all();
  scan();
  EXPECT_EQ(value("X0"), 1);  // what it had been set to
  EXPECT_EQ(value("Y0"), 1);
  EXPECT_TRUE(run_->forced().empty());
}

TEST_F(SessionTest, ABreakpointPausesAfterItsScan) {
  run_->set(device("X2"), 1);
  run_->set_breakpoint(device("D0"), Breakpoint{std::int16_t{3}});
  run_->set_mode(Mode::Fast);
  for (int i = 0; i < 10 && run_->mode() == Mode::Fast; ++i) scan();
  EXPECT_EQ(value("D0"), 3);
  EXPECT_EQ(run_->scans(), 3);
  EXPECT_EQ(run_->message(), "D0 went from 2 to 3 in scan 2");
  run_->set_breakpoint(device("D0"), std::nullopt);
  run_->set_mode(Mode::Fast);
  scan(5);
  EXPECT_EQ(run_->mode(), Mode::Fast);
}

TEST_F(SessionTest, ARestartKeepsTheInputs) {
  run_->set(device("X0"), 1);
  scan(4);
  run_->restart("reference");
  EXPECT_EQ(run_->scans(), 0);
  EXPECT_EQ(value("Y0"), 0);
  EXPECT_EQ(value("X0"), 1);
  EXPECT_EQ(run_->history().last(), -1);
  scan();
  EXPECT_EQ(value("Y0"), 1);
}

TEST_F(SessionTest, HistoryForgetsWhatIsOld) {
  constexpr int kScans = 20'100;
  run_->set(device("X2"), 1);
  scan(kScans);
  const History& history = run_->history();
  EXPECT_EQ(history.first(), kScans - 20'000);
  EXPECT_EQ(history.last(), kScans - 1);
  const auto counts = history.of(device("D0"));
  EXPECT_EQ(counts.front().scan, history.first());
  EXPECT_EQ(counts.front().value, history.first() + 1);
  EXPECT_EQ(counts.back().value, kScans);
  EXPECT_EQ(history.of(device("D0"), kScans - 2).size(), 2U);
  EXPECT_EQ(history.of(device("X2")).size(), 1U);
}

TEST_F(SessionTest, ExportsAreComplete) {
  run_->set(device("X0"), 1);
  scan();
  run_->set(device("X0"), 0);
  run_->set(device("X2"), 1);
  scan(2);
  const std::vector<int> both{device("X0"), device("D0")};
  EXPECT_EQ(to_csv(run_->history(), *view_, both, 100'000),
            "scan,ms,X0,D0\n0,0,1,0\n1,100,0,1\n2,200,0,2\n");
  EXPECT_EQ(to_vcd(run_->history(), *view_, both, 100'000),
            "$comment motor_il , a scan every 100000 us $end\n$timescale 1us $end\n"
            "$scope module rung $end\n$var wire 1 ! X0 $end\n$var integer 16 \" D0 $end\n"
            "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n1!\n"
            "b0000000000000000 \"\n$end\n#100000\n0!\nb0000000000000001 \"\n#200000\n"
            "b0000000000000010 \"\n#300000\n");
}

TEST_F(SessionTest, FramesHoldWhatHasChanged) {
  FrameState state;
  ASSERT_TRUE(frame_json(*run_, state));
  EXPECT_FALSE(frame_json(*run_, state));
  run_->set(device("X0"), 1);
  const auto frame = frame_json(*run_, state);
  ASSERT_TRUE(frame);
  EXPECT_EQ((*frame)["values"], json::array({device("X0"), 1}));
  run_->restart("reference");
  EXPECT_EQ((*frame_json(*run_, state))["values"].size(), 2 * view_->devices().size());
}

TEST_F(SessionTest, BadCommandsAreRefused) {
  for (const char* text :
       {"1", "{}", R"({"do":"set"})", R"({"do":"set","device":99,"value":1})",
        R"({"do":"set","device":0,"value":"on"})", R"({"do":"mode","mode":"slow"})",
        R"({"do":"step","scans":0})", R"({"do":"break","device":0})",
        R"({"do":"set","device":0,"value":65536})"}) {
    EXPECT_THROW(obey(*run_, json::parse(text)), std::runtime_error) << text;
  }
}

TEST_F(SessionTest, TheLadderAsText) {
  run_->set(device("X0"), 1);
  scan();
  const std::vector<std::string> lines = ladder_text(*run_, {});
  const std::vector<std::string> begin(lines.begin(), lines.begin() + 8);
  const std::vector<std::string> expected{
      "      ; holds itself",
      "      |    X0          X1                                              M0      |",
      "    1 |====] [=====+===]/[=====+=======================================( )=====|",
      "      |            |           |                                               |",
      "      |    M0      |           |                                       Y0      |",
      "      |====] [-----+           +=======================================( )=====|",
      "      |                                                                        |",
      "      |    M0                                                                  |",
  };
  EXPECT_EQ(begin, expected);
}

}  // namespace
}  // namespace rung::view
