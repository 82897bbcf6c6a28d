// SPDX-License-Identifier: Apache-2.0
// What MPU4 has to do in a scan, without times and places: look-ups, and groups of word
// instructions that stand at fixed distances in one unit.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "values/values.hpp"
#include "wide/cover.hpp"
#include "wide/latch.hpp"
#include "wide/machine.hpp"

namespace rung::wide {

using values::Literal;
using values::NodeId;

inline constexpr std::int32_t kNone = -1;
inline constexpr std::size_t kNoInstruction = static_cast<std::size_t>(-1);

// One bit instruction. Inputs are nodes: what a device holds at the start of the scan, a flag, or
// what another look-up computes (Work::provider).
struct LookUp {
  Cut cut;                         // its inputs and its table
  Literal value = values::kFalse;  // what it computes
  std::int32_t flag = kNone;       // the test (index into Values::operations) whose flag it reads
  std::int32_t group = kNone;      // the group that it belongs to, if it does
  // Filled with the bits `cut` names in order, for the word instruction GET beside it.
  bool gather = false;
  std::size_t instruction = kNoInstruction;  // the core instruction it is shown with
};

// One word instruction.
struct WordWork {
  Opcode opcode = Opcode::Nop;
  int offset = 0;  // steps behind the first of its group
  values::Word s1, s2;
  bool keeps = false;           // may leave the value: under a gate, and by a division by 0
  values::Word keep;            // that value, if so
  std::int32_t gate = kNone;    // look-up one step before it, in slot 2u; kNone: always
  bool clear = false;           // GET: acc is cleared first
  std::int32_t gather = kNone;  // GET: the look-up beside it
  bool writes = false;          // its result is a value, else its place is free
  std::int32_t operation = kNone;
  int output = 0;
};

// Word instructions of one unit at fixed distances, with the look-ups that take their flag.
struct Group {
  std::vector<WordWork> words;  // by offset
  struct Capture {
    int offset = 0;
    std::int32_t look_up = kNone;
  };
  std::vector<Capture> captures;
  std::int32_t home = kNone;  // groups of one home stand in one unit
  std::int32_t test = kNone;  // the operation whose flag it leaves, if it does
  bool divides = false;       // starts a division at its first step
  bool wide = false;          // 32-bit multiplication or division: unit 0's alone
  std::size_t instruction = kNoInstruction;
};

struct Work {
  Latch latch;
  std::vector<LookUp> look_ups;
  std::vector<Group> groups;
  int homes = 0;
  // By node of Values: the look-up that computes it for those that read it, or kNone.
  std::vector<std::int32_t> provider;
  // By operation of Values and output: group and place in it.
  struct Made {
    std::int32_t group = kNone;
    std::int32_t word = kNone;
  };
  std::vector<std::vector<Made>> made;
  // Where a device lives: the look-up or the word of a group that writes its last value. Devices
  // that nothing writes are in neither.
  std::map<Device, std::int32_t> bit_home;
  std::map<Device, Made> word_home;
  // With merging off: of each of Values::bit_writes its own look-up.
  std::vector<std::int32_t> bit_writes;
};

struct WorkOptions {
  // Equal computations are made once, and values that nobody can see not at all (MERGING.md). Off:
  // every write of the program has a place of its own.
  bool merge = true;
};

// `latch`: the bits that come in before the scan.
Work make_work(const values::Values& values, const Machine& machine, const Latch& latch,
               const WorkOptions& options);

}  // namespace rung::wide
