// SPDX-License-Identifier: Apache-2.0
#include "flowchart/expression.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "flowchart/operand.hpp"

namespace rung::flowchart {
namespace {

using Kind = Expression::Kind;

std::optional<Relation> relation_of(const Token& token) {
  if (token.kind != Token::Kind::Symbol) return std::nullopt;
  if (token.text == "=" || token.text == "==") return Relation::Equal;
  if (token.text == "<>" || token.text == "!=") return Relation::NotEqual;
  if (token.text == "<") return Relation::Less;
  if (token.text == ">") return Relation::Greater;
  if (token.text == "<=") return Relation::LessEqual;
  if (token.text == ">=") return Relation::GreaterEqual;
  return std::nullopt;
}

// A decimal or 0x number of 16 bits.
int constant(const Token& token, bool negative) {
  const std::optional<int> value = number_of(token.text);
  if (!value) {
    throw Refusal{token.position, fmt::format("{}: not a number", shown(token)),
                  "numbers are 300 or 0x1F; what follows needs a blank before it"};
  }
  const bool hex = token.text.size() > 1 && (token.text[1] == 'x' || token.text[1] == 'X');
  const int most = hex && !negative ? 0xFFFF : negative ? 32768 : 32767;
  if (*value > most) {
    throw Refusal{token.position, fmt::format("{}: more than 16 bits hold", shown(token)),
                  "constants are -32768 to 32767, or 0x0 to 0xFFFF"};
  }
  return static_cast<std::int16_t>(negative ? -*value : *value);
}

class Parser {
 public:
  Parser(Cursor& cursor, Scope& scope) : cursor_(cursor), scope_(scope) {}

  ExpressionPointer any() {
    const Nesting nesting(*this);
    ExpressionPointer left = exclusive();
    while (cursor_.peek().is("or")) left = logical(std::move(left), Kind::Any, Kind::Or);
    return left;
  }

 private:
  // Counts what is open, so that no text exhausts the stack.
  class Nesting {
   public:
    explicit Nesting(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ <= kMostNested) return;
      throw Refusal{
          parser_.cursor_.peek().position,
          fmt::format("more than {} parentheses and signs inside of each other", kMostNested),
          "compute a part of it before, into a relay or register"};
    }
    ~Nesting() { --parser_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    Parser& parser_;
  };

  ExpressionPointer exclusive() {
    ExpressionPointer left = all();
    while (cursor_.peek().is("xor")) {
      const Token& token = cursor_.take();
      ExpressionPointer right = all();
      if (!left->is_word() || !right->is_word()) {
        throw Refusal{token.position, "xor combines words, not conditions",
                      "of conditions write (A and not B) or (B and not A)"};
      }
      left = node(Kind::Xor, token, std::move(left), std::move(right));
    }
    return left;
  }

  ExpressionPointer all() {
    ExpressionPointer left = inverse();
    while (cursor_.peek().is("and")) left = logical(std::move(left), Kind::All, Kind::And);
    return left;
  }

  // `and`, `or`: of two conditions, or of two words bit by bit.
  ExpressionPointer logical(ExpressionPointer left, Kind of_bits, Kind of_words) {
    const Token& token = cursor_.take();
    ExpressionPointer right = of_bits == Kind::All ? inverse() : exclusive();
    if (left->is_word() != right->is_word()) {
      throw Refusal{token.position,
                    fmt::format("{} between {} and {}", token.text, what(*left), what(*right)),
                    fmt::format("it takes two conditions or two words; comparisons bind before it: "
                                "write (D0 {} 15) > 3",
                                token.text)};
    }
    const Kind kind = left->is_word() ? of_words : of_bits;
    return node(kind, token, std::move(left), std::move(right));
  }

  ExpressionPointer inverse() {
    if (!cursor_.peek().is("not")) return comparison();
    const Nesting nesting(*this);
    const Token& token = cursor_.take();
    ExpressionPointer inner = inverse();
    if (inner->is_word()) {
      throw Refusal{token.position, "not inverts a condition, not a word",
                    "of a word write D0 xor 0xFFFF"};
    }
    return node(Kind::Not, token, std::move(inner), nullptr);
  }

  ExpressionPointer comparison() {
    ExpressionPointer left = sum();
    while (const auto relation = relation_of(cursor_.peek())) {
      const Token& token = cursor_.take();
      ExpressionPointer right = sum();
      if (!left->is_word() || !right->is_word()) {
        throw Refusal{token.position,
                      fmt::format("{} compares words, but there is {}", token.text,
                                  what(left->is_word() ? *right : *left)),
                      left->kind == Kind::Compare
                          ? "join two comparisons with `and`: 0 < D0 and D0 < 9"
                          : "a bit is asked by its name alone: X0, not X0"};
      }
      left = node(Kind::Compare, token, std::move(left), std::move(right));
      left->relation = *relation;
    }
    return left;
  }

  ExpressionPointer sum() {
    ExpressionPointer left = product();
    while (true) {
      const std::string& text = cursor_.peek().text;
      if (!cursor_.peek().is("+") && !cursor_.peek().is("-")) return left;
      left = arithmetic(std::move(left), text == "+" ? Kind::Add : Kind::Sub);
    }
  }

  ExpressionPointer product() {
    ExpressionPointer left = sign();
    while (true) {
      if (cursor_.peek().is("*")) {
        left = arithmetic(std::move(left), Kind::Mul);
      } else if (cursor_.peek().is("/")) {
        left = arithmetic(std::move(left), Kind::Div);
      } else if (cursor_.peek().is("%")) {
        left = arithmetic(std::move(left), Kind::Mod);
      } else {
        return left;
      }
    }
  }

  ExpressionPointer arithmetic(ExpressionPointer left, Kind kind) {
    const Token& token = cursor_.take();
    ExpressionPointer right = kind == Kind::Add || kind == Kind::Sub ? product() : sign();
    need_words(token, *left);
    need_words(token, *right);
    if ((kind == Kind::Div || kind == Kind::Mod) && right->kind == Kind::Constant &&
        right->value == 0) {
      throw Refusal{right->token.position, "a division by 0", "divide by something else"};
    }
    return node(kind, token, std::move(left), std::move(right));
  }

  ExpressionPointer sign() {
    if (!cursor_.peek().is("-")) return primary();
    const Nesting nesting(*this);
    const Token& token = cursor_.take();
    if (cursor_.peek().kind == Token::Kind::Number) {
      count();
      ExpressionPointer number = node(Kind::Constant, token, nullptr, nullptr);
      number->value = constant(cursor_.take(), true);
      return number;
    }
    ExpressionPointer zero = node(Kind::Constant, token, nullptr, nullptr);
    ExpressionPointer inner = sign();
    need_words(token, *inner);
    return node(Kind::Sub, token, std::move(zero), std::move(inner));
  }

  ExpressionPointer primary() {
    const Token& token = cursor_.peek();
    if (cursor_.accept("(")) {
      ExpressionPointer inner = any();
      if (!cursor_.accept(")")) {
        throw Refusal{cursor_.peek().position,
                      fmt::format("{} where `)` has to stand", shown(cursor_.peek())),
                      fmt::format("the ( in column {} is still open", token.position.column)};
      }
      return inner;
    }
    count();
    if (token.kind == Token::Kind::Number) {
      ExpressionPointer number = node(Kind::Constant, cursor_.take(), nullptr, nullptr);
      number->value = constant(token, false);
      return number;
    }
    if (token.kind != Token::Kind::Word) {
      throw Refusal{token.position,
                    fmt::format("{} where a device or a number has to stand", shown(token)),
                    token.kind == Token::Kind::End ? "something is missing here"
                                                   : "compiler/FLOW.md shows conditions and "
                                                     "expressions"};
    }
    cursor_.take();
    if (token.text == "on" || token.text == "off") {
      ExpressionPointer fixed = node(Kind::Fixed, token, nullptr, nullptr);
      fixed->value = token.text == "on" ? 1 : 0;
      return fixed;
    }
    if (token.text == "running") {
      ExpressionPointer running = node(Kind::Running, token, nullptr, nullptr);
      running->task = scope_.tasks.find(cursor_.name("a task", "running TASK"));
      scope_.asked.insert(running->task);
      return running;
    }
    if (token.text == "failed") {
      if (!scope_.no_failed.empty()) {
        throw Refusal{token.position, scope_.no_failed, scope_.no_failed_mend};
      }
      scope_.failed = true;
      return node(Kind::Failed, token, nullptr, nullptr);
    }
    if (is_keyword(token.text)) {
      throw Refusal{token.position,
                    fmt::format("{} where a device or a number has to stand", token.text),
                    "something is missing before it"};
    }
    ExpressionPointer device = node(Kind::Bit, token, nullptr, nullptr);
    device->operand = read_operand(token, scope_.dialect);
    if (!is_bit(device->operand)) device->kind = Kind::Word;
    return device;
  }

  void count() {
    if (++operands_ <= kMostOperands) return;
    throw Refusal{cursor_.peek().position,
                  fmt::format("more than {} devices and numbers in one expression", kMostOperands),
                  "compute a part of it before, into a relay or register"};
  }

  static std::string what(const Expression& expression) {
    if (expression.kind == Kind::Bit) return fmt::format("{}, a bit", shown(expression.token));
    if (expression.kind == Kind::Word) return fmt::format("{}, a word", shown(expression.token));
    if (expression.kind == Kind::Constant) return "a number";
    return expression.is_word() ? "a word" : "a condition";
  }

  static void need_words(const Token& token, const Expression& side) {
    if (side.is_word()) return;
    throw Refusal{token.position,
                  fmt::format("{} calculates with words, but there is {}", token.text, what(side)),
                  "conditions are joined with and, or, not"};
  }

  static ExpressionPointer node(Kind kind, const Token& token, ExpressionPointer a,
                                ExpressionPointer b) {
    auto made = std::make_unique<Expression>();
    made->kind = kind;
    made->token = token;
    made->a = std::move(a);
    made->b = std::move(b);
    return made;
  }

  Cursor& cursor_;
  Scope& scope_;
  int depth_ = 0;
  int operands_ = 0;
};

}  // namespace

ExpressionPointer read_condition(Cursor& cursor, Scope& scope) {
  const Token& token = cursor.peek();
  ExpressionPointer condition = Parser(cursor, scope).any();
  if (!condition->is_word()) return condition;
  throw Refusal{token.position, "a word where a condition has to stand",
                "compare it (D0 > 5), or ask for one of its bits (D0.3)"};
}

ExpressionPointer read_words(Cursor& cursor, Scope& scope) {
  const Token& token = cursor.peek();
  ExpressionPointer words = Parser(cursor, scope).any();
  if (words->is_word()) return words;
  throw Refusal{token.position, "a condition where a word has to stand",
                "a word takes numbers and words; a bit (M0) takes conditions"};
}

}  // namespace rung::flowchart
