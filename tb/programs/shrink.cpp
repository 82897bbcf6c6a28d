// SPDX-License-Identifier: Apache-2.0
#include "programs/shrink.hpp"

#include <algorithm>
#include <vector>

namespace rung {
namespace {

using Lines = std::vector<std::string>;

Lines split(const std::string& text) {
  Lines lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string join(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += line;
    text += '\n';
  }
  return text;
}

Lines without(const Lines& lines, std::size_t first, std::size_t count) {
  Lines rest(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(first));
  rest.insert(rest.end(), lines.begin() + static_cast<std::ptrdiff_t>(first + count), lines.end());
  return rest;
}

// Takes out every run of `count` lines that is not needed; true if there was one.
bool take_out(Lines& lines, std::size_t count,
              const std::function<bool(const std::string&)>& still_fails) {
  bool changed = false;
  for (std::size_t first = 0; first + count <= lines.size();) {
    Lines rest = without(lines, first, count);
    if (still_fails(join(rest))) {
      lines = std::move(rest);
      changed = true;
    } else {
      ++first;
    }
  }
  return changed;
}

}  // namespace

std::string shrink(const std::string& text,
                   const std::function<bool(const std::string&)>& still_fails) {
  Lines lines = split(text);
  bool changed = true;
  while (changed) {
    changed = false;
    // Long runs first: a network goes in one try. Then pairs that only go together, ever further
    // apart, such as MPS and MPP, FOR and NEXT.
    for (std::size_t count = std::max<std::size_t>(lines.size() / 2, 1); count > 0;
         count = count > 8 ? count / 2 : count - 1) {
      changed = take_out(lines, count, still_fails) || changed;
    }
    for (std::size_t first = 0; first < lines.size(); ++first) {
      for (std::size_t second = first + 1; second < lines.size(); ++second) {
        Lines rest = without(without(lines, second, 1), first, 1);
        if (!still_fails(join(rest))) continue;
        lines = std::move(rest);
        changed = true;
        break;
      }
    }
  }
  return join(lines);
}

}  // namespace rung
