// SPDX-License-Identifier: Apache-2.0
#include "melsec/statements.hpp"

#include <fmt/format.h>
#include <utf8.h>

#include <algorithm>
#include <utility>

#include "melsec/operands.hpp"

namespace rung {
namespace {

bool is_number(const ListWord& word) {
  return std::all_of(word.upper.begin(), word.upper.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

bool is_instruction(const ListWord& word) {
  return word.upper == "END" || !find_instruction(word.upper).empty() ||
         is_unsupported_name(word.upper);
}

// No known instruction has more operands; of another one all that follows may be its operands.
constexpr int kMostOperands = 4;
constexpr int kMany = 99;

class Grouping {
 public:
  Grouping(const std::string& file, Diagnostics& diagnostics)
      : file_(file), diagnostics_(diagnostics) {}

  void line(const ListLine& words) {
    std::size_t i = 0;
    while (i < words.size() && !ended_twice_) {
      const ListWord& word = words[i];
      if (is_separator(words, i)) {
        ++i;
      } else if (is_number(word)) {
        ++i;
        if (i == words.size() || is_separator(words, i) || is_number(words[i])) {
          diagnostics_.error(file_, word.position,
                             fmt::format("no instruction follows the step number {}", word.text),
                             "write the instruction after its number, on the same line");
        }
      } else {
        i = statement(words, i);
      }
    }
    if (!list_.has_end) {
      const ListWord& last = words.back();
      list_.end = last.position;
      list_.end.column +=
          static_cast<int>(utf8::unchecked::distance(last.text.begin(), last.text.end()));
    }
  }

  StatementList take() { return std::move(list_); }

 private:
  // A slash separates instructions unless an operand follows it: then it is Q's division.
  static bool is_separator(const ListLine& words, std::size_t i) {
    if (words[i].upper != "/") return false;
    return i + 1 == words.size() || is_instruction(words[i + 1]) ||
           !looks_like_operand(words[i + 1].upper);
  }

  // Takes the instruction at words[i] with its operands; gives the index after them.
  std::size_t statement(const ListLine& words, std::size_t i) {
    Statement statement;
    statement.name = words[i++];
    const std::string& name = statement.name.upper;
    if (list_.has_end) {
      diagnostics_.error(file_, statement.name.position,
                         fmt::format("{} stands after END, where nothing is executed", name),
                         "remove what follows END, or END itself");
      ended_twice_ = true;
      return i;
    }
    if (name == "END") {
      list_.has_end = true;
      list_.end = statement.name.position;
      return i;
    }
    statement.forms = find_instruction(name);
    if (statement.forms.empty()) statement.unsupported = unsupported_instruction(name);
    const OperandCount count = !statement.forms.empty() ? operand_count(statement.forms)
                               : is_label(name)         ? OperandCount{0, 0}
                                                        : OperandCount{0, kMany};
    while (i < words.size() && !begins_instruction(words, i, statement.operands.size(), count)) {
      statement.operands.push_back(words[i++]);
    }
    list_.statements.push_back(std::move(statement));
    return i;
  }

  // Whether words[i], after `given` operands, belongs to the next instruction.
  static bool begins_instruction(const ListLine& words, std::size_t i, std::size_t given,
                                 OperandCount count) {
    const ListWord& word = words[i];
    if (word.upper == "/" || is_instruction(word)) return true;
    const bool complete = given >= static_cast<std::size_t>(count.most);
    const bool enough = given >= static_cast<std::size_t>(count.least);
    if (is_number(word)) {
      return complete || (enough && i + 1 < words.size() &&
                          (is_instruction(words[i + 1]) || is_label(words[i + 1].upper)));
    }
    // No instruction takes a pointer as the operand that it can do without.
    if (enough && count.most <= kMostOperands && is_label(word.upper)) return true;
    // A surplus operand is the fault of this instruction, any other word that of the next.
    return complete && !looks_like_operand(word.upper);
  }

  const std::string& file_;
  Diagnostics& diagnostics_;
  StatementList list_;
  bool ended_twice_ = false;
};

}  // namespace

StatementList group_words(const std::vector<ListLine>& lines, const std::string& file,
                          Diagnostics& diagnostics) {
  Grouping grouping(file, diagnostics);
  for (const ListLine& line : lines) grouping.line(line);
  return grouping.take();
}

}  // namespace rung
