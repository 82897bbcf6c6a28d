// SPDX-License-Identifier: Apache-2.0
// Rows and cells of a CSV, each cell with its place: libraries for CSV do not say where a cell
// stands, and an error has to.
#pragma once

#include <string>
#include <vector>

#include "source/text_file.hpp"

namespace rung {

struct CsvCell {
  std::string raw;          // UTF-8, without the quotes
  std::string text;         // the same without blanks around it
  SourcePosition position;  // of its first character, which may be the quote
};

struct CsvRow {
  std::vector<CsvCell> cells;
  // The text of a cell; empty for one that the row does not have.
  const std::string& text(std::size_t column) const;
};

// Cells are separated by tabs if there is one outside of quotes in the first lines, else by commas.
// A quoted cell may hold separators and line ends, and a quote written twice. Rows without any text
// are left out. A quote that is never closed is an error.
std::vector<CsvRow> read_csv(const SourceText& source, Diagnostics& diagnostics);

}  // namespace rung
