// SPDX-License-Identifier: Apache-2.0
// The words of a `.flow` text: a line each, without comments.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/text_file.hpp"

namespace rung::flowchart {

struct Token {
  enum class Kind {
    Word,    // a name, a keyword, a device: letters, digits, `_` and `.`, the first no digit
    Number,  // begins with a digit
    Text,    // between quotes
    Symbol,  // = <> <= ( ...
    Bad,     // a character that has no meaning, or a text without an end
    End,     // of the line
  };
  Kind kind = Kind::End;
  std::string text;  // UTF-8; of a Text without its quotes
  SourcePosition position;

  bool is(std::string_view what) const {
    return (kind == Kind::Word || kind == Kind::Symbol) && text == what;
  }
};

// The last token is the End, right behind the one before it; there is at least one more.
using Line = std::vector<Token>;

// The lines that have tokens.
std::vector<Line> split_lines(const SourceText& source);

// Why a line is refused; the reader goes on with the next one.
struct Refusal {
  SourcePosition position;
  std::string what;
  std::string mend;
};

// Goes through a line. What is not there as it has to be is thrown as a Refusal.
class Cursor {
 public:
  explicit Cursor(const Line& line) : line_(line) {}

  const Token& peek() const { return line_[next_]; }
  bool at_end() const { return peek().kind == Token::Kind::End; }
  const Token& take() {
    const Token& token = line_[next_];
    if (next_ + 1 < line_.size()) ++next_;
    return token;
  }
  bool accept(std::string_view what) {
    if (!peek().is(what)) return false;
    take();
    return true;
  }
  // `form` is how such a line is written.
  void expect(std::string_view what, std::string_view form);
  // A name that is no keyword. `what` it is the name of: "a task".
  const Token& name(std::string_view what, std::string_view form);
  // A decimal number from `least` to `most`. `what` it is: "a unit".
  int number(int least, int most, std::string_view what, std::string_view form);
  void expect_end(std::string_view form);

 private:
  const Line& line_;
  std::size_t next_ = 0;
};

bool is_keyword(std::string_view word);
// Keyword near `word`, in whatever case it is written; empty if there is none.
std::string_view near_keyword(std::string_view word);
// The value of a decimal or 0x number, at most 2^31 - 1; nothing if it is none.
std::optional<int> number_of(std::string_view text);
// What a message calls a token: its text, or "the end of the line".
std::string shown(const Token& token);

}  // namespace rung::flowchart
