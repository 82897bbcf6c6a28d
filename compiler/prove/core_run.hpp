// SPDX-License-Identifier: Apache-2.0
// What a core program means: its instructions one after the other, as terms.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/program.hpp"
#include "prove/start.hpp"

namespace rung::prove {

// One value that a core instruction writes.
struct Action {
  std::size_t instruction = 0;
  Bit condition = kTrue;  // under which it is written
  Bit care = kTrue;  // where this is 0, any value will do: an index points outside of its window
  Word value;        // of a bit in bit 0
  bool word = false;
  bool quiet = false;
  // Of an indexed store: to the device at `address`, one of the targets if `inside`.
  bool indexed = false;
  Word address;
  Bit inside = kTrue;
  std::vector<Device> targets;
  std::vector<Bit> hits;       // which of the targets it is, if it is executed
  std::vector<Word> contents;  // of the targets behind it
  NodeId since = 0;            // nodes from this one on are of its rung
};

struct Meant {
  std::vector<Action> actions;  // in program order
  // Of each device that is written: its actions, and which of their targets it is.
  std::map<Device, std::vector<std::pair<std::size_t, std::size_t>>> writes;
  Bit error = kFalse;  // a division by 0 has been executed
};

// What an index outside of its window does, which no program may depend on.
enum class Outside : std::uint8_t {
  Anything,  // a load gives any value; a store is not looked for inside
  LowBits,   // it goes where its low bits lead, as many as the window's size has, if to anywhere
};

// Throws std::logic_error for what no core program may be: a result that is missing, a window whose
// devices do not lie side by side.
Meant run_core(const core::Program& program, const std::map<Device, int>& places, Terms& terms,
               Start& start, Outside outside = Outside::Anything);

}  // namespace rung::prove
