// SPDX-License-Identifier: Apache-2.0
#include "melsec/csv.hpp"

#include <algorithm>
#include <utility>

namespace rung {
namespace {

// Lines that the form of a file shows in: title, controller, headers and the first instructions.
constexpr std::size_t kFirstLines = 8;

bool has_outside_quotes(std::u32string_view line, char32_t separator) {
  bool quoted = false;
  for (const char32_t c : line) {
    if (c == U'"') quoted = !quoted;
    if (c == separator && !quoted) return true;
  }
  return false;
}

std::string trimmed(std::u32string_view text) {
  const auto is_blank = [](char32_t c) {
    return c == U' ' || c == U'\t' || c == U'\n' || c == 0x00A0 || c == 0x3000;
  };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return to_utf8(text);
}

class CsvReader {
 public:
  CsvReader(const SourceText& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {
    const std::size_t lines = std::min(source.lines.size(), kFirstLines);
    const bool tabs =
        std::any_of(source.lines.begin(), source.lines.begin() + static_cast<std::ptrdiff_t>(lines),
                    [](const std::u32string& line) { return has_outside_quotes(line, U'\t'); });
    separator_ = tabs ? U'\t' : U',';
  }

  std::vector<CsvRow> read() {
    for (; line_ < source_.lines.size(); ++line_) row();
    return std::move(rows_);
  }

 private:
  // A row; with line ends within quotes it goes on over several lines.
  void row() {
    CsvRow row;
    bool has_text = false;
    for (column_ = 0;; ++column_) {
      CsvCell cell = this->cell();
      has_text = has_text || !cell.text.empty();
      row.cells.push_back(std::move(cell));
      if (column_ >= line().size()) break;
    }
    if (has_text) rows_.push_back(std::move(row));
  }

  // The cell at the current place; afterwards that is the separator after it, or the line's end.
  CsvCell cell() {
    CsvCell cell;
    cell.position = {static_cast<int>(line_) + 1, static_cast<int>(column_) + 1};
    std::u32string text;
    if (column_ < line().size() && line()[column_] == U'"') {
      quoted(text, cell.position);
    }
    for (; column_ < line().size() && line()[column_] != separator_; ++column_) {
      text.push_back(line()[column_]);
    }
    cell.raw = to_utf8(text);
    cell.text = trimmed(text);
    return cell;
  }

  void quoted(std::u32string& text, SourcePosition start) {
    for (++column_;;) {
      if (column_ >= line().size()) {
        if (line_ + 1 == source_.lines.size()) {
          diagnostics_.error(source_.file, start, "this quote is never closed",
                             "the file was cut off: copy or export it again");
          return;
        }
        ++line_;
        column_ = 0;
        text.push_back(U'\n');
      } else if (line()[column_] != U'"') {
        text.push_back(line()[column_++]);
      } else if (column_ + 1 < line().size() && line()[column_ + 1] == U'"') {
        text.push_back(U'"');
        column_ += 2;
      } else {
        ++column_;
        return;
      }
    }
  }

  const std::u32string& line() const { return source_.lines[line_]; }

  const SourceText& source_;
  Diagnostics& diagnostics_;
  char32_t separator_ = U',';
  std::size_t line_ = 0;
  std::size_t column_ = 0;
  std::vector<CsvRow> rows_;
};

}  // namespace

const std::string& CsvRow::text(std::size_t column) const {
  static const std::string kEmpty;
  return column < cells.size() ? cells[column].text : kEmpty;
}

std::vector<CsvRow> read_csv(const SourceText& source, Diagnostics& diagnostics) {
  return CsvReader(source, diagnostics).read();
}

}  // namespace rung
