// SPDX-License-Identifier: Apache-2.0
#include "lower/contacts.hpp"

#include "lower/compare.hpp"
#include "lower/condition.hpp"
#include "lower/operands.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;

void plain(Context& context, Core op) {
  const Device bit = contact_bit(context, context.source().operand(0));
  context.contact(op, bit);
}

// LDP and its kin: the contact is v AND NOT memory, or NOT v AND memory; then memory <- v.
void edge(Context& context, bool rising, std::optional<Core> joined_by) {
  const Device bit = contact_bit(context, context.source().operand(0));
  const Device memory = context.memory();
  // In series the two contacts simply follow; in parallel they are a block of their own.
  const bool series = joined_by == Core::Anb;
  context.contact(rising ? (series ? Core::And : Core::Ld) : (series ? Core::Ani : Core::Ldi), bit);
  context.contact(rising ? Core::Ani : Core::And, memory);
  if (joined_by == Core::Orb) context.block(Core::Orb);
  context.contact(Core::Ld, bit);
  remember(context, memory);
  context.block(Core::Pop);
}

// x = result AND power; result <- x AND NOT memory, or NOT x AND memory; memory <- x.
void result_edge(Context& context, bool rising) {
  const Device memory = context.memory();
  const Device pulse = context.temporary_bit();
  context.gate();
  context.block(Core::Mps);
  if (!rising) context.block(Core::Inv);
  context.contact(rising ? Core::Ani : Core::And, memory);
  context.coil(Core::Out, pulse);
  context.block(Core::Mpp);
  remember(context, memory);
  // A pulse can only be where x is, or where it is not: one more contact makes it the result.
  if (!rising) context.block(Core::Inv);
  context.contact(Core::And, pulse);
}

void compare(Context& context, Core plain, Core inverted) {
  const Test test = compare_contact(context);
  context.contact(test.inverted ? inverted : plain, test.bit);
}

}  // namespace

bool lower_contact(Context& context) {
  switch (context.source().op) {
    case Op::Ld:
      plain(context, Core::Ld);
      return true;
    case Op::Ldi:
      plain(context, Core::Ldi);
      return true;
    case Op::And:
      plain(context, Core::And);
      return true;
    case Op::Ani:
      plain(context, Core::Ani);
      return true;
    case Op::Or:
      plain(context, Core::Or);
      return true;
    case Op::Ori:
      plain(context, Core::Ori);
      return true;
    case Op::LdP:
      edge(context, true, std::nullopt);
      return true;
    case Op::LdF:
      edge(context, false, std::nullopt);
      return true;
    case Op::AndP:
      edge(context, true, Core::Anb);
      return true;
    case Op::AndF:
      edge(context, false, Core::Anb);
      return true;
    case Op::OrP:
      edge(context, true, Core::Orb);
      return true;
    case Op::OrF:
      edge(context, false, Core::Orb);
      return true;
    case Op::LdCompare:
      compare(context, Core::Ld, Core::Ldi);
      return true;
    case Op::AndCompare:
      compare(context, Core::And, Core::Ani);
      return true;
    case Op::OrCompare:
      compare(context, Core::Or, Core::Ori);
      return true;
    case Op::Anb:
      context.block(Core::Anb);
      return true;
    case Op::Orb:
      context.block(Core::Orb);
      return true;
    case Op::Inv:
      context.block(Core::Inv);
      return true;
    case Op::Mep:
      result_edge(context, true);
      return true;
    case Op::Mef:
      result_edge(context, false);
      return true;
    case Op::Mps:
      context.block(Core::Mps);
      return true;
    case Op::Mrd:
      context.block(Core::Mrd);
      return true;
    case Op::Mpp:
      context.block(Core::Mpp);
      return true;
    default:
      return false;
  }
}

}  // namespace rung::lower
