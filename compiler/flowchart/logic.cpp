// SPDX-License-Identifier: Apache-2.0
#include "flowchart/logic.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rung::flowchart {
namespace {

using Kind = Logic::Kind;

enum class Joined { Begins, InSeries, InParallel };

bool holds(int a, Relation relation, int b) {
  switch (relation) {
    case Relation::Equal:
      return a == b;
    case Relation::NotEqual:
      return a != b;
    case Relation::Less:
      return a < b;
    case Relation::Greater:
      return a > b;
    case Relation::LessEqual:
      return a <= b;
    case Relation::GreaterEqual:
      break;
  }
  return a >= b;
}

Relation opposite(Relation relation) {
  switch (relation) {
    case Relation::Equal:
      return Relation::NotEqual;
    case Relation::NotEqual:
      return Relation::Equal;
    case Relation::Less:
      return Relation::GreaterEqual;
    case Relation::Greater:
      return Relation::LessEqual;
    case Relation::LessEqual:
      return Relation::Greater;
    case Relation::GreaterEqual:
      break;
  }
  return Relation::Less;
}

Logic join(Kind kind, Logic a, Logic b) {
  // What decides alone, and what does not matter: of All off and on.
  const bool decides = kind == Kind::Any;
  for (Logic* side : {&a, &b}) {
    Logic& other = side == &a ? b : a;
    if (side->is_fixed(decides)) return std::move(*side);
    if (side->is_fixed(!decides)) return std::move(other);
  }
  Logic joined;
  joined.kind = kind;
  joined.position = a.position;
  for (Logic* side : {&a, &b}) {
    if (side->kind == kind) {
      std::move(side->parts.begin(), side->parts.end(), std::back_inserter(joined.parts));
    } else {
      joined.parts.push_back(std::move(*side));
    }
  }
  return joined;
}

bool is_leaf(const Logic& logic) {
  return logic.kind == Kind::Contact || logic.kind == Kind::Compare;
}

// How many blocks are open at once.
int blocks(const Logic& logic) {
  if (is_leaf(logic)) return 1;
  // The deepest part comes first; of the others those that are no leaf stand on what is there.
  std::vector<int> parts;
  for (const Logic& part : logic.parts) {
    if (!is_leaf(part)) parts.push_back(blocks(part));
  }
  std::sort(parts.rbegin(), parts.rend());
  int most = 1;
  for (std::size_t i = 0; i < parts.size(); ++i) most = std::max(most, parts[i] + (i > 0 ? 1 : 0));
  return most;
}

Op contact_op(const Logic& leaf, Joined joined) {
  if (leaf.kind == Kind::Compare) {
    return joined == Joined::Begins     ? Op::LdCompare
           : joined == Joined::InSeries ? Op::AndCompare
                                        : Op::OrCompare;
  }
  switch (joined) {
    case Joined::Begins:
      return leaf.inverted ? Op::Ldi : Op::Ld;
    case Joined::InSeries:
      return leaf.inverted ? Op::Ani : Op::And;
    case Joined::InParallel:
      break;
  }
  return leaf.inverted ? Op::Ori : Op::Or;
}

void write_leaf(const Logic& leaf, Joined joined, std::vector<Instruction>& out) {
  Instruction instruction;
  instruction.op = contact_op(leaf, joined);
  instruction.operands.push_back(leaf.a);
  if (leaf.kind == Kind::Compare) {
    instruction.operands.push_back(leaf.b);
    instruction.relation = leaf.relation;
  }
  instruction.position = leaf.position;
  out.push_back(std::move(instruction));
}

}  // namespace

Logic fixed(bool value) {
  Logic logic;
  logic.value = value;
  return logic;
}

Logic contact(const Operand& bit, bool inverted, SourcePosition position) {
  Logic logic;
  logic.kind = Kind::Contact;
  logic.a = bit;
  logic.inverted = inverted;
  logic.position = position;
  return logic;
}

Logic compare(const Operand& a, Relation relation, const Operand& b, SourcePosition position) {
  if (a.kind == Operand::Kind::Constant && b.kind == Operand::Kind::Constant) {
    return fixed(holds(a.value, relation, b.value));
  }
  Logic logic;
  logic.kind = Kind::Compare;
  logic.a = a;
  logic.b = b;
  logic.relation = relation;
  logic.position = position;
  return logic;
}

Logic all(Logic a, Logic b) { return join(Kind::All, std::move(a), std::move(b)); }
Logic any(Logic a, Logic b) { return join(Kind::Any, std::move(a), std::move(b)); }

Logic inverse(Logic logic) {
  switch (logic.kind) {
    case Kind::Fixed:
      logic.value = !logic.value;
      return logic;
    case Kind::Contact:
      logic.inverted = !logic.inverted;
      return logic;
    case Kind::Compare:
      logic.relation = opposite(logic.relation);
      return logic;
    case Kind::All:
    case Kind::Any:
      break;
  }
  logic.kind = logic.kind == Kind::All ? Kind::Any : Kind::All;
  for (Logic& part : logic.parts) part = inverse(std::move(part));
  return logic;
}

void write_contacts(const Logic& logic, std::vector<Instruction>& out) {
  if (is_leaf(logic)) return write_leaf(logic, Joined::Begins, out);
  std::vector<const Logic*> parts;
  for (const Logic& part : logic.parts) parts.push_back(&part);
  const auto weight = [](const Logic* part) { return is_leaf(*part) ? 0 : blocks(*part); };
  std::stable_sort(parts.begin(), parts.end(), [&](const Logic* left, const Logic* right) {
    return weight(left) > weight(right);
  });
  const bool series = logic.kind == Kind::All;
  write_contacts(*parts.front(), out);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (is_leaf(*parts[i])) {
      write_leaf(*parts[i], series ? Joined::InSeries : Joined::InParallel, out);
      continue;
    }
    write_contacts(*parts[i], out);
    Instruction block;
    block.op = series ? Op::Anb : Op::Orb;
    block.position = parts[i]->position;
    out.push_back(std::move(block));
  }
}

Operand device_operand(Device device) {
  Operand operand;
  operand.device = device;
  return operand;
}

Operand constant_operand(int value) {
  Operand operand;
  operand.kind = Operand::Kind::Constant;
  operand.value = value;
  return operand;
}

}  // namespace rung::flowchart
