// SPDX-License-Identifier: Apache-2.0
#include "flowchart/header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "rung_flow.hpp"

namespace rung::flowchart {
namespace {

constexpr std::string_view kBoardForm = "board NAME = unit 1 board 0";

}  // namespace

bool Header::line(const Line& line) {
  Cursor cursor(line);
  const std::string_view word = line.front().kind == Token::Kind::Word
                                    ? std::string_view(line.front().text)
                                    : std::string_view();
  if (word == "dialect") {
    dialect(cursor);
  } else if (word == "unit") {
    unit(cursor);
  } else if (word == "ladder") {
    ladder(cursor);
  } else if (word == "board") {
    board(cursor);
  } else {
    return false;
  }
  return true;
}

void Header::check_only(const Token& token, int& line) const {
  if (line == 0) {
    line = token.position.line;
    return;
  }
  throw Refusal{token.position,
                fmt::format("a second line `{}`: line {} has said it already", token.text, line),
                "leave one of them out"};
}

void Header::dialect(Cursor& cursor) {
  check_only(cursor.take(), dialect_line_);
  const Token& name = cursor.peek();
  const std::optional<Dialect> found = find_dialect(name.text);
  if (!found || *found == Dialect::Ldmicro || name.kind != Token::Kind::Word) {
    throw Refusal{name.position, fmt::format("{}: not a dialect of flows", shown(name)),
                  "write dialect fx, dialect q or dialect paper"};
  }
  cursor.take();
  chart_.dialect = *found;
  cursor.expect_end("dialect fx");
}

void Header::unit(Cursor& cursor) {
  const Token& word = cursor.take();
  check_only(word, unit_line_);
  if (!chart_.boards.empty()) {
    throw Refusal{word.position, "the unit stands before the boards, which may be its own",
                  "put this line at the beginning"};
  }
  chart_.unit = cursor.number(1, flow::flow_units, "a unit", "unit 1");
  cursor.expect_end("unit 1");
}

void Header::ladder(Cursor& cursor) {
  check_only(cursor.take(), ladder_line_);
  const Token& file = cursor.peek();
  if (file.kind != Token::Kind::Text || file.text.empty()) {
    throw Refusal{file.position,
                  fmt::format("{} where the name of a file has to stand", shown(file)),
                  "write ladder \"line.il\""};
  }
  cursor.take();
  cursor.expect_end("ladder \"line.il\"");
  ladder_ = file;
}

void Header::board(Cursor& cursor) {
  Board board;
  cursor.take();
  const Token& name = cursor.name("a board", kBoardForm);
  board.name = name.text;
  board.position = name.position;
  // Declared in any case, so that what names it is not refused for it.
  chart_.boards.push_back(board);
  names_.declare(name);
  cursor.expect("=", kBoardForm);
  cursor.expect("unit", kBoardForm);
  const Token& place = cursor.peek();
  board.unit = cursor.number(1, flow::flow_units, "a unit", kBoardForm);
  cursor.expect("board", kBoardForm);
  board.number = cursor.number(0, flow::flow_boards - 1, "a board", kBoardForm);
  const auto same = std::find_if(
      chart_.boards.begin(), chart_.boards.end() - 1,
      [&](const Board& other) { return other.unit == board.unit && other.number == board.number; });
  if (same != chart_.boards.end() - 1) {
    throw Refusal{place.position,
                  fmt::format("board {} of unit {} is {} already (line {})", board.number,
                              board.unit, same->name, same->position.line),
                  "use that name"};
  }
  attributes(cursor, board);
  chart_.boards.back() = board;
}

void Header::attributes(Cursor& cursor, Board& board) const {
  const bool own = board.unit == chart_.unit;
  std::optional<SourcePosition> link;
  while (!cursor.at_end()) {
    const Token& token = cursor.take();
    if (token.is("link")) {
      link = token.position;
    } else if (!token.is("panel") && !token.is("exclusive")) {
      throw Refusal{token.position, fmt::format("{}: not an attribute of a board", shown(token)),
                    "they are panel, link and exclusive"};
    } else if (!own) {
      throw Refusal{token.position,
                    fmt::format("{} of a board of unit {}: this is unit {}", token.text, board.unit,
                                chart_.unit),
                    "leave it out; that unit's own program says it"};
    } else if (token.is("panel")) {
      board.panel = true;
    } else {
      board.exclusive = true;
    }
  }
  board.over_link = board.panel || !own;
  if (link && !board.over_link) {
    throw Refusal{*link, "link of this unit's own words, which lie over no link",
                  "leave it out, or write panel for the device on the panel's line"};
  }
}

}  // namespace rung::flowchart
