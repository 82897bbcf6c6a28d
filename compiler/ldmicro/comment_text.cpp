// SPDX-License-Identifier: Apache-2.0
#include "ldmicro/comment_text.hpp"

namespace rung {

std::string unescape_comment(std::string_view line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\\') {
      text += line[i];
      continue;
    }
    if (++i == line.size()) break;
    text += line[i] == 'n' ? '\n' : line[i] == 'r' ? '\r' : line[i];
  }
  return text;
}

std::string escape_comment(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c == '\n') {
      line += "\\n";
    } else if (c == '\r') {
      line += "\\r";
    } else if (c == '\\') {
      line += "\\\\";
    } else {
      line += c;
    }
  }
  return line;
}

std::string ld_note(std::string_view line) {
  const std::string text = unescape_comment(line);
  std::string note;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (!pair) note += text[i] == '\r' ? '\n' : text[i];
  }
  return note;
}

std::string ld_comment(std::string_view note) {
  std::string text;
  for (const char c : note) {
    if (c == '\n') text += '\r';
    text += c;
  }
  return escape_comment(text);
}

}  // namespace rung
