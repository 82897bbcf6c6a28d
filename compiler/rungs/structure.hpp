// SPDX-License-Identifier: Apache-2.0
// The shape of a program: networks, and whether blocks and branches are balanced in each.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rungs/program.hpp"

namespace rung {

// What an instruction does to the two stacks of the boolean machine. A block is what an LD opens;
// the newest one is the current result. A branch is a result that MPS keeps.
enum class Effect : std::uint8_t {
  Load,     // opens a block
  Combine,  // changes the current result: needs one
  Join,     // ANB, ORB: makes one block of two
  Push,     // MPS
  Read,     // MRD
  Pop,      // MPP
  Output,   // uses the current result and keeps it
  State,    // STL: ends a network and begins one, with a result for outputs
  Between,  // stands between networks: labels, MCR, FOR, ...
  None,     // NOP, and what takes no part
  Unknown,  // a word that is no instruction: nothing can be said until the next network
};

Effect effect_of(Op op);

// One instruction as far as the checks need it; an instruction that was refused for another reason
// takes part too, so that one run reports everything.
struct StructureItem {
  Effect effect = Effect::None;
  std::string name;  // as the source wrote it
  SourcePosition position;
};

// How many blocks (LD) and branches (MPS) may be open at once.
struct StackLimits {
  int blocks;
  int branches;
};
// FX 8 and 11, QnU 16 and 16 (the makers' programming manuals); paper as fx.
StackLimits stack_limits(Dialect dialect);

// Checks that in each network every contact and output has a result to work on, every block is
// joined before an output, every MPS has its MPP, and the depths keep the limits. Every fault is an
// error at the instruction that shows it.
void check_structure(const std::string& file, Dialect dialect, std::span<const StructureItem> items,
                     Diagnostics& diagnostics);

// The networks of instructions that pass the checks: one ends before a load that follows an output
// with no block or branch open, and before an STL. What stands between networks is one of its own.
// NOPs before a load belong to the network it begins.
std::vector<Network> split_networks(std::span<const Instruction> instructions);

}  // namespace rung
