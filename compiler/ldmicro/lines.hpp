// SPDX-License-Identifier: Apache-2.0
// Lines and words of an LDmicro file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "source/text_file.hpp"

namespace rung {

struct LdWord {
  std::string text;
  SourcePosition position;
};

// A line that says something.
struct LdLine {
  std::vector<LdWord> words;  // at least one
  std::string raw;            // from the first word to the end
  const std::string& keyword() const { return words.front().text; }
  SourcePosition position() const { return words.front().position; }
  // The words with one blank between them; of a COMMENT the line as it stands.
  std::string text() const;
};

// The lines without empty ones and those that begin with `;`.
std::vector<LdLine> ld_lines(const SourceText& source);

}  // namespace rung
