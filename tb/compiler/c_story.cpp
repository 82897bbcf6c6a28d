// SPDX-License-Identifier: Apache-2.0
#include "c_story.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "c_program.hpp"
#include "reference_ldmicro_story.hpp"
#include "reference_story.hpp"

namespace rung {
namespace {

void run(const CPrograms& c, std::size_t index, const CStory& story) {
  const bool own_time = story.dialect == Dialect::Ldmicro;
  const std::vector<std::string> before = scans_of(story.before);
  const std::vector<std::string> after = scans_of(story.after);
  ASSERT_EQ(before.size(), after.size());
  c.reset(index);
  if (!own_time) c.elapsed(index, story.tick_us);
  CPeripherals peripherals(c, index);
  for (std::size_t scan = 0; scan < before.size(); ++scan) {
    std::istringstream given(before[scan]);
    for (std::string token; given >> token;) {
      const std::size_t equals = token.find('=');
      const std::string name = token.substr(0, equals);
      const long value = std::stol(token.substr(equals + 1));
      if (name == "RX") {
        peripherals.receive(static_cast<int>(value));
      } else {
        ASSERT_TRUE(c.set(index, name, value)) << token;
      }
    }
    const std::vector<int> sent = peripherals.cycle();
    EXPECT_EQ(after[scan].find("TX=") != std::string::npos, !sent.empty()) << "scan " << scan;
    std::istringstream wanted(after[scan]);
    for (std::string token; wanted >> token;) {
      const std::string name = token.substr(0, token.find('='));
      if (name == "TX") {
        EXPECT_EQ(fmt::format("TX={}", fmt::join(sent, ",")), token) << "scan " << scan;
        continue;
      }
      if (name == "ERROR") {
        EXPECT_EQ(fmt::format("ERROR={}", c.error(index) ? 1 : 0), token) << "scan " << scan;
        continue;
      }
      EXPECT_EQ(fmt::format("{}={}", name, c.get(index, name)), token) << "scan " << scan;
    }
  }
}

}  // namespace

void expect_c_stories(std::span<const CStory> stories) {
  std::vector<Program> programs;
  for (const CStory& story : stories) {
    SCOPED_TRACE(story.name);
    programs.push_back(story.dialect == Dialect::Ldmicro
                           ? ld_program(story.text)
                           : story_program(story.text, story.dialect));
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
