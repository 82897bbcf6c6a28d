// SPDX-License-Identifier: Apache-2.0
// Half LDmicro files, mixed-up ones and garbage: refused with words, or accepted and then written
// and read back; never a crash.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "ldmicro_support.hpp"
#include "programs/random_source.hpp"

namespace rung {
namespace {

// True if it was accepted.
bool feed(const std::string& bytes) {
  const ParseResult result = parse_ld(bytes);
  const bool errors = result.messages.find(": error: ") != std::string::npos;
  EXPECT_EQ(result.program.has_value(), !errors) << result.messages << bytes;
  if (!result.program) return false;
  const Program& program = *result.program;
  EXPECT_LE(count(program).contacts, count(program).instructions);
  for (const Device device : named_devices(program)) {
    EXPECT_TRUE(program.names.count(device) != 0) << bytes;
  }
  Diagnostics diagnostics;
  const auto text = to_ld(program, diagnostics);
  EXPECT_EQ(text.has_value(), !diagnostics.has_errors());
  if (!text) return true;
  const ParseResult again = parse_ld(*text);
  EXPECT_TRUE(again.program) << again.messages << *text;
  if (again.program) expect_same(program, *again.program);
  return true;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n') + 1;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

TEST(LdmicroRobustness, EveryPrefix) {
  int accepted = 0;
  for (std::size_t length = 0; length <= kEveryElement.size(); ++length) {
    accepted += feed(std::string(kEveryElement.substr(0, length))) ? 1 : 0;
  }
  EXPECT_GE(accepted, 6);  // behind each rung
}

TEST(LdmicroRobustness, EveryLineLeftOutOrTwice) {
  const std::vector<std::string> lines = lines_of(kEveryElement);
  int accepted = 0;
  for (std::size_t odd = 0; odd < lines.size(); ++odd) {
    for (const int times : {0, 2}) {
      std::string text;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        for (int k = i == odd ? times : 1; k > 0; --k) text += lines[i];
      }
      accepted += feed(text) ? 1 : 0;
    }
  }
  EXPECT_GT(accepted, 80);
}

// Each word in turn is another one.
TEST(LdmicroRobustness, EveryWordExchanged) {
  static constexpr std::array<std::string_view, 14> kOthers = {
      "",       "0",      "-1",  "32768",   "99999999999999999999", "'", "' '", "0xff", "a", "Xa",
      "\x95\\", "(none)", "END", "CONTACTS"};
  const std::string whole(kEveryElement);
  int accepted = 0;
  for (std::size_t begin = 0; begin < whole.size();) {
    const std::size_t end = std::min(whole.find_first_of(" \n", begin), whole.size());
    for (const std::string_view other : kOthers) {
      if (end == begin) break;
      accepted += feed(whole.substr(0, begin) + std::string(other) + whole.substr(end)) ? 1 : 0;
    }
    begin = end + 1;
  }
  EXPECT_GT(accepted, 100);
}

TEST(LdmicroRobustness, RandomBytesAndChanges) {
  RandomSource random(7);
  const std::string whole(kEveryElement);
  int accepted = 0;
  for (int round = 0; round < 4000; ++round) {
    std::string changed = whole;
    for (int i = random.below(4); i >= 0; --i) {
      changed[random.bits() % changed.size()] = static_cast<char>(random.below(256));
    }
    accepted += feed(changed) ? 1 : 0;
    std::string bytes = "LDmicro0.2\nPROGRAM\nRUNG\n";
    for (int i = random.below(100); i > 0; --i) bytes += static_cast<char>(random.below(256));
    feed(bytes);
  }
  EXPECT_GT(accepted, 100);
}

TEST(LdmicroRobustness, RandomLines) {
  static constexpr std::array<std::string_view, 12> kFrames = {
      "RUNG",      "END",           "END",     "PARALLEL", "SERIES",        "OSR",
      "COMMENT a", "PARALLEL\nOSR", "PROGRAM", "IO LIST",  "CONTACTS Xa 0", "COIL Xa 0 0"};
  RandomSource random(8);
  int accepted = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = "LDmicro0.1\nPROGRAM\nRUNG\n";
    for (int i = random.below(8); i > 0; --i) {
      text += std::string(kFrames[random.bits() % kFrames.size()]) + "\n";
    }
    accepted += feed(text + "END\n") ? 1 : 0;
  }
  EXPECT_GT(accepted, 1000);
}

TEST(LdmicroRobustness, LargeFiles) {
  const auto repeated = [](std::string_view text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  EXPECT_FALSE(feed(ld_file(repeated("PARALLEL\n", 100000))));
  EXPECT_FALSE(feed(ld_file(repeated("SERIES\n", 100000))));
  EXPECT_FALSE(feed(ld_file(repeated("END\n", 100000))));
  EXPECT_FALSE(feed(ld_file(repeated("x\n", 100000))));
  EXPECT_FALSE(feed(repeated("RUNG\n", 100000)));
  EXPECT_FALSE(feed("IO LIST\n" + repeated("Xa at 99999\n", 100000)));
  EXPECT_TRUE(feed(ld_file(repeated("OSR\n", 100000))));
  EXPECT_FALSE(feed(ld_file("LOOK_UP_TABLE d i 2147483647 0")));
  EXPECT_FALSE(feed(ld_file("FORMATTED_STRING (none) 2147483647")));
  EXPECT_FALSE(feed(ld_file("PIECEWISE_LINEAR d i 2147483647 0 0")));
  EXPECT_TRUE(feed(ld_file("RES " + std::string(1000000, 'n'))));
}

}  // namespace
}  // namespace rung
