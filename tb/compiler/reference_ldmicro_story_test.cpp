// SPDX-License-Identifier: Apache-2.0
// Runs the stories of LDmicro programs; their tables are beside this file, by subject.
#include "reference_ldmicro_story.hpp"

namespace rung {

TEST_P(LdReferenceStory, Does) {
  const LdStory& story = GetParam();
  const Program program = ld_program(story.text);
  ASSERT_FALSE(program.instructions.empty());
  const Stimulus stimulus = ld_stimulus(story.before, program);
  const std::vector<std::string> writes = scans_of(story.writes);
  ASSERT_EQ(stimulus.scans(), writes.size());
  Reference reference(program);
  for (std::size_t scan = 0; scan < writes.size(); ++scan) {
    for (const StimulusEvent& event : stimulus.events(scan)) {
      reference.set(event.device, event.value);
    }
    reference.run_scan();
    EXPECT_EQ(done_in_scan(reference, program), writes[scan]) << "scan " << scan;
  }
}

}  // namespace rung
