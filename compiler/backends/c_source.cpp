// SPDX-License-Identifier: Apache-2.0
#include "backends/c_source.hpp"

#include <cctype>

namespace rung {

std::string comment_text(std::string_view text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool ends = c == '*' && i + 1 < text.size() && text[i + 1] == '/';
    const bool begins = c == '/' && i + 1 < text.size() && text[i + 1] == '*';
    safe += static_cast<unsigned char>(c) < 0x20 || c == '\\' || c == '?' ? '_' : c;
    if (ends || begins) safe += ' ';
  }
  return safe;
}

CSource::CSource(std::string_view prefix) : prefix_(prefix), base_(prefix) {
  for (char& c : base_) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  while (base_.size() > 1 && base_.back() == '_') base_.pop_back();
}

void CSource::close(std::string_view text) {
  --depth_;
  code(text);
}

void CSource::otherwise() {
  close("} else {");
  ++depth_;
}

void CSource::code(std::string_view text) {
  bool begins = true;
  for (const char c : text) {
    if (begins && c != '\n') indent();
    begins = c == '\n';
    if (c == '@') {
      text_ += base_;
    } else if (c == '$') {
      text_ += prefix_;
    } else {
      text_ += c;
    }
  }
  text_ += '\n';
}

void CSource::comment(std::string_view text) {
  indent();
  text_ += text;
  text_ += '\n';
}

}  // namespace rung
