// SPDX-License-Identifier: Apache-2.0
#include "mapping/emit.hpp"

#include <algorithm>
#include <cassert>

namespace rung::mapping {
namespace {

using core::Op;
using isa::Opcode;
using logic::Action;
using logic::Operand;

Operand constant(std::int16_t value) {
  Operand operand;
  operand.source.constant = true;
  operand.source.value = value;
  return operand;
}

// The operations of one action, one after the other in their unit.
class ActionWriter {
 public:
  ActionWriter(Mapping& mapping, Unit& unit, const logic::Logic& logic, std::int32_t action,
               OpId condition, bool split_muldiv)
      : mapping_(mapping),
        unit_(unit),
        source_(logic.actions[action]),
        number_(action),
        condition_(condition),
        split_(split_muldiv) {}

  void write() {
    switch (source_.op) {
      case Op::Out:
        return write_one(Opcode::Out);
      case Op::Set:
        return write_one(Opcode::Set);
      case Op::Rst:
        return write_one(Opcode::Rst);
      case Op::Mov:
        return write_word(Opcode::Mv, constant(0), operand(0));
      case Op::Add:
        return write_word(Opcode::Add, operand(0), operand(1));
      case Op::Sub:
        return write_word(Opcode::Sub, operand(0), operand(1));
      case Op::Wand:
        return write_word(Opcode::Wand, operand(0), operand(1));
      case Op::Wor:
        return write_word(Opcode::Wor, operand(0), operand(1));
      case Op::Wxor:
        return write_word(Opcode::Wxor, operand(0), operand(1));
      case Op::Rol:
        return write_word(Opcode::Rol, operand(0), operand(1));
      case Op::Minu:
        return write_word(Opcode::Minu, operand(0), operand(1));
      case Op::Eq:
        return write_word(Opcode::Eq, operand(0), operand(1));
      case Op::Lt:
        return write_word(Opcode::Lt, operand(0), operand(1));
      case Op::Ltu:
        return write_word(Opcode::Ltu, operand(0), operand(1));
      case Op::Tb:
        return write_word(Opcode::Tb, operand(0), operand(1));
      case Op::Lt32:
        silent(Opcode::Cmp, operand(0), operand(2));
        return write_word(Opcode::Ltc, operand(1), operand(3));
      case Op::Add32:
      case Op::Sub32:
        return write_wide();
      case Op::Mul:
      case Op::Div:
      case Op::Mul32:
      case Op::Div32:
        return write_muldiv();
      case Op::Gather:
        return gather();
      case Op::LoadWord:
      case Op::LoadBit:
      case Op::StoreWord:
      case Op::SetBit:
      case Op::RstBit:
        return indexed();
      default:
        assert(false && "not an output");
    }
  }

 private:
  const Operand& operand(std::size_t i) const { return source_.operands.at(i); }

  MappedOp make(Opcode opcode) const {
    MappedOp op;
    op.opcode = opcode;
    op.instruction = source_.instruction;
    op.action = number_;
    op.quiet = source_.quiet;
    // Every gated operation says under which exc it runs, or that it runs under any.
    op.always = source_.condition == logic::kNoNode;
    op.condition = op.always ? kNoOp : condition_;
    return op;
  }

  Destination target(std::size_t i) const {
    Destination destination;
    destination.kind = Destination::Kind::Device;
    destination.device = source_.targets.at(i);
    destination.version = number_;
    return destination;
  }

  OpId write_one(Opcode opcode, std::size_t to) {
    MappedOp op = make(opcode);
    op.destination = target(to);
    return append(mapping_, unit_, std::move(op));
  }
  void write_one(Opcode opcode) { write_one(opcode, 0); }

  OpId word(Opcode opcode, const Operand& first, const Operand& second, Destination to) {
    MappedOp op = make(opcode);
    op.operands = {first, second};
    op.destination = to;
    return append(mapping_, unit_, std::move(op));
  }
  void write_word(Opcode opcode, const Operand& first, const Operand& second) {
    word(opcode, first, second, target(0));
  }
  // An operation that changes only the slot's own registers: it runs whatever exc is.
  void silent(Opcode opcode, const Operand& first, const Operand& second) {
    MappedOp op = make(opcode);
    op.operands = {first, second};
    op.always = false;
    op.condition = kNoOp;
    op.action = -1;
    append(mapping_, unit_, std::move(op));
  }

  void write_wide() {
    const bool add = source_.op == Op::Add32;
    word(add ? Opcode::Add : Opcode::Sub, operand(0), operand(2), target(0));
    word(add ? Opcode::Adc : Opcode::Sbc, operand(1), operand(3), target(1));
  }

  Opcode muldiv_opcode() const {
    switch (source_.op) {
      case Op::Mul:
        return split_ ? Opcode::Muls : Opcode::Mul;
      case Op::Div:
        return split_ ? Opcode::Divs : Opcode::Div;
      case Op::Mul32:
        return Opcode::Mulds;  // the slots' unit of 32 bits has no waiting form
      default:
        return Opcode::Divds;
    }
  }

  void write_muldiv() {
    const bool wide = source_.op == Op::Mul32 || source_.op == Op::Div32;
    if (wide) silent(Opcode::Ldh, operand(1), operand(3));
    const Opcode opcode = muldiv_opcode();
    const bool waits = opcode == Opcode::Mul || opcode == Opcode::Div;
    const OpId start =
        word(opcode, operand(0), operand(wide ? 2 : 1), waits ? target(0) : Destination{});
    const Opcode collectors[] = {Opcode::Mvl, Opcode::Mvh, Opcode::Mv2, Opcode::Mv3};
    for (std::size_t i = waits ? 1 : 0; i < source_.targets.size(); ++i) {
      MappedOp collector = make(collectors[i]);
      collector.destination = target(i);
      collector.started_by = start;
      collector.always = false;
      collector.condition = kNoOp;
      mapping_.ops.push_back(std::move(collector));
      unit_.collectors.push_back(static_cast<OpId>(mapping_.ops.size()) - 1);
    }
  }

  // Three bits an operation, the highest first; acc then is the word.
  void gather() {
    const auto count = static_cast<int>(source_.reads.size());
    const int places = (count + 2) / 3 * 3;
    for (int top = places - 1; top >= 0; top -= 3) {
      MappedOp op = make(Opcode::Get);
      op.action = -1;
      op.condition = kNoOp;
      op.always = top == places - 1;
      for (int i = 0; i < 3; ++i) {
        if (top - i >= count) continue;
        const logic::Read& read = source_.reads[static_cast<std::size_t>(top - i)];
        op.inputs[static_cast<std::size_t>(i)] = {BitValue::Kind::Device, read.device, read.version,
                                                  -1};
      }
      append(mapping_, unit_, std::move(op));
    }
    write_one(Opcode::Mva);
  }

  void indexed() {
    MappedOp index = make(Opcode::Ix);
    index.always = false;
    index.condition = kNoOp;
    index.action = -1;
    index.operands = {operand(0), constant(0)};
    index.head = source_.head;
    append(mapping_, unit_, std::move(index));
    MappedOp op = make(index_opcode());
    if (source_.op == Op::LoadWord || source_.op == Op::LoadBit) {
      op.reads = source_.reads;
      op.destination = target(0);
    } else {
      op.window = source_.targets;
      op.destination.kind = Destination::Kind::Window;
      op.destination.version = number_;
      if (source_.op == Op::StoreWord) op.operands = {constant(0), operand(1)};
    }
    append(mapping_, unit_, std::move(op));
  }

  Opcode index_opcode() const {
    switch (source_.op) {
      case Op::LoadWord:
        return Opcode::Mvx;
      case Op::LoadBit:
        return Opcode::Mvbx;
      case Op::StoreWord:
        return Opcode::Stx;
      case Op::SetBit:
        return Opcode::Setx;
      default:
        return Opcode::Rstx;
    }
  }

  Mapping& mapping_;
  Unit& unit_;
  const Action& source_;
  std::int32_t number_;
  OpId condition_;
  bool split_;
};

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

void append_action(Mapping& mapping, Unit& unit, const logic::Logic& logic, std::int32_t action,
                   OpId condition, bool split_muldiv) {
  ActionWriter(mapping, unit, logic, action, condition, split_muldiv).write();
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
