// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <utf8.h>

#include "ldmicro/element.hpp"
#include "ldmicro/numbers.hpp"
#include "rungs/format_string.hpp"

namespace rung {
namespace {

// More than any processor has variables.
constexpr std::int64_t kMaxStages = 10000;

// The number of rows that the line gives; that many must be there behind the `between` words that
// follow it, each of `words` words.
std::size_t row_count(LdElement& element, const char* rows, std::size_t words,
                      std::size_t between = 0) {
  const LdWord& word = element.peek();
  const std::int64_t count = element.whole_number();
  if (!element.good()) return 0;
  const std::size_t found = (element.left() - between) / words;
  if (count >= 0 && static_cast<std::uint64_t>(count) <= found) {
    return static_cast<std::size_t>(count);
  }
  element.refuse(word.position,
                 fmt::format("{}: {} {} are announced, and there are {}", element.line().keyword(),
                             count, rows, found),
                 "write them all, or the number that there are");
  return 0;
}

// Target and index; the order of the source.
void read_target(LdElement& element, Instruction& instruction) {
  const Operand target = element.variable();
  instruction.operands = {target, element.variable()};
}

void check_points(LdElement& element, const std::vector<std::int32_t>& table,
                  SourcePosition position) {
  if (table.empty()) {
    return element.refuse(position, "PIECEWISE_LINEAR without a point",
                          "write at least one, and two for a line");
  }
  for (std::size_t i = 2; i < table.size(); i += 2) {
    const int x0 = table[i - 2];
    const int x1 = table[i];
    if (x1 <= x0) {
      return element.refuse(
          position, fmt::format("PIECEWISE_LINEAR: x = {} does not lie behind x = {}", x1, x0),
          "sort the points by x, each x once");
    }
    const std::int64_t product = static_cast<std::int64_t>(x1 - x0) * (table[i + 1] - table[i - 1]);
    if (product >= INT16_MAX || product <= INT16_MIN) {
      return element.refuse(
          position,
          fmt::format(
              "PIECEWISE_LINEAR: between x = {} and {} the distances multiply to {}, beyond "
              "the 16 bits of the interpolation",
              x0, x1, product),
          "put points between the two, or use smaller values");
    }
  }
}

// A code of the source string; below a blank LDmicro 2.3 has an X.
std::int32_t code_of(LdElement& element) {
  constexpr std::int32_t kBlank = 32;
  const LdWord& word = element.peek();
  const std::int64_t code = element.whole_number();
  if (element.good() && code > UINT8_MAX) {
    element.refuse(word.position, fmt::format("{} is no code of a character", shown(word.text)),
                   "codes are 32 to 255; for others write the escape \\xAB: 92 120 and two digits");
  }
  if (code >= kBlank || !element.good()) return static_cast<std::int32_t>(code);
  element.context().warn(word.position,
                         fmt::format("the code {} is read as an X, as LDmicro 2.3 does", code),
                         "use an escape: 92 120 and the codes of two hexadecimal digits");
  return 'X';
}

void read_codes(LdElement& element, Instruction& instruction) {
  const std::size_t count = row_count(element, "codes", 1);
  for (std::size_t i = 0; i < count && element.good(); ++i) {
    instruction.table.push_back(code_of(element));
  }
  // Ignored by LDmicro 2.3; that the string ends early is easily overlooked.
  if (element.good() && !element.at_end()) {
    element.refuse(element.peek().position,
                   fmt::format("FORMATTED_STRING: {} codes are announced, and {} more follow",
                               count, element.left()),
                   "write the number of codes that there are");
  }
}

// 0.2: the string as a word, in which \x20 is a blank.
void read_text(LdElement& element, Instruction& instruction) {
  const LdWord& word = element.word();
  for (auto at = word.text.begin(); at != word.text.end();) {
    const char32_t c = utf8::unchecked::next(at);
    if (c > UINT8_MAX) {
      return element.refuse(word.position, "FORMATTED_STRING: a character of more than 8 bits",
                            "write the bytes to send as escapes \\xAB");
    }
    instruction.table.push_back(static_cast<std::int32_t>(c));
  }
  if (!element.at_end()) {
    element.refuse(element.peek().position,
                   "FORMATTED_STRING: this follows the string, in which blanks stand as \\x20");
  }
}

}  // namespace

void read_shift_register(LdElement& element, Instruction& instruction) {
  const LdWord& name = element.word();
  const LdWord& word = element.peek();
  const std::int64_t stages = element.whole_number();
  if (!element.good()) return;
  if (!is_ld_name(name.text + "0")) {
    return element.refuse(name.position, fmt::format("{} is no name", shown(name.text)),
                          "names are of letters, digits and _, and do not begin with a digit");
  }
  if (stages < 1 || stages > kMaxStages) {
    return element.refuse(word.position, fmt::format("SHIFT_REGISTER of {} stages", stages),
                          fmt::format("it has 1 to {}", kMaxStages));
  }
  for (std::int64_t i = 0; i < stages; ++i) {
    Operand stage;
    stage.device = element.context().symbols.variable(fmt::format("{}{}", name.text, i));
    instruction.operands.push_back(stage);
  }
}

void read_look_up_table(LdElement& element, Instruction& instruction) {
  read_target(element, instruction);
  const std::size_t count = row_count(element, "values", 1, 1);  // a mark stands behind it
  Operand as_string;
  as_string.kind = Operand::Kind::Number;
  as_string.value = element.flag();
  instruction.operands.push_back(as_string);
  for (std::size_t i = 0; i < count && element.good(); ++i) {
    instruction.table.push_back(element.number16("a value of the table"));
  }
}

void read_piecewise_linear(LdElement& element, Instruction& instruction) {
  read_target(element, instruction);
  const SourcePosition position = element.peek().position;
  const std::size_t count = row_count(element, "points", 2);
  for (std::size_t i = 0; i < 2 * count && element.good(); ++i) {
    instruction.table.push_back(element.number16("a coordinate of the table"));
  }
  if (element.good()) check_points(element, instruction.table, position);
}

void read_formatted_string(LdElement& element, Instruction& instruction) {
  if (element.peek().text == "(none)") {
    element.word();
  } else {
    instruction.operands = {element.variable()};
  }
  if (!element.good()) return;
  const bool is_text = element.context().header.extended && !element.at_end() &&
                       leading_number(element.peek().text).length == 0;
  const SourcePosition position =
      element.at_end() ? element.line().position() : element.peek().position;
  if (is_text) {
    read_text(element, instruction);
  } else if (!element.at_end()) {
    read_codes(element, instruction);
  } else if (!element.context().header.extended) {
    element.refuse(position, "FORMATTED_STRING: the number of its codes is missing",
                   "write: FORMATTED_STRING variable count code ...");
  }
  if (!element.good()) return;
  if (const auto fault = string_fault(instruction.table)) {
    return element.refuse(position, "FORMATTED_STRING: " + fault->what, fault->mend);
  }
  const bool shows = shows_variable(instruction.table);
  if (shows && instruction.operands.empty()) {
    element.refuse(position, "FORMATTED_STRING: the string shows digits, but of no variable",
                   "name the variable instead of (none)");
  } else if (!shows && !instruction.operands.empty()) {
    element.refuse(position, "FORMATTED_STRING: the string does not show its variable",
                   "write \\N where its N digits belong, or (none) instead of the variable");
  }
}

}  // namespace rung
