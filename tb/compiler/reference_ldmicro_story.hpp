// SPDX-License-Identifier: Apache-2.0
// An LDmicro program, what it is given in each scan, and what it must do: rows of the tables in the
// tests of the reference, worked out by hand from compiler/LDMICRO.md.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "ldmicro/ldmicro.hpp"
#include "reference_story.hpp"
#include "trace/stimulus.hpp"

namespace rung {

struct LdStory {
  const char* name;
  const char* text;    // elements between commas, rungs between semicolons
  const char* before;  // the stimulus, scans between bars
  const char* writes;  // of each scan, in the order of execution, and the bytes sent: "Yo=1 TX=65"
};

inline void PrintTo(const LdStory& story, std::ostream* out) { *out << story.text; }

// The file of such a text, with a CYCLE of 10 ms.
inline std::string ld_file(std::string_view text) {
  std::string file = "LDmicro0.1\nCYCLE=10000\nCRYSTAL=4000000\nBAUD=2400\n\nPROGRAM\nRUNG\n";
  for (const char c : text) {
    if (c == ',') {
      file += '\n';
    } else if (c == ';') {
      file += "\nEND\nRUNG\n";
    } else if (c != ' ' || (file.back() != '\n' && file.back() != ' ')) {
      file += c;
    }
  }
  return file + "\nEND\n";
}

// The program; the test fails if it is refused.
inline Program ld_program(std::string_view text) {
  Diagnostics diagnostics;
  std::optional<Program> program;
  if (const auto source = decode_ldmicro(ld_file(text), "t.ld", diagnostics)) {
    program = parse_ldmicro(*source, diagnostics);
  }
  EXPECT_TRUE(program) << printed(diagnostics);
  return program ? std::move(*program) : Program{};
}

// "Xa=1 | | v=7" as a stimulus of `program`; the test fails if it is refused.
inline Stimulus ld_stimulus(std::string text, const Program& program) {
  std::replace(text.begin(), text.end(), '|', '\n');
  Diagnostics diagnostics;
  std::optional<Stimulus> stimulus;
  if (const auto source = decode_text(text + '\n', "s", diagnostics)) {
    stimulus = parse_stimulus(*source, program, diagnostics);
  }
  EXPECT_TRUE(stimulus) << printed(diagnostics);
  return stimulus ? std::move(*stimulus) : Stimulus{};
}

// What the scan has done, as "Yo=1 v=7 TX=65", with "ERROR" for a division by zero.
inline std::string done_in_scan(const Reference& reference, const Program& program) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " ") + part; };
  for (const ReferenceWrite& write : reference.writes()) {
    add(fmt::format("{}={}", device_name(write.device, program), write.value));
  }
  for (const int byte : reference.sent()) add(fmt::format("TX={}", byte));
  if (reference.error()) add("ERROR");
  return text;
}

class LdReferenceStory : public testing::TestWithParam<LdStory> {};

// For INSTANTIATE_TEST_SUITE_P.
inline std::string ld_story_name(const testing::TestParamInfo<LdStory>& info) {
  return info.param.name;
}

}  // namespace rung
