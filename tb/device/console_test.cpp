// SPDX-License-Identifier: Apache-2.0
#include "device/console.hpp"

#include <gtest/gtest.h>

namespace rung::device {
namespace {

using Kind = BenchCommand::Kind;

const controller::Board& board(std::string_view name) {
  for (const controller::Board& one : controller::boards()) {
    if (one.name == name) return one;
  }
  throw std::runtime_error("no such board");
}

BenchCommand right(std::string_view line, std::string_view name = "simulated") {
  const auto parsed = parse_bench_command(line, board(name));
  const auto* error = std::get_if<std::string>(&parsed);
  EXPECT_EQ(error, nullptr) << *error;
  return error == nullptr ? std::get<BenchCommand>(parsed) : BenchCommand{};
}

std::string wrong(std::string_view line, std::string_view name = "simulated") {
  const auto parsed = parse_bench_command(line, board(name));
  const auto* error = std::get_if<std::string>(&parsed);
  EXPECT_NE(error, nullptr) << line;
  return error != nullptr ? *error : "";
}

TEST(Console, Commands) {
  EXPECT_EQ(right("in3=1").kind, Kind::Input);
  EXPECT_EQ(right("in3=1").index, 3);
  EXPECT_EQ(right("in3=1").value, 1);
  EXPECT_EQ(right("  in31 = 0  # off\r").index, 31);
  const auto& pins = board("hx8k").inputs;
  EXPECT_EQ(right(std::string(pins.back()) + "=1", "hx8k").index,
            static_cast<int>(pins.size()) - 1);
  EXPECT_EQ(right("adc7=32767").kind, Kind::Adc);
  EXPECT_EQ(right("adc7=32767").value, 32767);
  EXPECT_EQ(right("power off").kind, Kind::Power);
  EXPECT_EQ(right("power off").value, 0);
  EXPECT_EQ(right("power  on").value, 1);
  EXPECT_EQ(right("switch stop").kind, Kind::Switch);
  EXPECT_EQ(right("switch run").value, 1);
  EXPECT_EQ(right("show").kind, Kind::Show);
  EXPECT_EQ(right("quit").kind, Kind::Quit);
  EXPECT_EQ(right("").kind, Kind::Nothing);
  EXPECT_EQ(right(" # a comment").kind, Kind::Nothing);
}

TEST(Console, Refused) {
  EXPECT_EQ(wrong("in3=2"), "'2': an input pin is 0 or 1: in3=1");
  EXPECT_EQ(wrong("in32=1"), "'in32': simulated has the inputs in0 to in31 and adc0 to adc7");
  EXPECT_TRUE(wrong("adc0=1", "hx8k").starts_with("'adc0': hx8k has the inputs t1 to "));
  EXPECT_EQ(wrong("adc0=32768"), "'32768': a sample is 0 to 32767: adc0=512");
  EXPECT_EQ(wrong("adc8=1"), "'adc8': simulated has the inputs in0 to in31 and adc0 to adc7");
  EXPECT_EQ(wrong("adc0=1x"), "'1x': a sample is 0 to 32767: adc0=512");
  EXPECT_EQ(wrong("power maybe"), "'power maybe': no such command; 'help' lists them");
  EXPECT_EQ(wrong("show all"), "'show all': no such command; 'help' lists them");
}

TEST(Console, HelpNamesTheBoardsPins) {
  EXPECT_NE(bench_help(board("simulated")).find("adc0 to adc7"), std::string::npos);
  EXPECT_EQ(bench_help(board("hx8k")).find("adc"), std::string::npos);
}

}  // namespace
}  // namespace rung::device
