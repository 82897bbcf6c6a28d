// SPDX-License-Identifier: Apache-2.0
// A program, what it is given in each scan, and the writes it must make: rows of the tables in the
// tests of the reference, worked out by hand.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "reference/reference.hpp"
#include "rungs/devices.hpp"
#include "support.hpp"

namespace rung {

struct Story {
  const char* name;
  const char* text;    // instructions between commas, without END
  const char* before;  // of each scan, between bars: "X0=1 D0=7 | | X0=0"
  const char* writes;  // of each scan, in the order of execution
  Dialect dialect = Dialect::Fx;
  std::int64_t tick_us = 10000;
};

inline void PrintTo(const Story& story, std::ostream* out) { *out << story.text; }

// The parts of `text` between bars, without the blanks around them.
inline std::vector<std::string> scans_of(const std::string& text) {
  std::vector<std::string> scans;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('|', at), text.size());
    const std::string part = text.substr(at, end - at);
    const std::size_t first = part.find_first_not_of(' ');
    scans.push_back(first == std::string::npos
                        ? std::string()
                        : part.substr(first, part.find_last_not_of(' ') - first + 1));
    at = end + 1;
  }
  return scans;
}

// The program of instructions between commas; the test fails if it is refused.
inline Program story_program(std::string text, Dialect dialect) {
  std::replace(text.begin(), text.end(), ',', '\n');
  ParseResult result = parse(text + "\nEND", dialect);
  EXPECT_TRUE(result.program) << result.messages;
  return result.program ? std::move(*result.program) : Program{};
}

// "X0=1 D0=7"
inline void preset(Reference& reference, const std::string& values, Dialect dialect) {
  std::istringstream in(values);
  for (std::string token; in >> token;) {
    const std::size_t equals = token.find('=');
    const auto device = parse_device_name(token.substr(0, equals), dialect);
    ASSERT_TRUE(device) << token;
    reference.set(*device, static_cast<std::int16_t>(std::stoi(token.substr(equals + 1))));
  }
}

// The writes of the scan, as "M0=1 D0=7".
inline std::string writes_of(const Reference& reference, Dialect dialect) {
  std::string text;
  for (const ReferenceWrite& write : reference.writes()) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", device_name(write.device, dialect),
                        write.value);
  }
  return text;
}

class ReferenceStory : public testing::TestWithParam<Story> {};

// For INSTANTIATE_TEST_SUITE_P.
inline std::string story_name(const testing::TestParamInfo<Story>& info) { return info.param.name; }

}  // namespace rung
