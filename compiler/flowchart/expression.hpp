// SPDX-License-Identifier: Apache-2.0
// Conditions and expressions: one grammar, in which each part is a bit or a word.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "flowchart/names.hpp"
#include "flowchart/tokens.hpp"
#include "rungs/program.hpp"

namespace rung::flowchart {

struct Expression {
  enum class Kind {
    // bits
    Bit,      // `operand`
    Fixed,    // on, off: `value`
    Failed,   // the step's transfer
    Running,  // task `task`
    Not,      // a
    All,      // a and b
    Any,      // a or b
    Compare,  // a `relation` b, words
    // words
    Word,      // `operand`
    Constant,  // `value`, -32768 to 32767
    Add,       // a, b
    Sub,
    Mul,
    Div,
    Mod,
    And,
    Or,
    Xor,
  };
  Kind kind = Kind::Fixed;
  Token token;  // the operator, or the first word
  Operand operand;
  int value = 0;
  std::size_t task = 0;
  Relation relation = Relation::Equal;
  std::unique_ptr<Expression> a, b;

  bool is_word() const { return kind >= Kind::Word; }
};
using ExpressionPointer = std::unique_ptr<Expression>;

// What an expression may speak of, and what it did.
struct Scope {
  Dialect dialect = Dialect::Fx;
  const Names& tasks;
  std::string no_failed;        // why `failed` cannot stand here; empty if it can
  std::string no_failed_mend;   // and what to do instead
  bool failed = false;          // it was asked
  std::set<std::size_t> asked;  // tasks of which `running` was asked
};

inline constexpr int kMostOperands = 100;
inline constexpr int kMostNested = 50;

// Reads a condition or an expression as far as it goes. Throws a Refusal.
ExpressionPointer read_condition(Cursor& cursor, Scope& scope);
ExpressionPointer read_words(Cursor& cursor, Scope& scope);

}  // namespace rung::flowchart
