// SPDX-License-Identifier: Apache-2.0
// The whole program as values: every bit is a literal of one graph of ANDs, every word the result
// of one operation. Rungs are gone after this pass: what two of them compute alike is one node, and
// what nobody can see is none. What of it may be merged is said in MERGING.md.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "logic/logic.hpp"

namespace rung::values {

// A node of the graph, or its inverse: twice the node's number, plus 1 for the inverse.
using Literal = std::int32_t;
using NodeId = std::int32_t;
inline constexpr Literal kFalse = 0;
inline constexpr Literal kTrue = 1;
inline NodeId node_of(Literal literal) { return literal >> 1; }
inline bool inverted(Literal literal) { return (literal & 1) != 0; }
inline Literal inverse(Literal literal) { return literal ^ 1; }

enum class NodeKind : std::uint8_t {
  False,  // node 0
  Start,  // a bit device's value at the start of the scan
  Test,   // what a test (WordOp) has found
  And,
};

struct Node {
  NodeKind kind = NodeKind::False;
  Device device;                // Start
  std::int32_t operation = -1;  // Test: index into Values::operations
  Literal left = kFalse;        // And
  Literal right = kFalse;
};

// A word: a constant, a device's value at the start of the scan, or a result.
struct Word {
  enum class Kind : std::uint8_t { Constant, Start, Result };
  Kind kind = Kind::Constant;
  std::int16_t value = 0;
  Device device;                // Start
  std::int32_t operation = -1;  // Result: index into Values::operations
  std::int32_t output = 0;      // which of its words
  bool operator==(const Word&) const = default;
};

// One operation on words. With `gate` 0 each output is the word in `keep` at its place.
struct WordOp {
  core::Op op = core::Op::Mov;
  std::vector<Word> operands;  // as core::Instruction has them
  std::vector<Literal> bits;   // Gather: the lowest first
  Literal gate = kTrue;
  std::vector<Word> keep;       // one an output; of no meaning if the gate is kTrue, but for
                                // a division, which keeps it where the divisor is 0
  int outputs = 1;              // 0: a test
  std::vector<Device> targets;  // what the outputs are written to; of hidden words too
  std::size_t instruction = 0;  // the core instruction it was made of
};

// One write of the program, in its order: what a trace shows.
struct BitWrite {
  Device device;
  Literal value = kFalse;
  std::size_t instruction = 0;
  bool last = false;  // of this device in the scan
};
struct WordWrite {
  Device device;
  Word value;
  std::size_t instruction = 0;
  bool last = false;
};

struct Values {
  std::vector<Node> nodes;
  std::vector<WordOp> operations;  // in the order of the program, so each behind what it reads
  std::vector<BitWrite> bit_writes;
  std::vector<WordWrite> word_writes;
  std::map<Device, Literal> bits;  // value at the end of the scan of each bit that is written
  std::map<Device, Word> words;

  // The node with these parents, simplified.
  Literal land(Literal a, Literal b);
  Literal lor(Literal a, Literal b) { return inverse(land(inverse(a), inverse(b))); }
  Literal choose(Literal condition, Literal yes, Literal no) {
    return lor(land(condition, yes), land(inverse(condition), no));
  }
  Literal start(Device device);
  Literal test(std::int32_t operation);

  std::unordered_map<std::uint64_t, NodeId> ands;
  std::map<Device, NodeId> starts;
};

Values build(const logic::Logic& logic, const core::Program& program);

// True if somebody beside the program can see this device between scans.
inline bool is_visible(Device device) {
  return device.kind != DeviceKind::HB && device.kind != DeviceKind::HW;
}

}  // namespace rung::values
