// SPDX-License-Identifier: Apache-2.0
// A ladder program as its source says it: networks (rungs) of instructions, each with its place in
// the file. Front ends make it; the reference interpreter, the C back end and the compiler read it.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "source/diagnostics.hpp"

namespace rung {

enum class Dialect : std::uint8_t { Paper, Fx, Q };
// "paper", "fx", "q"
std::string_view dialect_name(Dialect dialect);

// Kinds of devices. X are the inputs, Y the outputs, M relays, D words.
enum class DeviceKind : std::uint8_t { X, Y, M, D };

struct Device {
  DeviceKind kind = DeviceKind::X;
  std::uint32_t number = 0;
  auto operator<=>(const Device&) const = default;
};
inline bool is_word(Device device) { return device.kind == DeviceKind::D; }
// The name a trace uses: upper case, no leading zeros, in the number base of the dialect.
std::string device_name(Device device, Dialect dialect);

// What an instruction does; the names are MELSEC's, whatever the dialect called it.
enum class Op : std::uint8_t {
  Nop,
  Ld,
  Ldi,
  And,
  Ani,
  Or,
  Ori,  // contacts: `device`
  Anb,
  Orb,
  Mps,
  Mrd,
  Mpp,  // blocks and branches
  Out,
  Set,
  Rst,  // coils: `device` (Rst of a word device clears it)
  Mov,  // target <- sources[0]
  Add,
  Sub,
  Mul,
  Div,  // target <- sources[0] op sources[1]
};
inline bool is_contact(Op op) { return op >= Op::Ld && op <= Op::Ori; }
inline bool is_output(Op op) { return op >= Op::Out; }

// A word operand: a constant or a word device.
struct WordSource {
  bool constant = true;
  std::int16_t value = 0;  // of a constant
  Device device;           // otherwise
  bool operator==(const WordSource&) const = default;
};

struct Instruction {
  Op op = Op::Nop;
  Device device;          // contacts, coils; target of word instructions
  WordSource sources[2];  // word instructions; two-operand forms are written out in full
  bool double_width =
      false;  // MUL, DIV: also write the high word, the remainder, to the next device
  bool two_operand = false;  // the source wrote `ADD rs rd` (for listings and translation)
  SourcePosition position;   // of the mnemonic
  std::string text;          // the instruction as the source wrote it, blanks normalised
};

struct Network {
  std::size_t first = 0;  // index into Program::instructions
  std::size_t count = 0;
};

struct Program {
  std::string file;  // as the user named it
  Dialect dialect = Dialect::Fx;
  std::vector<Instruction> instructions;  // without END
  std::vector<Network> networks;          // consecutive, covering all instructions
};

// Counts of INTERFACES.md.
struct ProgramCounts {
  int networks = 0;
  int instructions = 0;
  int contacts = 0;
  std::vector<int> run_lengths;  // contacts of each run, in order
};
ProgramCounts count(const Program& program);

// Every device that the program names, in order, with the second words of MUL and DIV.
std::vector<Device> named_devices(const Program& program);

}  // namespace rung
