// SPDX-License-Identifier: Apache-2.0
// A list that is refused, with everything that is said of it, word for word.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

#include "support.hpp"

namespace rung {

struct Refused {
  const char* name;
  std::string_view text;
  std::optional<Dialect> dialect;
  const char* messages;
};

inline void expect_refused(const Refused& refused) {
  const ParseResult result = parse(refused.text, refused.dialect);
  EXPECT_FALSE(result.program);
  EXPECT_EQ(result.messages, refused.messages);
}

inline std::string refused_name(const testing::TestParamInfo<Refused>& info) {
  return info.param.name;
}

}  // namespace rung
