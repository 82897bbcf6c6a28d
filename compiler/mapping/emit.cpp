// SPDX-License-Identifier: Apache-2.0
#include "mapping/emit.hpp"

#include <algorithm>
#include <cassert>

#include "rungs/fold.hpp"

namespace rung::mapping {
namespace {

using isa::Opcode;
using logic::Action;
using logic::Operand;

Operand constant(std::int16_t value) {
  Operand operand;
  operand.source.constant = true;
  operand.source.value = value;
  return operand;
}

Destination to_device(Device device, std::int32_t version) {
  Destination destination;
  destination.kind = Destination::Kind::Device;
  destination.device = device;
  destination.version = version;
  return destination;
}

Opcode bit_opcode(Op op) {
  switch (op) {
    case Op::Set:
      return Opcode::Set;
    case Op::Rst:
      return Opcode::Rst;
    default:
      return Opcode::Out;
  }
}

Opcode word_opcode(Op op, bool split) {
  switch (op) {
    case Op::Add:
      return Opcode::Add;
    case Op::Sub:
      return Opcode::Sub;
    case Op::Mul:
      return split ? Opcode::Muls : Opcode::Mul;
    case Op::Div:
      return split ? Opcode::Divs : Opcode::Div;
    default:
      return Opcode::Mv;
  }
}

bool reads(const BitValue& value, const Destination& destination) {
  return destination.kind == Destination::Kind::Device && value.kind == BitValue::Kind::Device &&
         value.device == destination.device;
}

std::uint8_t permute(std::uint8_t function, const std::array<int, 3>& from) {
  std::uint8_t result = 0;
  for (int address = 0; address < 8; ++address) {
    int old = 0;
    for (int place = 0; place < 3; ++place) {
      if ((address >> (2 - place) & 1) != 0) old |= 1 << (2 - from[place]);
    }
    if ((function >> old & 1) != 0) result = static_cast<std::uint8_t>(result | 1 << address);
  }
  return result;
}

bool suits_c(const BitValue& value, const Destination& destination) {
  return destination.kind == Destination::Kind::None || value.kind == BitValue::Kind::None ||
         value.kind == BitValue::Kind::N0 || reads(value, destination);
}

}  // namespace

OpId append(Mapping& mapping, Unit& unit, MappedOp op) {
  mapping.ops.push_back(std::move(op));
  const OpId id = static_cast<OpId>(mapping.ops.size()) - 1;
  unit.ops.push_back(id);
  return id;
}

bool is_muldiv(Op op) { return op == Op::Mul || op == Op::Div; }

void append_action(Mapping& mapping, Unit& unit, const logic::Logic& logic, std::int32_t action,
                   OpId condition, bool split_muldiv) {
  const Action& source = logic.actions[action];
  MappedOp op;
  op.condition = condition;
  op.instruction = source.instruction;
  op.action = action;
  op.destination = to_device(source.target, action);
  if (logic::is_bit_action(source.op)) {
    op.opcode = bit_opcode(source.op);
    append(mapping, unit, op);
    return;
  }
  const Device second{source.target.kind, source.target.number + 1};
  op.operands = source.operands;
  if (source.op == Op::Mov) {
    op.opcode = Opcode::Mv;
    op.operands = {constant(0), source.operands[0]};
    append(mapping, unit, op);
    return;
  }
  if (op.operands[0].source.constant && op.operands[1].source.constant) {
    const auto result = fold(source.op, op.operands[0].source.value, op.operands[1].source.value);
    if (result) {
      op.opcode = Opcode::Mv;
      op.operands = {constant(0), constant(result->low)};
      append(mapping, unit, op);
      if (source.double_width) {
        op.operands[1] = constant(result->high);
        op.destination = to_device(second, action);
        append(mapping, unit, op);
      }
      return;
    }
    // A constant by 0 writes nothing, whatever the dividend; an instruction has one constant.
    op.operands[0].source.constant = false;
    op.operands[0].source.device = source.target;
    op.operands[0].version = kAnyVersion;
  }
  op.opcode = word_opcode(source.op, split_muldiv);
  if (!is_muldiv(source.op)) {
    append(mapping, unit, op);
    return;
  }
  if (split_muldiv) op.destination = {};
  const OpId start = append(mapping, unit, op);
  const auto collect = [&](Opcode opcode, Device target) {
    MappedOp collector;
    collector.opcode = opcode;
    collector.destination = to_device(target, action);
    collector.started_by = start;
    collector.instruction = source.instruction;
    collector.action = action;
    mapping.ops.push_back(collector);
    unit.collectors.push_back(static_cast<OpId>(mapping.ops.size()) - 1);
  };
  if (split_muldiv) collect(Opcode::Mvl, source.target);
  if (source.double_width) collect(Opcode::Mvh, second);
}

bool can_write(const std::array<BitValue, 3>& inputs, const Destination& destination) {
  return std::any_of(inputs.begin(), inputs.end(),
                     [&](const BitValue& value) { return suits_c(value, destination); });
}

void order_inputs(MappedOp& op) {
  std::array<int, 3> order{0, 1, 2};
  bool found = false;
  std::uint8_t best = 0;
  std::array<int, 3> best_order{};
  const auto rank = [&](const BitValue& value) { return reads(value, op.destination) ? 0 : 1; };
  const bool own = std::any_of(op.inputs.begin(), op.inputs.end(),
                               [&](const BitValue& value) { return rank(value) == 0; });
  do {
    const BitValue& c = op.inputs[order[2]];
    if (!suits_c(c, op.destination) || (own && rank(c) != 0)) continue;
    const std::uint8_t function = permute(op.function, order);
    if (found && function >= best) continue;
    found = true;
    best = function;
    best_order = order;
  } while (std::next_permutation(order.begin(), order.end()));
  assert(found);
  op.function = best;
  op.inputs = {op.inputs[best_order[0]], op.inputs[best_order[1]], op.inputs[best_order[2]]};
}

}  // namespace rung::mapping
