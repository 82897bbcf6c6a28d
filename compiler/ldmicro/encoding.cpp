// SPDX-License-Identifier: Apache-2.0
#include <utf8.h>

#include <algorithm>

#include "ldmicro/comment_text.hpp"
#include "ldmicro/ldmicro.hpp"
#include "source/code_page.hpp"

namespace rung {
namespace {

constexpr std::string_view kComment = "COMMENT";

// Where the text of a comment begins in `line`, or npos when it is none.
std::size_t comment_start(std::string_view line) {
  const std::size_t start = line.find_first_not_of(" \t");
  if (start == std::string_view::npos || !line.substr(start).starts_with(kComment)) {
    return std::string_view::npos;
  }
  const std::size_t text = start + kComment.size();
  return text < line.size() && line[text] == ' ' ? text + 1 : std::string_view::npos;
}

// One line in UTF-8; nothing if it is not valid in `page`.
std::optional<std::string> convert_line(std::string_view line, CodePage page) {
  const std::size_t comment = comment_start(line);
  auto text = decode(line.substr(0, comment), page);
  if (!text || comment == std::string_view::npos) return text;
  const bool carriage_return = line.ends_with('\r');
  if (carriage_return) line.remove_suffix(1);
  const auto note = decode(unescape_comment(line.substr(comment)), page);
  if (!note) return std::nullopt;
  return *text + escape_comment(*note) + (carriage_return ? "\r" : "");
}

std::optional<std::string> convert(std::string_view bytes, CodePage page) {
  std::string text;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const auto line = convert_line(bytes.substr(0, end), page);
    if (!line) return std::nullopt;
    text += *line;
    if (end < bytes.size()) text += '\n';
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return text;
}

}  // namespace

std::optional<SourceText> decode_ldmicro(std::string_view bytes, const std::string& file,
                                         Diagnostics& diagnostics) {
  const bool wide = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF") ||
                    bytes.find('\0') != std::string_view::npos;
  if (!wide && !utf8::is_valid(bytes.begin(), bytes.end())) {
    for (const CodePage page : {CodePage::Japanese, CodePage::Western}) {
      if (const auto text = convert(bytes, page)) return decode_text(*text, file, diagnostics);
    }
  }
  return decode_text(bytes, file, diagnostics);
}

}  // namespace rung
