// SPDX-License-Identifier: Apache-2.0
// A condition without inversions: contacts and compares in series and in parallel, as a rung has
// them.
#pragma once

#include <vector>

#include "flowchart/tokens.hpp"
#include "rungs/program.hpp"

namespace rung::flowchart {

struct Logic {
  enum class Kind {
    Fixed,    // `value`
    Contact,  // bit a, `inverted`
    Compare,  // a `relation` b
    All,      // of `parts`, two or more, none of them Fixed or All
    Any,      // the same, none of them Fixed or Any
  };
  Kind kind = Kind::Fixed;
  bool value = true;
  bool inverted = false;
  Relation relation = Relation::Equal;
  Operand a, b;
  std::vector<Logic> parts;
  SourcePosition position;

  bool is_fixed(bool what) const { return kind == Kind::Fixed && value == what; }
};

Logic fixed(bool value);
Logic contact(const Operand& bit, bool inverted, SourcePosition position);
// Of two constants it is worked out.
Logic compare(const Operand& a, Relation relation, const Operand& b, SourcePosition position);
Logic all(Logic a, Logic b);
Logic any(Logic a, Logic b);
Logic inverse(Logic logic);

// Appends the contacts of `logic`, which is not Fixed: one block, built so that as few as possible
// are open at once.
void write_contacts(const Logic& logic, std::vector<Instruction>& out);

Operand device_operand(Device device);
Operand constant_operand(int value);

}  // namespace rung::flowchart
