// SPDX-License-Identifier: Apache-2.0
#include "melsec/lexer.hpp"

#include <string_view>
#include <utility>

#include "melsec/instructions.hpp"
#include "melsec/unsupported.hpp"

namespace rung {
namespace {

bool is_blank(char32_t c) {
  // Editors of east Asian text leave full-width and no-break blanks behind.
  return c == U' ' || c == U'\t' || c == U'\f' || c == 0x00A0 || c == 0x3000;
}

ListWord make_word(std::u32string_view text, int line, std::size_t index) {
  ListWord word{to_utf8(text), {}, {line, static_cast<int>(index) + 1}};
  word.upper = word.text;
  for (char& c : word.upper) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return word;
}

// Appends text[first, last), cut at slashes unless all of it is one instruction name.
void append_words(ListLine& words, std::u32string_view text, int line, std::size_t first,
                  std::size_t last) {
  if (first == last) return;
  ListWord whole = make_word(text.substr(first, last - first), line, first);
  if (whole.text.find('/') == std::string::npos || !find_instruction(whole.upper).empty() ||
      is_unsupported_name(whole.upper)) {
    words.push_back(std::move(whole));
    return;
  }
  std::size_t start = first;
  for (std::size_t i = first; i < last; ++i) {
    if (text[i] != U'/') continue;
    if (i > start) words.push_back(make_word(text.substr(start, i - start), line, start));
    words.push_back(make_word(text.substr(i, 1), line, i));
    start = i + 1;
  }
  if (last > start) words.push_back(make_word(text.substr(start, last - start), line, start));
}

}  // namespace

std::vector<ListLine> split_words(const SourceText& source, Diagnostics& diagnostics) {
  std::vector<ListLine> lines;
  bool in_block_comment = false;
  SourcePosition block_comment;
  for (std::size_t n = 0; n < source.lines.size(); ++n) {
    const std::u32string_view text = source.lines[n];
    const int number = static_cast<int>(n) + 1;
    ListLine words;
    std::size_t start = 0;
    std::size_t i = 0;
    const auto end_word = [&](std::size_t next) {
      append_words(words, text, number, start, i);
      start = i = next;
    };
    const auto at = [&](std::u32string_view mark) { return text.substr(i, mark.size()) == mark; };
    while (i < text.size()) {
      if (in_block_comment) {
        in_block_comment = !at(U"*)");
        i += in_block_comment ? 1 : 2;
        start = i;
      } else if (at(U"(*")) {
        in_block_comment = true;
        block_comment = {number, static_cast<int>(i) + 1};
        end_word(i + 2);
      } else if (at(U";") || at(U"#") || at(U"//")) {
        break;
      } else if (is_blank(text[i])) {
        end_word(i + 1);
      } else {
        ++i;
      }
    }
    if (!in_block_comment) append_words(words, text, number, start, i);
    if (!words.empty()) lines.push_back(std::move(words));
  }
  if (in_block_comment) {
    diagnostics.error(source.file, block_comment, "this comment is never closed", "end it with *)");
  }
  return lines;
}

}  // namespace rung
