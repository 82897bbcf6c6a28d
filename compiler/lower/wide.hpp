// SPDX-License-Identifier: Apache-2.0
// Operations on values of one or two words.
#pragma once

#include "lower/condition.hpp"
#include "lower/operands.hpp"

namespace rung::lower {

// A value as its words, lowest first.
using Words = std::vector<WordSource>;

// The operand as words of the current instruction's width.
Words read(Context& context, const Operand& operand, std::vector<Device>& valid);

// The value with each constant in a word of its own: a core operation takes one constant at most.
Words in_words(Context& context, const Words& value);

// A hidden word <- a op b, whatever the result; two constants are worked out here.
WordSource combine(Context& context, core::Op op, const WordSource& a, const WordSource& b);
// The same word by word, for Wand, Wor and Wxor.
Words combine(Context& context, core::Op op, const Words& a, const Words& b);

// Executes `result` into the operand under the current instruction's condition.
void write_result(Context& context, const Operand& target, const Words& result,
                  Requirements requirements);

// True if the words of `sources` from the second on include the first target: written word by word
// it would be read too late.
bool overwrites(Device first_target, const Words& sources);

}  // namespace rung::lower
