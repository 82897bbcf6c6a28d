// SPDX-License-Identifier: Apache-2.0
// The lines before the first task: dialect, unit, ladder, boards.
#pragma once

#include <string>

#include "flowchart/flowchart.hpp"
#include "flowchart/names.hpp"

namespace rung::flowchart {

class Header {
 public:
  explicit Header(Flowchart& chart) : chart_(chart) {}

  // Takes a line that begins with one of the header's words; false for any other. Throws a Refusal.
  bool line(const Line& line);

  const Names& board_names() const { return names_; }
  // As the text names it; empty if it has none.
  const Token& ladder() const { return ladder_; }

 private:
  void dialect(Cursor& cursor);
  void unit(Cursor& cursor);
  void ladder(Cursor& cursor);
  void board(Cursor& cursor);
  void attributes(Cursor& cursor, Board& board) const;
  void check_only(const Token& token, int& line) const;

  Flowchart& chart_;
  Names names_{"board"};
  Token ladder_;
  int dialect_line_ = 0, unit_line_ = 0, ladder_line_ = 0;
};

}  // namespace rung::flowchart
