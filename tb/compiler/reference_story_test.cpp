// SPDX-License-Identifier: Apache-2.0
// Runs the stories; their tables are beside this file, by subject.
#include "reference_story.hpp"

namespace rung {

TEST_P(ReferenceStory, Writes) {
  const Story& story = GetParam();
  const Program program = story_program(story.text, story.dialect);
  ASSERT_FALSE(program.instructions.empty());
  const std::vector<std::string> before = scans_of(story.before);
  const std::vector<std::string> writes = scans_of(story.writes);
  ASSERT_EQ(before.size(), writes.size());
  Reference reference(program, story.tick_us);
  for (std::size_t scan = 0; scan < before.size(); ++scan) {
    preset(reference, before[scan], story.dialect);
    reference.run_scan();
    EXPECT_EQ(writes_of(reference, story.dialect), writes[scan]) << "scan " << scan;
  }
}

}  // namespace rung
