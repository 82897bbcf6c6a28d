// SPDX-License-Identifier: Apache-2.0
// A ladder program as its source says it: networks (rungs) of instructions, each with its place in
// the file. Front ends make it; the reference interpreter, the C back end and the lowering read it.
// What each instruction does is in compiler/SEMANTICS.md.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rungs/device.hpp"
#include "source/diagnostics.hpp"

namespace rung {

// What an instruction does; the names are MELSEC's, whatever the dialect called it. `operands` are
// in the order of the source, two-operand forms written out in full. An LDmicro program has the
// instructions behind Rung, and of those before it And, Ani, AndCompare, Out, Outi, Set, Rst, Mov,
// Add, Sub, Mul and Div, which mean the same there (compiler/LDMICRO.md).
enum class Op : std::uint8_t {
  Nop,
  Label,  // a pointer, P: operands[0]
  // Contacts: operands[0], a bit; of a compare contact operands[0] and [1], words.
  Ld,
  Ldi,
  And,
  Ani,
  Or,
  Ori,
  LdP,
  LdF,
  AndP,
  AndF,
  OrP,
  OrF,
  LdCompare,
  AndCompare,
  OrCompare,
  // Blocks and branches.
  Anb,
  Orb,
  Inv,
  Mep,
  Mef,
  Mps,
  Mrd,
  Mpp,
  // Zones.
  Mc,   // operands: nesting level, relay
  Mcr,  // nesting level
  Stl,  // state
  Ret,
  // Outputs on bits.
  Out,   // bit
  Outi,  // bit; LadderDrive: the inverse of the result
  OutT,  // timer (its contact), preset; `base_us`
  OutC,  // counter (its contact), preset; 32 bits wide where the counter is
  Set,
  Rst,  // bit; word (clears it); timer or counter (its contact)
  Pls,  // bit
  Plf,
  Alt,   // bit
  Sft,   // bit: takes the value of the bit before it, which becomes 0 (Q)
  Sftl,  // source head, target head, length, count
  Sftr,
  Bsfl,  // head, length: one bit (Q)
  Bsfr,
  // Words. `width` is 16 or 32.
  Mov,  // source, target
  Cml,
  Bcd,
  Bin,
  Xch,   // two targets
  Swap,  // target
  Bmov,  // source, target, count
  Fmov,
  Add,  // source, source, target
  Sub,
  Mul,
  Div,
  Wand,
  Wor,
  Wxor,
  Wxnr,
  Inc,  // target
  Dec,
  Neg,
  Rol,  // target, count
  Ror,
  Rcl,
  Rcr,
  Sfl,
  Sfr,
  Wsfl,  // source head, target head, length, count
  Wsfr,
  Dsfl,  // head, length: one word (Q)
  Dsfr,
  Cmp,   // source, source, three bits from
  Zcp,   // low, high, source, three bits from
  Zrst,  // first, last
  // Flow.
  Cj,    // pointer
  Call,  // pointer
  Sret,
  Fend,
  For,  // count
  Next,
  // LDmicro: a rung is a series of elements, in which series may stand in parallel. The condition
  // goes through them from left to right, and each may change it.
  Rung,      // begins a rung; the condition is what MASTER RELAY lets through
  Comment,   // `note`
  Parallel,  // the condition goes into several branches; the first one begins
  Branch,    // that one ends and the next begins
  Join,      // the last one ends; the condition is 1 if it is at the end of any of them
  Short,
  Open,
  Osr,
  Osf,
  MasterRelay,
  Ton,  // variable, number of scans after which the output changes (at least 1); `base_us`
  Tof,
  Rto,
  Res,  // variable
  Ctu,  // variable, limit
  Ctd,
  Ctc,
  ShiftRegister,    // the variables, the first stage first
  LookUpTable,      // target, index, Number: shown as a string in LDmicro's editor; `table`
  PiecewiseLinear,  // target, index; `table`: x0 y0 x1 y1 ...
  ReadAdc,          // variable, Number: channel
  SetPwm,           // duty (variable), Constant: frequency in Hz
  Persist,          // variable, Number: which of the program's
  UartSend,         // variable
  UartRecv,
  FormattedString,  // variable, or no operand; `table`: characters as the source has them
};
// Rung, Parallel, Branch, Join, Comment: they are not elements of the source's count.
inline bool is_frame(Op op) { return op >= Op::Rung && op <= Op::Join; }

enum class Relation : std::uint8_t { Equal, NotEqual, Less, Greater, LessEqual, GreaterEqual };

struct Operand {
  enum class Kind : std::uint8_t {
    Device,    // bit or word, as the instruction takes it
    Constant,  // K, H: `value`
    Digits,    // KnXm: `digits` groups of four bits from `device` on
    WordBit,   // D0.F: bit `bit` of the word `device`
    Number,    // P or N: `value`
  };
  Kind kind = Kind::Device;
  Device device;
  int digits = 0;
  int bit = 0;
  std::int32_t value = 0;
  std::optional<Device> index;  // Device only: V or Z whose value is added to the device's number
  bool operator==(const Operand&) const = default;
};

struct Instruction {
  Op op = Op::Nop;
  std::vector<Operand> operands;
  int width = 16;                       // 16, or 32 for the D forms
  bool pulse = false;                   // P forms: executed only when the condition goes on
  Relation relation = Relation::Equal;  // compare contacts
  std::int64_t base_us = 0;             // OutT: time of one tick; Ton, Tof, Rto: the delay
  bool double_width = false;  // MUL, DIV: the result takes twice the width (not in `paper`)
  bool two_operand = false;   // the source wrote `ADD rs rd` (for listings and translation)
  // Index of the instruction it leads to: CJ and CALL to the Label, FOR to NEXT, NEXT to FOR.
  std::size_t destination = 0;
  std::vector<std::int32_t> table = {};  // of the instructions that have one
  std::string note = {};                 // Comment: its text, lines parted by \n
  SourcePosition position;               // of the mnemonic
  std::string text;  // the instruction as the source wrote it, blanks normalised

  const Operand& operand(std::size_t i) const { return operands.at(i); }
};

// What an LDmicro file says beside its rungs.
struct LdmicroSettings {
  struct Pin {
    std::string name;
    int pin = 0;  // 0: not assigned
    bool operator==(const Pin&) const = default;
  };
  std::string micro;
  std::int64_t cycle_us = 10000;
  std::int64_t crystal_hz = 4000000;
  std::int64_t baud = 2400;
  std::string compiled;  // the file that was last made of it
  std::vector<Pin> pins;
  SourcePosition cycle_position, baud_position;  // for what the configuration cannot do
};

struct Network {
  std::size_t first = 0;  // index into Program::instructions
  std::size_t count = 0;
};

struct Program {
  std::string file;  // as the user named it
  Dialect dialect = Dialect::Fx;
  std::vector<Instruction> instructions;   // without END
  std::vector<Network> networks;           // consecutive, covering all instructions
  std::map<Device, std::string> comments;  // device names, from a comment file
  // LDmicro only: what its devices are called, as traces write it (a variable that shares its name
  // with a bit is `name:w`); an analogue channel has the name of the variable that it is read into.
  std::map<Device, std::string> names;
  std::optional<LdmicroSettings> ldmicro;
};

// The name of a device of this program in its traces; names.hpp has the way back.
std::string device_name(Device device, const Program& program);

// Contacts (INTERFACES.md): LD LDI AND ANI OR ORI, their P and F forms, compare contacts.
inline bool is_contact(Op op) { return op >= Op::Ld && op <= Op::OrCompare; }
// Those that begin a block: LD LDI LDP LDF, LD with a compare.
bool is_load(Op op);
// True for what uses the result of the contacts before it and keeps it.
bool is_output(Op op);

// Counts of INTERFACES.md.
struct ProgramCounts {
  int networks = 0;
  int instructions = 0;
  int contacts = 0;
  std::vector<int> run_lengths;  // contacts of each run, in order
};
ProgramCounts count(const Program& program);

// Every device that the program names, in order: second words, ranges, digit groups, index
// registers and, of a timer or counter, contact and value included; flags only if named.
std::vector<Device> named_devices(const Program& program);

}  // namespace rung
