// SPDX-License-Identifier: Apache-2.0
#include "flowchart/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>

#include "source/nearest.hpp"

namespace rung::flowchart {
namespace {

constexpr std::string_view kKeywords[] = {
    "dialect", "ladder", "unit", "board", "panel", "link",   "exclusive", "task",
    "start",   "step",   "read", "from",  "count", "at",     "set",       "reset",
    "stop",    "write",  "to",   "when",  "goto",  "failed", "end",       "running",
    "wait",    "if",     "on",   "off",   "not",   "and",    "or",        "xor"};

constexpr std::u32string_view kPairs[] = {U"<>", U"<=", U">=", U"==", U"!="};
constexpr std::u32string_view kSingles = U"=<>+-*/%()";

bool is_blank(char32_t c) {
  return c == U' ' || c == U'\t' || c == U'\f' || c == 0x00A0 || c == 0x3000;
}
bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
// Names may be in any script.
bool is_letter(char32_t c) {
  return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || c == U'_' ||
         (c > 0x00A0 && !is_blank(c));
}
bool is_part(char32_t c) { return is_letter(c) || is_digit(c) || c == U'.'; }

class Splitter {
 public:
  Splitter(std::u32string_view text, int number) : text_(text), number_(number) {}

  Line split() {
    while (true) {
      while (i_ < text_.size() && is_blank(text_[i_])) ++i_;
      if (i_ == text_.size() || text_[i_] == U'#') break;
      one();
    }
    if (!line_.empty()) line_.push_back({Token::Kind::End, {}, {number_, end_ + 1}});
    return std::move(line_);
  }

 private:
  void one() {
    const char32_t c = text_[i_];
    if (is_letter(c) || is_digit(c)) {
      std::size_t end = i_;
      while (end < text_.size() && is_part(text_[end])) ++end;
      return add(is_digit(c) ? Token::Kind::Number : Token::Kind::Word, end - i_);
    }
    if (c == U'"') return quoted();
    for (const std::u32string_view pair : kPairs) {
      if (text_.substr(i_, 2) == pair) return add(Token::Kind::Symbol, 2);
    }
    add(kSingles.find(c) == std::u32string_view::npos ? Token::Kind::Bad : Token::Kind::Symbol, 1);
  }

  void quoted() {
    const std::size_t end = text_.find(U'"', i_ + 1);
    if (end == std::u32string_view::npos) return add(Token::Kind::Bad, text_.size() - i_);
    add(Token::Kind::Text, end + 1 - i_);
    std::string& text = line_.back().text;
    text = text.substr(1, text.size() - 2);
  }

  void add(Token::Kind kind, std::size_t length) {
    line_.push_back({kind, to_utf8(text_.substr(i_, length)), {number_, static_cast<int>(i_) + 1}});
    i_ += length;
    end_ = static_cast<int>(i_);
  }

  std::u32string_view text_;
  int number_;
  std::size_t i_ = 0;
  int end_ = 0;  // behind the last token
  Line line_;
};

}  // namespace

std::vector<Line> split_lines(const SourceText& source) {
  std::vector<Line> lines;
  for (std::size_t n = 0; n < source.lines.size(); ++n) {
    Line line = Splitter(source.lines[n], static_cast<int>(n) + 1).split();
    if (!line.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

bool is_keyword(std::string_view word) {
  return std::find(std::begin(kKeywords), std::end(kKeywords), word) != std::end(kKeywords);
}

std::string_view near_keyword(std::string_view word) {
  std::string lower(word.substr(0, 40));
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return nearest(lower, kKeywords);
}

std::optional<int> number_of(std::string_view text) {
  const bool hex = text.starts_with("0x") || text.starts_with("0X");
  if (hex) text.remove_prefix(2);
  if (text.empty() || text.front() == '-') return std::nullopt;
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value, hex ? 16 : 10);
  if (stop != end) return std::nullopt;
  if (failure != std::errc()) return INT32_MAX;
  return static_cast<int>(std::min<std::int64_t>(value, INT32_MAX));
}

std::string shown(const Token& token) {
  if (token.kind == Token::Kind::End) return "the end of the line";
  return rung::shown(token.text);
}

void Cursor::expect(std::string_view what, std::string_view form) {
  if (accept(what)) return;
  throw Refusal{peek().position, fmt::format("{} where `{}` has to stand", shown(peek()), what),
                fmt::format("write {}", form)};
}

const Token& Cursor::name(std::string_view what, std::string_view form) {
  const Token& token = peek();
  if (token.kind != Token::Kind::Word || token.text.find('.') != std::string::npos) {
    throw Refusal{token.position,
                  fmt::format("{} where the name of {} has to stand", shown(token), what),
                  fmt::format("write {}; names are letters, digits and _", form)};
  }
  if (is_keyword(token.text)) {
    throw Refusal{token.position,
                  fmt::format("{} is a word of the language, not the name of {}", token.text, what),
                  "take another name, or write it in capitals"};
  }
  return take();
}

int Cursor::number(int least, int most, std::string_view what, std::string_view form) {
  const Token& token = peek();
  const std::optional<int> value =
      token.kind == Token::Kind::Number ? number_of(token.text) : std::nullopt;
  if (!value) {
    throw Refusal{token.position,
                  fmt::format("{} where the number of {} has to stand", shown(token), what),
                  fmt::format("write {}", form)};
  }
  if (*value < least || *value > most) {
    throw Refusal{token.position, fmt::format("{}: not the number of {}", shown(token), what),
                  fmt::format("it is {} to {}", least, most)};
  }
  take();
  return *value;
}

void Cursor::expect_end(std::string_view form) {
  if (at_end()) return;
  throw Refusal{peek().position, fmt::format("{}: the line should end before this", shown(peek())),
                fmt::format("write {}", form)};
}

}  // namespace rung::flowchart
