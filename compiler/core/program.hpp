// SPDX-License-Identifier: Apache-2.0
// The lowered program: what is left of a source program when everything beyond the core has been
// written out. Contacts and coils on bits, a few operations on 16-bit words, no control flow. MPU1
// executes its instructions one by one; MPU2 and MPU3 get them as look-ups in a schedule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rungs/device.hpp"

namespace rung::core {

enum class Op : std::uint8_t {
  Nop,
  // Contacts: `target` is the bit that is read.
  Ld,
  Ldi,
  And,
  Ani,
  Or,
  Ori,
  // Blocks and branches.
  Anb,
  Orb,
  Inv,
  Pop,  // drops the current result for that of the block before
  Mps,
  Mrd,
  Mpp,
  // Coils.
  Out,
  Set,
  Rst,
  // Words: targets[0] <- sources[0] op sources[1].
  Mov,  // sources[0]
  Add,
  Sub,
  Wand,
  Wor,
  Wxor,
  Rol,
  Minu,  // the smaller, unsigned
  // 32 bits: two targets and four sources {low 0, high 0, low 1, high 1}, low words first.
  Add32,
  Sub32,
  // Multiply-divide unit: as many of its result words as there are targets, from the lowest.
  Mul,
  Div,
  Mul32,
  Div32,
  // Tests: the bit target <- a comparison of the sources; signed but for Ltu.
  Eq,
  Lt,
  Ltu,
  Lt32,  // four sources
  Tb,    // bit sources[1] (a constant) of sources[0]
  // Word target <- the bits `reads`.
  Gather,
  // Indexed: the device sources[0] beyond `head`, the first of its window.
  LoadWord,   // word target <- that word
  StoreWord,  // that word <- sources[1]
  LoadBit,    // bit target <- that bit
  SetBit,
  RstBit,
};

inline bool is_contact(Op op) { return op >= Op::Ld && op <= Op::Ori; }
// Outputs use the current result, unless they are `always`, and keep it.
inline bool is_output(Op op) { return op >= Op::Out; }
inline bool is_coil(Op op) { return op >= Op::Out && op <= Op::Rst; }
inline bool is_muldiv(Op op) { return op >= Op::Mul && op <= Op::Div32; }
inline bool is_indexed(Op op) { return op >= Op::LoadWord; }

// A word operand: a constant or a word device.
struct WordSource {
  bool constant = true;
  std::int16_t value = 0;  // of a constant
  Device device;           // otherwise
  bool operator==(const WordSource&) const = default;
};

struct Instruction {
  Op op = Op::Nop;
  // Devices written; of a contact the one that is read. StoreWord, SetBit and RstBit write all of
  // their window as far as anybody can tell: their targets are the window.
  std::vector<Device> targets;
  std::vector<WordSource> sources;
  std::vector<Device>
      reads;    // bits of Gather, the lowest first; the window of LoadWord and LoadBit
  Device head;  // indexed: the device that index 0 means
  // Runs whatever the result is.
  bool always = false;
  // Writing the value that is there already is no write (INTERFACES.md, writes of lowered
  // instructions).
  bool quiet = false;
  std::size_t origin = 0;  // the source instruction, for listings and traces
};

struct Network {
  std::size_t first = 0;  // index into Program::instructions
  std::size_t count = 0;
};

// A word that the controller fills before each scan with the ticks since the last one.
struct TickWord {
  Device device;
  std::int64_t base_us = 0;
};

// A word with a value that stands there before the first scan and that nothing writes.
struct ConstantWord {
  Device device;
  std::int16_t value = 0;
};

struct Program {
  std::vector<Instruction> instructions;
  std::vector<Network> networks;  // consecutive, covering all instructions
  std::vector<TickWord> ticks;
  std::vector<ConstantWord> constants;  // of tables
  // Devices that lie together in memory, in order, because an index goes over them.
  std::vector<std::vector<Device>> windows;
};

// Every device of the program in the order of their kinds and numbers, hidden ones included.
std::vector<Device> devices(const Program& program);

// "LD X0", "ADD32 D0 D1 := ...", for dumps.
std::string to_string(const Instruction& instruction, Dialect dialect);

}  // namespace rung::core
