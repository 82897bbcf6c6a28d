// SPDX-License-Identifier: Apache-2.0
#include "c_story.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "c_program.hpp"
#include "reference_story.hpp"

namespace rung {
namespace {

void run(const CPrograms& c, std::size_t index, const CStory& story) {
  const std::vector<std::string> before = scans_of(story.before);
  const std::vector<std::string> after = scans_of(story.after);
  ASSERT_EQ(before.size(), after.size());
  c.reset(index);
  c.elapsed(index, story.tick_us);
  for (std::size_t scan = 0; scan < before.size(); ++scan) {
    std::istringstream given(before[scan]);
    for (std::string token; given >> token;) {
      const std::size_t equals = token.find('=');
      ASSERT_TRUE(c.set(index, token.substr(0, equals), std::stol(token.substr(equals + 1))))
          << token;
    }
    c.cycle(index);
    std::istringstream wanted(after[scan]);
    for (std::string token; wanted >> token;) {
      const std::string name = token.substr(0, token.find('='));
      EXPECT_EQ(fmt::format("{}={}", name, c.get(index, name)), token) << "scan " << scan;
    }
  }
}

}  // namespace

void expect_c_stories(std::span<const CStory> stories) {
  std::vector<Program> programs;
  for (const CStory& story : stories) {
    SCOPED_TRACE(story.name);
    programs.push_back(story_program(story.text, story.dialect));
  }
  ASSERT_FALSE(testing::Test::HasFailure());
  const CPrograms c(programs);
  ASSERT_TRUE(c.good());
  for (std::size_t i = 0; i < stories.size(); ++i) {
    SCOPED_TRACE(stories[i].name);
    run(c, i, stories[i]);
  }
  RandomSource random(1);
  expect_c_equals_reference(c, programs, 300, random, 37000);
}

}  // namespace rung
