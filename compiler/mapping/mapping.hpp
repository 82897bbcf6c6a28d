// SPDX-License-Identifier: Apache-2.0
// The program as operations of a slot: look-ups with their eight-bit functions, coil and word
// operations, grouped into units. Operands are still values (a device and who wrote it, a
// temporary, the previous look-up), not addresses. Step numbers and slots come later (schedule/).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "isa/isa.hpp"
#include "logic/logic.hpp"

namespace rung::mapping {

using OpId = std::int32_t;
inline constexpr OpId kNoOp = -1;

// A bit that an operation reads.
struct BitValue {
  enum class Kind : std::uint8_t { None, N0, Device, Temporary };
  Kind kind = Kind::None;
  Device device;                           // Device
  logic::Version version = logic::kStart;  // Device
  std::int32_t temporary = -1;             // Temporary: its number
  bool operator==(const BitValue&) const = default;
};

// Where an operation writes: a device (bit or word) as a version of it, a temporary bit, or any
// device of a window (MappedOp::window), which then all are versions of it.
struct Destination {
  enum class Kind : std::uint8_t { None, Device, Temporary, Window };
  Kind kind = Kind::None;
  Device device;
  logic::Version version = logic::kStart;
  std::int32_t temporary = -1;
};

// One instruction of a slot, before it has addresses.
struct MappedOp {
  isa::Opcode opcode = isa::Opcode::Nop;
  // Look-ups: inputs a, b, c; bit {a,b,c} of `function` (a highest) is the result. The operand c of
  // a look-up that writes is None, N0 or the destination itself (its port reads the destination).
  // LD has input a, GET the bits that enter, the highest as a.
  std::array<BitValue, 3> inputs;
  std::uint8_t function = 0;
  std::optional<std::uint8_t> paper_row;   // Table 2's opcode, in --paper mode
  std::array<logic::Operand, 2> operands;  // word operations: s1, s2
  // Indexed operations: the device that an index of 0 means (of IX), devices that may be read,
  // devices that may be written.
  Device head;
  std::vector<logic::Read> reads;
  std::vector<Device> window;
  Destination destination;
  bool always = false;          // runs whatever exc is; of GET: clears acc first
  bool quiet = false;           // a write that changes nothing is none, for traces
  OpId started_by = kNoOp;      // MVL, MVH, MV2, MV3: the operation whose result they collect
  OpId condition = kNoOp;       // operations under exc: the operation that computes exc
  std::size_t instruction = 0;  // the core instruction it is shown with
  std::int32_t action = -1;     // the action it performs, if it does
};

// Operations that one slot runs in this order with no foreign exc between them. A collector of a
// unit's MULS or DIVS runs later in the same slot, on its own.
struct Unit {
  std::vector<OpId> ops;
  std::vector<OpId> collectors;
};

struct Mapping {
  std::vector<MappedOp> ops;
  std::vector<Unit> units;  // an order in which one slot could run them
  std::int32_t temporaries = 0;
};

// True for the four look-up opcodes.
bool is_lookup(isa::Opcode opcode);
// True for operations that write exc.
bool writes_exc(isa::Opcode opcode);
// True for operations whose result is collected later; the unit is theirs until then.
bool starts_unit(isa::Opcode opcode);
// Clocks from the operation that starts the unit to the first that may collect.
int collect_latency(isa::Opcode start, const isa::Config& config);
// True for operations that use ix, which an IX before them in their unit has set.
bool uses_index(isa::Opcode opcode);

struct Options {
  bool split_muldiv = true;  // MULS/DIVS and collectors instead of MUL and DIV, which wait
  bool fuse = true;          // look-ups that also write their device
};

// Covers the logic of each network with three-input look-ups; per network never more of them than
// `lookup_bound`.
Mapping map_logic(const logic::Logic& logic, const core::Program& program, const Options& options);

// The paper's forms (section 5.1): every run of contacts cut into threes from the left, N0 first in
// each later look-up, one operation for every other instruction. `keep_nops`: NOPs take a step.
Mapping map_paper(const logic::Logic& logic, const core::Program& program, bool keep_nops);

// Section 6: look-ups of `inputs` operands that a run of n operands takes; 1 if n <= inputs.
int run_lookups(int n, int inputs = 3);
// What a network may take: the formula summed over its runs, where a run that continues after
// anything but a block has N0 as one more operand, and one look-up for each ANB and ORB.
int lookup_bound(const core::Program& program, const core::Network& network);

// Checks a mapping against its logic: every action's condition on random values of all leaves, the
// operand and port rules of MappedOp, and `lookup_bound` in each network. Empty, or what is wrong.
std::string verify(const Mapping& mapping, const logic::Logic& logic, const core::Program& program);

std::string dump(const Mapping& mapping, Dialect dialect);

}  // namespace rung::mapping
