// SPDX-License-Identifier: Apache-2.0
// Operands of the source as core operands: digit groups are gathered, indexed devices fetched, and
// results put where they belong.
#pragma once

#include "lower/context.hpp"

namespace rung::lower {

// Values as the instruction finds them. `valid` gets a bit for each index that has to be in its
// window for the instruction to be executed.
WordSource read16(Context& context, const Operand& operand, std::vector<Device>& valid);
Pair read32(Context& context, const Operand& operand, std::vector<Device>& valid);

// Where a result goes. Made before the condition, because finding an indexed place takes core
// instructions of its own.
struct Place {
  Operand operand;
  std::optional<Device> offset;  // indexed: the word that holds its number in the window
};
Place place(Context& context, const Operand& operand, int words, std::vector<Device>& valid);

// The words that can be written directly, without store(): `count` of them, or none.
std::vector<Device> direct_words(const Context& context, const Place& place, int count);

// Writes words under the current result, the lowest first; a digit group takes what it has room
// for.
void store(Context& context, const Place& place, const std::vector<WordSource>& words,
           bool quiet = false);

// The bit that a contact reads: the device itself, or a temporary with a bit of a word or an
// indexed bit, 0 outside its window.
Device contact_bit(Context& context, const Operand& operand);

// The number of an indexed device within its window, and a bit that says it is inside, `words`
// following each other included.
struct Offset {
  Device number;
  Device inside;
};
Offset index_offset(Context& context, const Operand& operand, int words);

}  // namespace rung::lower
