// SPDX-License-Identifier: Apache-2.0
// The bytes of FORMATTED_STRING.
#include "rungs/format_string.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string_view>

namespace rung {
namespace {

std::vector<std::int32_t> codes(std::string_view text) { return {text.begin(), text.end()}; }

// `65` a byte, `s` the sign, `100` a digit with d before it, the last one with d and a point.
std::string steps(std::string_view text) {
  std::string all;
  for (const StringStep& step : string_steps(codes(text))) {
    if (!all.empty()) all += ' ';
    switch (step.kind) {
      case StringStep::Kind::Byte:
        all += fmt::format("{}", step.value);
        break;
      case StringStep::Kind::Sign:
        all += "s";
        break;
      case StringStep::Kind::Digit:
        all += fmt::format("d{}{}", step.value, step.last ? "." : "");
        break;
    }
  }
  return all;
}

TEST(FormatString, Steps) {
  EXPECT_EQ(steps(""), "");
  EXPECT_EQ(steps("Az"), "65 122");
  EXPECT_EQ(steps("\\r\\n\\b\\f\\\\"), "13 10 8 12 92");
  EXPECT_EQ(steps("\\x41\\xfF\\x00"), "65 255 0");
  EXPECT_EQ(steps("\\1"), "d1.");
  EXPECT_EQ(steps("=\\3;"), "61 d100 d10 d1. 59");
  EXPECT_EQ(steps("\\-5"), "s d10000 d1000 d100 d10 d1.");
  EXPECT_EQ(steps("\\11"), "d1. 49");  // one digit, and the character 1
  EXPECT_EQ(string_steps({0xE9})[0].value, 0xE9);
}

TEST(FormatString, ShowsAVariable) {
  EXPECT_FALSE(shows_variable(codes("a\\\\1")));
  EXPECT_TRUE(shows_variable(codes("a\\1")));
}

TEST(FormatString, Faults) {
  EXPECT_FALSE(string_fault(codes("ok \\r\\n \\-5 \\x0A")));
  for (const auto& [text, what] :
       {std::pair{"\\", "a \\ with nothing behind it ends the string"},
        {"\\t", "\\t is no escape of a format string"},
        {"\\ ", "\\ before the character 32 is no escape of a format string"},
        {"\\x4", "\\x without two hexadecimal digits behind it"},
        {"\\x4g", "\\x without two hexadecimal digits behind it"},
        {"\\0", "\\0: digits of the variable are 1 to 5"},
        {"\\6", "\\6: digits of the variable are 1 to 5"},
        {"\\-", "\\- without a number of digits from 1 to 5"},
        {"\\-0", "\\- without a number of digits from 1 to 5"},
        {"\\--1", "\\- without a number of digits from 1 to 5"},
        {"\\1\\-2", "the string shows the variable twice"}}) {
    const auto fault = string_fault(codes(text));
    ASSERT_TRUE(fault) << text;
    EXPECT_EQ(fault->what, what);
    EXPECT_FALSE(fault->mend.empty());
  }
}

}  // namespace
}  // namespace rung
