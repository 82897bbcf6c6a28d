// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <sstream>
#include <vector>

#include "programs/shrink.hpp"

namespace rung {
namespace {

using Lines = std::vector<std::string>;
using Test = std::function<bool(const std::string&)>;

// A line, or a block from its RUNG, PARALLEL or SERIES to its END.
struct Span {
  std::size_t first;
  std::size_t last;  // this line included
};

std::string join(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

std::string word_of(const std::string& line) {
  std::istringstream in(line);
  std::string word;
  in >> word;
  return word;
}

// All spans behind PROGRAM, by their first line: a block stands before what it contains.
std::vector<Span> spans_of(const Lines& lines) {
  std::vector<Span> spans;
  std::vector<std::size_t> open;
  const auto program = std::find(lines.begin(), lines.end(), "PROGRAM");
  for (std::size_t i = program - lines.begin() + 1; i < lines.size(); ++i) {
    const std::string word = word_of(lines[i]);
    if (word == "END") {
      if (open.empty()) return spans;
      spans[open.back()].last = i;
      open.pop_back();
      continue;
    }
    if (word == "RUNG" || word == "PARALLEL" || word == "SERIES") open.push_back(spans.size());
    spans.push_back({i, i});
  }
  return spans;
}

// `lines` with `kept` lines in the place of `span`.
Lines replaced(const Lines& lines, Span span, Span kept, bool any_kept) {
  Lines rest(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(span.first));
  if (any_kept) {
    rest.insert(rest.end(), lines.begin() + static_cast<std::ptrdiff_t>(kept.first),
                lines.begin() + static_cast<std::ptrdiff_t>(kept.last + 1));
  }
  rest.insert(rest.end(), lines.begin() + static_cast<std::ptrdiff_t>(span.last + 1), lines.end());
  return rest;
}

// Takes out spans that are not needed, from the last to the first, which leaves the places of those
// before them.
bool take_out(Lines& lines, const Test& still_fails) {
  bool changed = false;
  const std::vector<Span> spans = spans_of(lines);
  for (std::size_t i = spans.size(); i-- > 0;) {
    const std::vector<Span> now = spans_of(lines);
    if (i >= now.size()) continue;
    Lines rest = replaced(lines, now[i], {}, false);
    if (!still_fails(join(rest))) continue;
    lines = std::move(rest);
    changed = true;
  }
  return changed;
}

// Puts one of its branches in the place of a PARALLEL.
bool unfold(Lines& lines, const Test& still_fails) {
  const std::vector<Span> spans = spans_of(lines);
  for (const Span& outer : spans) {
    if (word_of(lines[outer.first]) != "PARALLEL") continue;
    for (const Span& branch : spans) {
      if (branch.first <= outer.first || branch.last >= outer.last) continue;
      const bool series = word_of(lines[branch.first]) == "SERIES";
      if (series && branch.last - branch.first < 2) continue;
      const Span kept = series ? Span{branch.first + 1, branch.last - 1} : branch;
      Lines rest = replaced(lines, outer, kept, true);
      if (!still_fails(join(rest))) continue;
      lines = std::move(rest);
      return true;
    }
  }
  return false;
}

}  // namespace

std::string shrink_ldmicro(const std::string& text, const Test& still_fails) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  while (take_out(lines, still_fails) || unfold(lines, still_fails)) {
  }
  return join(lines);
}

}  // namespace rung
