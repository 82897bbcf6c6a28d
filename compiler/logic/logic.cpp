// SPDX-License-Identifier: Apache-2.0
#include "logic/logic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>
#include <stdexcept>

namespace rung::logic {
namespace {

using core::Instruction;
using core::Op;
using core::Program;
using WriterMap = std::map<Device, std::vector<Version>>;

class Builder {
 public:
  explicit Builder(const Program& program) : program_(program) {}

  Logic build() {
    for (std::size_t n = 0; n < program_.networks.size(); ++n) {
      network_ = static_cast<std::int32_t>(n);
      blocks_.clear();
      branches_.clear();
      leaves_.clear();
      result_ = kNoNode;
      const core::Network& network = program_.networks[n];
      for (std::size_t i = 0; i < network.count; ++i) execute(network.first + i);
    }
    logic_.writers.assign(writers_.begin(), writers_.end());
    return std::move(logic_);
  }

 private:
  void execute(std::size_t index) {
    instruction_ = index;
    const Instruction& instruction = program_.instructions[index];
    switch (instruction.op) {
      case Op::Nop:
        break;
      case Op::Ld:
      case Op::Ldi:
        blocks_.push_back(result_);
        result_ = literal(instruction.targets[0], instruction.op == Op::Ldi);
        break;
      case Op::And:
      case Op::Ani:
        result_ = gate(NodeKind::And, result_,
                       literal(instruction.targets[0], instruction.op == Op::Ani));
        break;
      case Op::Or:
      case Op::Ori:
        result_ =
            gate(NodeKind::Or, result_, literal(instruction.targets[0], instruction.op == Op::Ori));
        break;
      case Op::Anb:
      case Op::Orb:
        assert(!blocks_.empty());
        result_ =
            gate(instruction.op == Op::Anb ? NodeKind::And : NodeKind::Or, blocks_.back(), result_);
        blocks_.pop_back();
        break;
      case Op::Inv:
        result_ = inverse(result_);
        break;
      case Op::Pop:
        result_ = blocks_.back();
        blocks_.pop_back();
        break;
      case Op::Mps:
        branches_.push_back(result_);
        break;
      case Op::Mrd:
        result_ = branches_.back();
        break;
      case Op::Mpp:
        result_ = branches_.back();
        branches_.pop_back();
        break;
      default:
        act(instruction, index);
    }
  }

  std::int32_t epoch() const { return static_cast<std::int32_t>(logic_.actions.size()); }

  Version version(Device device) const {
    const auto found = writers_.find(device);
    return found == writers_.end() ? kStart : found->second.back();
  }

  NodeId add(Node node) {
    node.epoch = epoch();
    node.network = network_;
    node.instruction = instruction_;
    logic_.nodes.push_back(node);
    return static_cast<NodeId>(logic_.nodes.size()) - 1;
  }

  NodeId leaf(Device device) {
    const auto [place, fresh] = leaves_.try_emplace({device, version(device)}, kNoNode);
    if (fresh) {
      Node node;
      node.device = device;
      node.version = version(device);
      place->second = add(node);
    }
    return place->second;
  }

  NodeId literal(Device device, bool inverted) {
    const NodeId plain = leaf(device);
    if (!inverted) return plain;
    Node node;
    node.kind = NodeKind::NotLeaf;
    node.left = plain;
    ++logic_.nodes[plain].uses;
    return add(node);
  }

  // The structure of a program is checked before; what lowering makes of it has to keep it.
  void require(NodeId result) const {
    if (result != kNoNode) return;
    throw std::logic_error(fmt::format(
        "internal error in lowering: core instruction {} has no result to work on", instruction_));
  }

  NodeId inverse(NodeId of) {
    require(of);
    if (logic_.nodes[of].kind == NodeKind::NotLeaf) return logic_.nodes[of].left;
    // A leaf that has been overwritten since can only be had from where it was kept.
    const Node& child = logic_.nodes[of];
    const bool reads = child.kind == NodeKind::Leaf && version(child.device) == child.version;
    Node node;
    node.kind = reads ? NodeKind::NotLeaf : NodeKind::Not;
    node.left = of;
    ++logic_.nodes[of].uses;
    return add(node);
  }

  NodeId gate(NodeKind kind, NodeId left, NodeId right) {
    require(left);
    require(right);
    Node node;
    node.kind = kind;
    node.left = left;
    node.right = right;
    ++logic_.nodes[left].uses;
    ++logic_.nodes[right].uses;
    return add(node);
  }

  Operand operand(const WordSource& source) const {
    return {source, source.constant ? kStart : version(source.device)};
  }

  void act(const Instruction& instruction, std::size_t index) {
    Action action;
    action.op = instruction.op;
    action.targets = instruction.targets;
    action.head = instruction.head;
    action.quiet = instruction.quiet;
    action.instruction = index;
    action.network = network_;
    for (const WordSource& source : instruction.sources) action.operands.push_back(operand(source));
    for (const Device device : instruction.reads) action.reads.push_back({device, version(device)});
    if (!instruction.always) {
      require(result_);
      action.condition = result_;
      if (conditions_.size() < logic_.nodes.size()) conditions_.resize(logic_.nodes.size());
      if (!conditions_[result_]) ++logic_.nodes[result_].uses;
      conditions_[result_] = true;
    }
    const Version number = epoch();
    for (const Device device : action.targets) writers_[device].push_back(number);
    logic_.actions.push_back(std::move(action));
  }

  const Program& program_;
  Logic logic_;
  WriterMap writers_;
  std::int32_t network_ = 0;
  std::size_t instruction_ = 0;
  NodeId result_ = kNoNode;
  std::vector<NodeId> blocks_, branches_;
  std::map<std::pair<Device, Version>, NodeId> leaves_;
  std::vector<bool> conditions_;
};

std::string version_name(Version version) {
  return version == kStart ? std::string("start") : fmt::format("a{}", version);
}

}  // namespace

namespace {

const std::vector<Version>* find_writers(const Logic& logic, Device device) {
  const auto found =
      std::lower_bound(logic.writers.begin(), logic.writers.end(), device,
                       [](const auto& entry, const Device& key) { return entry.first < key; });
  if (found == logic.writers.end() || found->first != device) return nullptr;
  return &found->second;
}

}  // namespace

Version Logic::current(Device device, std::int32_t epoch) const {
  const auto* versions = find_writers(*this, device);
  if (versions == nullptr) return kStart;
  const auto next = std::lower_bound(versions->begin(), versions->end(), epoch);
  return next == versions->begin() ? kStart : *std::prev(next);
}

std::int32_t Logic::overwritten(Device device, Version version) const {
  const auto* versions = find_writers(*this, device);
  if (versions == nullptr) return kNever;
  const auto next = std::upper_bound(versions->begin(), versions->end(), version);
  return next == versions->end() ? kNever : *next;
}

Logic build(const core::Program& program) { return Builder(program).build(); }

std::string dump(const Logic& logic, const core::Program& program, Dialect dialect) {
  std::string out;
  for (std::size_t i = 0; i < logic.nodes.size(); ++i) {
    const Node& node = logic.nodes[i];
    switch (node.kind) {
      case NodeKind::Leaf:
        out += fmt::format("n{} = {}@{}\n", i, device_name(node.device, dialect),
                           version_name(node.version));
        break;
      case NodeKind::NotLeaf:
      case NodeKind::Not:
        out += fmt::format("n{} = not n{}\n", i, node.left);
        break;
      default:
        out += fmt::format("n{} = n{} {} n{}\n", i, node.left,
                           node.kind == NodeKind::And ? "and" : "or", node.right);
    }
  }
  for (std::size_t i = 0; i < logic.actions.size(); ++i) {
    const Action& action = logic.actions[i];
    const std::string what = core::to_string(program.instructions[action.instruction], dialect);
    out += action.condition == kNoNode
               ? fmt::format("a{}: {}\n", i, what)
               : fmt::format("a{}: if n{}: {}\n", i, action.condition, what);
  }
  return out;
}

}  // namespace rung::logic
