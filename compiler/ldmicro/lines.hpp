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

// The lines of a file, one at a time, without empty ones and those that begin with `;`.
class LdLines {
 public:
  explicit LdLines(const SourceText& source) : source_(source) { advance(); }

  bool at_end() const { return line_.words.empty(); }
  // The line here; not at the end.
  const LdLine& line() const { return line_; }
  void advance();

 private:
  const SourceText& source_;
  std::size_t next_ = 0;
  LdLine line_;
};

}  // namespace rung
