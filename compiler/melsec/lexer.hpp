// SPDX-License-Identifier: Apache-2.0
// Words of a plain instruction list: without comments, each with its place.
#pragma once

#include <string>
#include <vector>

#include "source/text_file.hpp"

namespace rung {

struct ListWord {
  std::string text;   // UTF-8, as written
  std::string upper;  // the same with ASCII letters in upper case
  SourcePosition position;
};

// The words of one line of the source; lines without any are left out.
using ListLine = std::vector<ListWord>;

// Splits at blanks. Comments run from `;`, `//` or `#` to the end of the line, or from `(*` to
// `*)`, over lines too; one that is never closed is an error at its start. `/` is a word of its own
// wherever it stands, but in an instruction name such as `D/`.
std::vector<ListLine> split_words(const SourceText& source, Diagnostics& diagnostics);

}  // namespace rung
