// SPDX-License-Identifier: Apache-2.0
#include "flowchart/rung_writer.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "rungs/special.hpp"
#include "rungs/structure.hpp"

namespace rung::flowchart {
namespace {

using Kind = Expression::Kind;

// 16 bits with wrap; nothing for a division by 0.
std::optional<int> fold(Kind kind, int a, int b) {
  const auto wrapped = [](int value) { return static_cast<std::int16_t>(value); };
  switch (kind) {
    case Kind::Add:
      return wrapped(a + b);
    case Kind::Sub:
      return wrapped(a - b);
    case Kind::Mul:
      return wrapped(a * b);
    case Kind::Div:
      if (b == 0) return std::nullopt;
      return wrapped(a / b);
    case Kind::Mod:
      if (b == 0) return std::nullopt;
      return wrapped(a % b);
    case Kind::And:
      return wrapped(a & b);
    case Kind::Or:
      return wrapped(a | b);
    case Kind::Xor:
      return wrapped(a ^ b);
    default:
      return std::nullopt;
  }
}

std::optional<int> constant_value(const Expression& expression) {
  if (expression.kind == Kind::Constant) return expression.value;
  if (!expression.a || !expression.b) return std::nullopt;
  const std::optional<int> a = constant_value(*expression.a);
  const std::optional<int> b = constant_value(*expression.b);
  return a && b ? fold(expression.kind, *a, *b) : std::nullopt;
}

Op op_of(Kind kind) {
  switch (kind) {
    case Kind::Add:
      return Op::Add;
    case Kind::Sub:
      return Op::Sub;
    case Kind::Mul:
      return Op::Mul;
    case Kind::And:
      return Op::Wand;
    case Kind::Or:
      return Op::Wor;
    case Kind::Xor:
      return Op::Wxor;
    default:
      return Op::Div;
  }
}

}  // namespace

Logic RungWriter::condition(const Expression& expression) {
  const SourcePosition position = expression.token.position;
  switch (expression.kind) {
    case Kind::Bit:
      return contact(expression.operand, false, position);
    case Kind::Fixed:
      return fixed(expression.value != 0);
    case Kind::Running:
      return contact(device_operand(task_turned(expression.task)), frame_.starts[expression.task],
                     position);
    case Kind::Failed: {
      Logic last =
          compare(device_operand(kStatus), Relation::NotEqual, constant_operand(0), position);
      if (!read_too_) return last;
      return any(contact(device_operand(read_failed(task_)), false, position), std::move(last));
    }
    case Kind::Not:
      return inverse(condition(*expression.a));
    case Kind::All:
    case Kind::Any: {
      Logic a = condition(*expression.a);
      Logic b = condition(*expression.b);
      return expression.kind == Kind::All ? all(std::move(a), std::move(b))
                                          : any(std::move(a), std::move(b));
    }
    default:
      break;
  }
  Logic valid = fixed(true);
  const Operand a = value(*expression.a, valid);
  const Operand b = value(*expression.b, valid);
  return all(compare(a, expression.relation, b, position), std::move(valid));
}

void RungWriter::outputs(const Logic& guard, std::vector<Instruction> instructions) {
  if (guard.is_fixed(false) || instructions.empty()) return;
  if (guard.kind != Logic::Kind::Fixed) {
    write_contacts(guard, instructions_);
    always_open_ = false;
  } else if (!always_open_) {
    instructions_.push_back(always(instructions.front().position));
    always_open_ = true;
  }
  for (Instruction& each : instructions) instructions_.push_back(std::move(each));
}

void RungWriter::assign_bit(const Operand& bit, const Logic& logic, SourcePosition position) {
  if (logic.kind == Logic::Kind::Fixed) {
    return outputs(fixed(true), {instruction(logic.value ? Op::Set : Op::Rst, {bit}, position)});
  }
  outputs(logic, {instruction(Op::Out, {bit}, position)});
}

void RungWriter::assign_word(const Operand& target, const Expression& expression,
                             const Logic& guard, SourcePosition position) {
  Logic valid = guard;
  if (constant_value(expression) || expression.kind == Kind::Word || expression.kind == Kind::Mod) {
    const Operand source = value(expression, valid);
    return outputs(valid, {instruction(Op::Mov, {source, target}, position)});
  }
  const Operand a = value(*expression.a, valid);
  const Operand b = value(*expression.b, valid);
  // A DIV by 0 writes nothing; it needs no guard.
  outputs(valid, {instruction(op_of(expression.kind), {a, b, target}, position)});
}

void RungWriter::start_or_stop(std::size_t task, bool start, const Logic& guard,
                               SourcePosition position) {
  const int number = static_cast<int>(task) + (start ? kStart : 0);
  std::vector<Instruction> both{
      instruction(Op::Mov, {constant_operand(number), device_operand(kTaskCommand)}, position)};
  if (frame_.asked[task]) both.push_back(turned(task, start, position));
  outputs(guard, std::move(both));
}

void RungWriter::go(std::int16_t step, const Logic& guard, SourcePosition position) {
  outputs(guard,
          {instruction(Op::Mov, {constant_operand(step), device_operand(kNextStep)}, position)});
}

void RungWriter::note_end(const Logic& guard, SourcePosition position) {
  if (frame_.asked[task_]) outputs(guard, {turned(task_, false, position)});
}

Instruction RungWriter::turned(std::size_t task, bool runs, SourcePosition position) const {
  const bool as_at_start = runs == frame_.starts[task];
  return instruction(as_at_start ? Op::Rst : Op::Set, {device_operand(task_turned(task))},
                     position);
}

Operand RungWriter::value(const Expression& expression, Logic& valid) {
  if (const auto constant = constant_value(expression)) return constant_operand(*constant);
  if (expression.kind == Kind::Word) return expression.operand;
  if (expression.kind == Kind::Mod) return remainder(expression, valid);
  const std::uint32_t before = words_;
  const Operand a = value(*expression.a, valid);
  const Operand b = value(*expression.b, valid);
  if (expression.kind == Kind::Div) narrow(b, valid, expression.b->token.position);
  // What its operands took is free again as its result is written, but for divisors, which are
  // looked at once more.
  if (valid.is_fixed(true)) words_ = before;
  const Operand result = device_operand(scratch_word());
  outputs(fixed(true),
          {instruction(op_of(expression.kind), {a, b, result}, expression.token.position)});
  return result;
}

Operand RungWriter::remainder(const Expression& expression, Logic& valid) {
  const Operand a = value(*expression.a, valid);
  const Operand b = value(*expression.b, valid);
  narrow(b, valid, expression.b->token.position);
  const Device quotient = scratch_word();
  const Device rest = scratch_word();
  Instruction divide =
      instruction(Op::Div, {a, b, device_operand(quotient)}, expression.token.position);
  divide.double_width = true;
  outputs(fixed(true), {std::move(divide)});
  return device_operand(rest);
}

void RungWriter::narrow(const Operand& divisor, Logic& valid, SourcePosition position) const {
  valid =
      all(std::move(valid), compare(divisor, Relation::NotEqual, constant_operand(0), position));
}

Instruction RungWriter::always(SourcePosition position) const {
  const std::vector<Device> on = devices_of_role(SpecialRole::On, frame_.dialect);
  if (on.empty()) return instruction(Op::Ldi, {device_operand(kNever)}, position);
  return instruction(Op::Ld, {device_operand(on.front())}, position);
}

Instruction RungWriter::instruction(Op op, std::vector<Operand> operands, SourcePosition position) {
  Instruction made;
  made.op = op;
  made.operands = std::move(operands);
  made.position = position;
  return made;
}

Program RungWriter::take() {
  Program program;
  program.file = frame_.file;
  program.dialect = frame_.dialect;
  program.instructions = std::move(instructions_);
  for (Instruction& each : program.instructions) {
    each.text = instruction_text(each, frame_.dialect);
  }
  program.networks = split_networks(program.instructions);
  return program;
}

}  // namespace rung::flowchart
