// SPDX-License-Identifier: Apache-2.0
// The boolean machine on given values: only contacts and blocks, nothing is written.
#include <algorithm>

#include "rungs/devices.hpp"
#include "rungs/structure.hpp"
#include "view/engine.hpp"

namespace rung::view {
namespace {

class Machine {
 public:
  Machine(const Program& program, const std::function<std::int16_t(Device)>& value,
          std::vector<Conduction>& seen)
      : program_(program), value_(value), seen_(seen) {}

  void run() {
    seen_.assign(program_.instructions.size(), {});
    for (const Network& network : program_.networks) {
      blocks_.clear();
      branches_.clear();
      for (std::size_t i = network.first; i < network.first + network.count; ++i) step(i);
    }
  }

 private:
  std::int32_t word(const Operand& operand, int width) const {
    if (operand.kind == Operand::Kind::Constant) return operand.value;
    Device device = operand.device;
    if (operand.index) device.number += static_cast<std::uint32_t>(value_(*operand.index));
    if (operand.kind == Operand::Kind::Digits) {
      std::uint32_t bits = 0;
      for (int i = 0; i < 4 * operand.digits; ++i) {
        const Device bit{device.kind, device.number + static_cast<std::uint32_t>(i)};
        bits |= static_cast<std::uint32_t>(value_(bit) != 0) << i;
      }
      return static_cast<std::int32_t>(bits);
    }
    const auto low = static_cast<std::uint16_t>(value_(device));
    if (width == 16) return static_cast<std::int16_t>(low);
    const auto high = static_cast<std::uint16_t>(value_(high_word(device, program_.dialect)));
    return static_cast<std::int32_t>(low | static_cast<std::uint32_t>(high) << 16);
  }

  bool bit(const Operand& operand) const {
    if (operand.kind == Operand::Kind::WordBit) {
      return (value_(operand.device) >> operand.bit & 1) != 0;
    }
    Device device = operand.device;
    if (operand.index) device.number += static_cast<std::uint32_t>(value_(*operand.index));
    return value_(device) != 0;
  }

  bool compare(const Instruction& instruction) const {
    const std::int32_t a = word(instruction.operand(0), instruction.width);
    const std::int32_t b = word(instruction.operand(1), instruction.width);
    switch (instruction.relation) {
      case Relation::Equal:
        return a == b;
      case Relation::NotEqual:
        return a != b;
      case Relation::Less:
        return a < b;
      case Relation::Greater:
        return a > b;
      case Relation::LessEqual:
        return a <= b;
      case Relation::GreaterEqual:
        return a >= b;
    }
    return false;
  }

  bool closed(const Instruction& instruction) const {
    switch (instruction.op) {
      case Op::Ld:
      case Op::And:
      case Op::Or:
      case Op::Stl:
        return bit(instruction.operand(0));
      case Op::Ldi:
      case Op::Ani:
      case Op::Ori:
        return !bit(instruction.operand(0));
      case Op::LdCompare:
      case Op::AndCompare:
      case Op::OrCompare:
        return compare(instruction);
      default:
        return false;  // an edge
    }
  }

  // LDmicro: an element with a result of its own, as far as its variable shows it.
  bool given(const Instruction& instruction) const {
    const auto variable = [&] { return word(instruction.operand(0), 16); };
    const auto scans = [&] { return instruction.operand(1).value; };
    switch (instruction.op) {
      case Op::Open:
      case Op::Osr:
      case Op::Osf:
        return false;
      case Op::Ton:
        return result_ && variable() >= scans() - 1;
      case Op::Tof:
        return result_ || variable() < scans() - 1;
      case Op::Rto:
        return variable() >= scans() - 1;
      case Op::Ctu:
      case Op::Ctd:
        return variable() >= word(instruction.operand(1), 16);
      default:
        return result_;
    }
  }

  void step(std::size_t at) {
    const Instruction& instruction = program_.instructions[at];
    const Op op = instruction.op;
    bool conducts = false;
    if (is_contact(op)) {
      conducts = closed(instruction);
      contact(op, conducts);
    } else if (op == Op::Rung || op == Op::Stl) {
      blocks_.clear();
      result_ = conducts = op == Op::Rung || closed(instruction);
    } else {
      if (program_.dialect == Dialect::Ldmicro && !is_frame(op)) result_ = given(instruction);
      block(op);
      conducts = result_;
    }
    seen_[at] = {true, true, conducts};
  }

  void contact(Op op, bool conducts) {
    if (is_load(op)) {
      blocks_.push_back(result_);
      result_ = conducts;
    } else if (op == Op::Or || op == Op::Ori || op == Op::OrP || op == Op::OrF ||
               op == Op::OrCompare) {
      result_ = result_ || conducts;
    } else {
      result_ = result_ && conducts;
    }
  }

  bool pop(std::vector<bool>& stack) {
    if (stack.empty()) return false;
    const bool value = stack.back();
    stack.pop_back();
    return value;
  }

  void block(Op op) {
    switch (op) {
      case Op::Anb:
        result_ = pop(blocks_) && result_;
        return;
      case Op::Orb: {
        const bool first = pop(blocks_);
        result_ = first || result_;
        return;
      }
      case Op::Inv:
        result_ = !result_;
        return;
      case Op::Mep:
      case Op::Mef:
        result_ = false;
        return;
      case Op::Mps:
        branches_.push_back(result_);
        return;
      case Op::Mrd:
        if (!branches_.empty()) result_ = branches_.back();
        return;
      case Op::Mpp:
        result_ = pop(branches_);
        return;
      case Op::Parallel:
        branches_.push_back(result_);
        blocks_.push_back(false);
        return;
      case Op::Branch:
        blocks_.back() = blocks_.back() || result_;
        result_ = branches_.back();
        return;
      case Op::Join:
        result_ = pop(blocks_) || result_;
        branches_.pop_back();
        return;
      default:
        return;
    }
  }

  const Program& program_;
  const std::function<std::int16_t(Device)>& value_;
  std::vector<Conduction>& seen_;
  bool result_ = false;
  std::vector<bool> blocks_, branches_;
};

}  // namespace

void conduct(const Program& program, const std::function<std::int16_t(Device)>& value,
             std::vector<Conduction>& seen) {
  Machine(program, value, seen).run();
}

}  // namespace rung::view
