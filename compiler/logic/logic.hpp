// SPDX-License-Identifier: Apache-2.0
// The program as logic: every network's contacts become a Boolean graph, every output instruction
// an action under one node of it. Blocks, stacks and branches are gone after this pass; what stays
// is which value of which device each contact read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/program.hpp"

namespace rung::logic {

using core::WordSource;

using NodeId = std::int32_t;
inline constexpr NodeId kNoNode = -1;

// A device's value is named by the action that wrote it, so two reads of one device are the same
// leaf only if nothing wrote it between them. kStart: the value at the start of the scan.
using Version = std::int32_t;
inline constexpr Version kStart = -1;
inline constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();

enum class NodeKind : std::uint8_t { Leaf, NotLeaf, Not, And, Or };

struct Node {
  NodeKind kind = NodeKind::Leaf;
  Device device;             // Leaf
  Version version = kStart;  // Leaf
  NodeId left = kNoNode;     // And, Or; the leaf of NotLeaf, the gate of Not
  NodeId right = kNoNode;    // And, Or
  std::int32_t epoch = 0;    // actions executed before the contact that made this node
  std::int32_t uses = 0;     // parents and, once, being some action's condition
  std::int32_t network = 0;
  std::size_t instruction = 0;  // the source instruction that made it
};

// A word operand with the version of the device that it reads.
struct Operand {
  WordSource source;
  Version version = kStart;
};

// Another device that is read, with its version.
struct Read {
  Device device;
  Version version = kStart;
};

// One output instruction. Its number in Logic::actions is the Version that it writes.
struct Action {
  core::Op op = core::Op::Out;
  NodeId condition = kNoNode;  // kNoNode: it always runs
  std::vector<Device> targets;
  std::vector<Operand> operands;
  std::vector<Read> reads;  // bits of a Gather; the window of an indexed load
  Device head;              // of an indexed operation
  bool quiet = false;
  std::size_t instruction = 0;  // index into core::Program::instructions
  std::int32_t network = 0;
};

struct Logic {
  std::vector<Node> nodes;
  std::vector<Action> actions;  // in program order

  // The version of `device` that an instruction sees after the first `epoch` actions.
  Version current(Device device, std::int32_t epoch) const;

  // The action that next writes `device` after `version`, or kNever. An instruction after the first
  // `epoch` actions reads `version` exactly if it is current then, so as long as epoch <= this.
  std::int32_t overwritten(Device device, Version version) const;

  std::vector<std::pair<Device, std::vector<Version>>> writers;  // by device, in program order
};

// Executes `program` symbolically.
Logic build(const core::Program& program);

// One line a node and an action, for --dump logic and for tests.
std::string dump(const Logic& logic, const core::Program& program, Dialect dialect);

}  // namespace rung::logic
