// SPDX-License-Identifier: Apache-2.0
// Contacts, blocks and branches.
#include "reference/reference.hpp"

namespace rung {

void Reference::execute_contact(const Instruction& instruction) {
  const bool value = contact(instruction);
  closed_ = value;
  switch (instruction.op) {
    case Op::And:
    case Op::Ani:
    case Op::AndP:
    case Op::AndF:
    case Op::AndCompare:
      now_.result = now_.result && value;
      return;
    case Op::Or:
    case Op::Ori:
    case Op::OrP:
    case Op::OrF:
    case Op::OrCompare:
      now_.result = now_.result || value;
      return;
    default:
      // At the start of a network this keeps a result that no ANB or ORB will ask for.
      now_.blocks.push_back(now_.result);
      now_.result = value;
  }
}

// Evaluated whatever the result is: edges have their memory to keep, wrong indexes their error.
bool Reference::contact(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::LdCompare:
    case Op::AndCompare:
    case Op::OrCompare:
      return compare(instruction);
    default:
      break;
  }
  const std::optional<Operand> located = locate(instruction.operand(0), 1);
  if (!located) fail();
  const bool bit = located && read_bit(*located);
  switch (instruction.op) {
    case Op::Ldi:
    case Op::Ani:
    case Op::Ori:
      return !bit;
    case Op::LdP:
    case Op::AndP:
    case Op::OrP:
      return !exchange_memory(bit) && bit;
    case Op::LdF:
    case Op::AndF:
    case Op::OrF:
      return exchange_memory(bit) && !bit;
    default:
      return bit;
  }
}

bool Reference::compare(const Instruction& instruction) {
  const auto value = [&](std::size_t i) {
    const std::optional<Operand> located = locate(instruction.operand(i), instruction.width / 16);
    if (!located) fail();
    return located ? read_word(*located, instruction.width) : 0;
  };
  const std::int32_t a = value(0);
  const std::int32_t b = value(1);
  switch (instruction.relation) {
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
      return a >= b;
  }
  return false;
}

void Reference::execute_block(Op op) {
  switch (op) {
    case Op::Anb: {
      const bool block = pop_block();
      now_.result = now_.result && block;
      return;
    }
    case Op::Orb: {
      const bool block = pop_block();
      now_.result = now_.result || block;
      return;
    }
    case Op::Inv:
      now_.result = !now_.result;
      return;
    case Op::Mep: {
      const bool on = condition();
      now_.result = !exchange_memory(on) && on;
      return;
    }
    case Op::Mef: {
      const bool on = condition();
      now_.result = exchange_memory(on) && !on;
      return;
    }
    case Op::Mps:
      now_.branches.push_back(now_.result);
      return;
    case Op::Mrd:
      now_.result = now_.branches.back();
      return;
    case Op::Mpp:
      now_.result = now_.branches.back();
      now_.branches.pop_back();
      return;
    default:
      return;
  }
}

bool Reference::pop_block() {
  const bool block = now_.blocks.back();
  now_.blocks.pop_back();
  return block;
}

}  // namespace rung
