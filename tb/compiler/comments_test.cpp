// SPDX-License-Identifier: Apache-2.0
// Device-comment files.
#include "melsec/comments.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "support.hpp"

namespace rung {
namespace {

struct Read {
  std::optional<std::map<Device, std::string>> comments;
  std::string messages;
};

Read read(std::string_view text, Dialect dialect) {
  Diagnostics diagnostics;
  Read result;
  if (const auto source = decode_text(text, "c", diagnostics)) {
    result.comments = parse_comments(*source, dialect, diagnostics);
  }
  result.messages = printed(diagnostics);
  return result;
}

TEST(Comments, NameDevices) {
  const Read result = read(
      "\"COMMENT\"\n\"Device Name\"\t\"Comment\"\n\"X010\"\t\"start, \"\"now\"\"\"\n"
      "\"t5\"\t\"delay\"\n\"D0\"\t\"\"\n\"M8029\"\t\"done\"\n\"D0.1\"\t\"bit\"\n\"P0\"\t\"part\"\n"
      "\"D9000\"\t\"of another\"\n",
      Dialect::Fx);
  EXPECT_EQ(result.messages, "");
  ASSERT_TRUE(result.comments);
  const std::map<Device, std::string> expected = {{{DeviceKind::X, 8}, "start, \"now\""},
                                                  {{DeviceKind::TS, 5}, "delay"},
                                                  {{DeviceKind::TN, 5}, "delay"}};
  EXPECT_EQ(*result.comments, expected);
}

TEST(Comments, WithoutTitleAndQuotes) {
  const Read result = read("X1F,lamp\nY0,motor\n", Dialect::Q);
  ASSERT_TRUE(result.comments) << result.messages;
  EXPECT_EQ(result.comments->at({DeviceKind::X, 0x1F}), "lamp");
  EXPECT_EQ(result.comments->at({DeviceKind::Y, 0}), "motor");
}

TEST(Comments, FaultsAreReported) {
  const Read result =
      read("name\nX0\tone\nfoo bar\ttwo\nX8\tthree\nX0\tfour\nT0\tfive\nT0\tsix\nT0\tfive\n",
           Dialect::Fx);
  EXPECT_FALSE(result.comments);
  EXPECT_EQ(result.messages,
            "c:3:1: error: foo bar: not a device\n"
            "    a row is a device and its comment\n"
            "c:4:1: error: X8: its number has a digit that dialect fx does not use\n"
            "    these may be the comments of another controller: use --dialect\n"
            "c:5:1: error: X0 has a comment already: one\n"
            "    remove one of the two\n"
            "c:7:1: error: TS0 has a comment already: five\n"
            "    remove one of the two\n");
  EXPECT_EQ(read("LD X0\nOUT Y0\n", Dialect::Fx).messages,
            "c:1:1: error: there is no device comment in this file\n"
            "    a row is a device and its comment, separated by a tab or comma\n");
}

TEST(Comments, OfARealFile) {
  const auto path = std::filesystem::path(RUNG_REPOSITORY) /
                    "../shared/programs/melsec/gxw2_shw98__device_comments.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "skipped: no corpus";
  Diagnostics diagnostics;
  const auto source = read_text(path.string(), diagnostics);
  ASSERT_TRUE(source);
  const auto comments = parse_comments(*source, Dialect::Q, diagnostics);
  ASSERT_TRUE(comments) << printed(diagnostics);
  EXPECT_EQ(comments->at({DeviceKind::X, 0x5A}), "CH1 sampling cnt data read signl");
  EXPECT_EQ(comments->at({DeviceKind::D, 2000}), "CH1 current value (Lo 16 bit)");
}

}  // namespace
}  // namespace rung
