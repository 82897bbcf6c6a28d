// SPDX-License-Identifier: Apache-2.0
// Where something stands in a source file, and what is wrong with it.
#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

namespace rung {

// A place in a source file: line and column count from 1; a column counts characters of the decoded
// line. 1:1 stands for a whole file.
struct SourcePosition {
  int line = 1;
  int column = 1;
  bool operator==(const SourcePosition&) const = default;
};

enum class Severity { Error, Warning, Note };

struct Diagnostic {
  Severity severity = Severity::Error;
  std::string file;
  SourcePosition position;
  std::string what;  // what is wrong, and why
  std::string mend;  // what to do about it; may be empty
};

// Collects what is wrong with the input, so that one run reports all of it.
class Diagnostics {
 public:
  void error(const std::string& file, SourcePosition position, std::string what,
             std::string mend = {});
  void warning(const std::string& file, SourcePosition position, std::string what,
               std::string mend = {});
  void note(const std::string& file, SourcePosition position, std::string what);

  bool has_errors() const { return errors_ > 0; }
  int error_count() const { return errors_; }
  const std::vector<Diagnostic>& all() const { return all_; }

  // `file:line:col: error: what`, then how to mend it on an indented line, in the order of source.
  void print(std::ostream& out) const;

 private:
  std::vector<Diagnostic> all_;
  int errors_ = 0;
};

}  // namespace rung
