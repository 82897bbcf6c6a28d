// SPDX-License-Identifier: Apache-2.0
#include "rungs/format_string.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace rung {
namespace {

constexpr std::string_view kEscapes =
    R"(the escapes are \r \n \b \f \\ \xAB, and \N or \-N for N digits (1 to 5) of the variable)";

// The value of a hexadecimal digit, -1 for any other character.
int hex_value(std::int32_t c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string shown_escape(std::int32_t c) {
  return c > ' ' && c < 0x7F ? fmt::format("\\{}", static_cast<char>(c))
                             : fmt::format("\\ before the character {}", c);
}

class FormatString {
 public:
  explicit FormatString(const std::vector<std::int32_t>& codes) : codes_(codes) {
    while (at_ < codes_.size() && !fault_) {
      const std::int32_t c = codes_[at_++];
      if (c == '\\') {
        escape();
      } else {
        add_byte(c);
      }
    }
  }

  std::vector<StringStep> steps;
  std::optional<StringFault> fault() const { return fault_; }

 private:
  // The character here, 0 behind the end.
  std::int32_t peek(std::size_t ahead = 0) const {
    return at_ + ahead < codes_.size() ? codes_[at_ + ahead] : 0;
  }
  void add_byte(std::int32_t byte) {
    steps.push_back({StringStep::Kind::Byte, static_cast<int>(byte) & 0xFF, false});
  }
  void refuse(std::string what) { fault_ = {std::move(what), std::string(kEscapes)}; }

  void escape() {
    if (at_ == codes_.size()) {
      return refuse("a \\ with nothing behind it ends the string");
    }
    const std::int32_t c = peek();
    if (c == '-' || (c >= '0' && c <= '9')) return digits();
    ++at_;
    switch (c) {
      case 'r':
        return add_byte('\r');
      case 'n':
        return add_byte('\n');
      case 'b':
        return add_byte('\b');
      case 'f':
        return add_byte('\f');
      case '\\':
        return add_byte('\\');
      case 'x':
        return hexadecimal();
      default:
        return refuse(fmt::format("{} is no escape of a format string", shown_escape(c)));
    }
  }

  void hexadecimal() {
    const int high = hex_value(peek());
    const int low = hex_value(peek(1));
    if (high < 0 || low < 0) return refuse("\\x without two hexadecimal digits behind it");
    at_ += 2;
    add_byte(16 * high + low);
  }

  void digits() {
    const bool sign = peek() == '-';
    if (sign) ++at_;
    const std::int32_t count = peek() - '0';
    if (count < 1 || count > 5) {
      return refuse(
          sign ? "\\- without a number of digits from 1 to 5"
               : fmt::format("{}: digits of the variable are 1 to 5", shown_escape(peek())));
    }
    ++at_;
    if (shown_) {
      fault_ = {"the string shows the variable twice",
                "one \\N or \\-N a string: write the second value with another FORMATTED STRING"};
      return;
    }
    shown_ = true;
    if (sign) steps.push_back({StringStep::Kind::Sign, 0, false});
    int power = 1;
    for (std::int32_t i = 1; i < count; ++i) power *= 10;
    for (; power > 0; power /= 10) {
      steps.push_back({StringStep::Kind::Digit, power, power == 1});
    }
  }

  const std::vector<std::int32_t>& codes_;
  std::size_t at_ = 0;
  bool shown_ = false;
  std::optional<StringFault> fault_;
};

}  // namespace

std::vector<StringStep> string_steps(const std::vector<std::int32_t>& codes) {
  return FormatString(codes).steps;
}

std::optional<StringFault> string_fault(const std::vector<std::int32_t>& codes) {
  return FormatString(codes).fault();
}

bool shows_variable(const std::vector<std::int32_t>& codes) {
  const std::vector<StringStep> steps = string_steps(codes);
  return std::any_of(steps.begin(), steps.end(),
                     [](const StringStep& step) { return step.kind == StringStep::Kind::Digit; });
}

}  // namespace rung
