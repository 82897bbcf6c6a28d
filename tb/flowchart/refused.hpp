// SPDX-License-Identifier: Apache-2.0
// A flow program that is refused, with everything that is said of it.
#pragma once

#include <string>
#include <string_view>

#include "support.hpp"

namespace rung::flowchart {

struct Refused {
  const char* name;
  std::string_view text;
  std::string_view messages;
};

inline void expect_refused(const Refused& refused) {
  const ReadResult result = read_text_of(refused.text);
  EXPECT_FALSE(result.chart);
  EXPECT_EQ(result.messages, refused.messages);
}

inline std::string refused_name(const testing::TestParamInfo<Refused>& info) {
  return info.param.name;
}

}  // namespace rung::flowchart
