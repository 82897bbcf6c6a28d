// SPDX-License-Identifier: Apache-2.0
#include "bytecode/stacks.hpp"

#include <algorithm>
#include <stdexcept>

namespace rung::bytecode {
namespace {

using core::Op;

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool is_load(Op op) { return op == Op::Ld || op == Op::Ldi; }
bool pops_block(Op op) { return op == Op::Anb || op == Op::Orb || op == Op::Pop; }

// For each instruction that pops the block stack, the load that has pushed.
std::vector<std::size_t> find_partners(const core::Program& program) {
  std::vector<std::size_t> partners(program.instructions.size(), kNone);
  for (const core::Network& network : program.networks) {
    std::vector<std::size_t> open;
    for (std::size_t i = network.first; i < network.first + network.count; ++i) {
      const Op op = program.instructions[i].op;
      if (is_load(op)) open.push_back(i);
      if (!pops_block(op)) continue;
      if (open.empty()) throw std::logic_error("byte code: a block ends that has not begun");
      partners[i] = open.back();
      open.pop_back();
    }
  }
  return partners;
}

// Whether the instruction uses the result as it finds it.
bool uses_result(const core::Instruction& instruction, bool pushes) {
  switch (instruction.op) {
    case Op::Nop:
    case Op::Pop:
    case Op::Mrd:
    case Op::Mpp:
    case Op::LoadBit:
      return false;
    case Op::Ld:
    case Op::Ldi:
      return pushes;
    default:
      return !instruction.always;
  }
}

bool sets_result(Op op) { return is_load(op) || op == Op::Pop || op == Op::Mrd || op == Op::Mpp; }

void measure(const core::Program& program, StackPlan& plan) {
  int blocks = 0;
  int branches = 0;
  for (std::size_t i = 0; i < program.instructions.size(); ++i) {
    const Op op = program.instructions[i].op;
    if (plan.pushes[i]) ++blocks;
    if (pops_block(op) && !plan.dropped[i]) --blocks;
    if (op == Op::Mps) ++branches;
    if (op == Op::Mpp) --branches;
    plan.blocks = std::max(plan.blocks, blocks);
    plan.branches = std::max(plan.branches, branches);
  }
}

}  // namespace

StackPlan plan_stacks(const core::Program& program) {
  const std::size_t count = program.instructions.size();
  StackPlan plan{std::vector<bool>(count, false), std::vector<bool>(count, false)};
  const std::vector<std::size_t> partners = find_partners(program);
  for (const std::size_t partner : partners) {
    if (partner != kNone) plan.pushes[partner] = true;
  }
  // Backwards, with whether anything still uses the result.
  bool used = false;
  for (std::size_t i = count; i-- > 0;) {
    const core::Instruction& instruction = program.instructions[i];
    if (instruction.op == Op::Pop && !used) {
      plan.dropped[i] = true;
      plan.pushes[partners[i]] = false;
    }
    if (sets_result(instruction.op)) used = false;
    if (uses_result(instruction, plan.pushes[i])) used = true;
  }
  measure(program, plan);
  return plan;
}

}  // namespace rung::bytecode
