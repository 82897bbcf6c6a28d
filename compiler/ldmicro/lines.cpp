// SPDX-License-Identifier: Apache-2.0
#include "ldmicro/lines.hpp"

#include <algorithm>

namespace rung {
namespace {

constexpr std::u32string_view kBlanks = U" \t\f";

LdLine split(std::u32string_view line, int number) {
  LdLine result;
  std::size_t at = line.find_first_not_of(kBlanks);
  if (at != std::u32string_view::npos) result.raw = to_utf8(line.substr(at));
  while (at != std::u32string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    result.words.push_back(
        {to_utf8(line.substr(at, end - at)), {number, static_cast<int>(at) + 1}});
    if (result.words.front().text == "COMMENT") break;
    at = line.find_first_not_of(kBlanks, end);
  }
  return result;
}

}  // namespace

std::string LdLine::text() const {
  if (keyword() == "COMMENT") return raw;
  std::string text;
  for (const LdWord& word : words) text += (text.empty() ? "" : " ") + word.text;
  return text;
}

void LdLines::advance() {
  line_ = {};
  while (at_end() && next_ < source_.lines.size()) {
    const int number = static_cast<int>(next_) + 1;
    line_ = split(source_.lines[next_++], number);
    if (!at_end() && line_.keyword().starts_with(';')) line_ = {};
  }
}

}  // namespace rung
