// SPDX-License-Identifier: Apache-2.0
// Lines of C under construction.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace rung {

// Text that can stand in a C comment: neither its end nor a trigraph or line splice.
std::string comment_text(std::string_view text);

// In the lines given to it, `$` stands for the prefix of the functions that a user calls (PlcCycle)
// and `@` for that of everything else (plc.M[1], plc_word); C has no other use of either sign.
class CSource {
 public:
  explicit CSource(std::string_view prefix);

  // One line, indented.
  template <typename... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    code(fmt::format(format, std::forward<Args>(args)...));
  }
  // The same, with the lines up to close() indented further.
  template <typename... Args>
  void open(fmt::format_string<Args...> format, Args&&... args) {
    code(fmt::format(format, std::forward<Args>(args)...));
    ++depth_;
  }
  // Ends what open() began.
  void close(std::string_view text = "}");
  // `} else {`
  void otherwise();
  // Code of any number of lines, each indented.
  void code(std::string_view text);
  // A line whose signs stand for themselves.
  void comment(std::string_view text);
  // No lines, but the same prefix and depth.
  CSource empty_copy() const {
    CSource copy = *this;
    copy.text_.clear();
    return copy;
  }
  // Another's lines, as they are.
  void append(const CSource& other) { text_ += other.text_; }
  void blank() { text_ += '\n'; }

  const std::string& text() const { return text_; }

 private:
  void indent() { text_.append(static_cast<std::size_t>(2 * depth_), ' '); }

  std::string prefix_;
  std::string base_;
  std::string text_;
  int depth_ = 0;
};

}  // namespace rung
