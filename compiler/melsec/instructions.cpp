// SPDX-License-Identifier: Apache-2.0
#include "melsec/instructions.hpp"

#include <algorithm>

namespace rung {
namespace {

constexpr DialectSet kPaper = dialect_bit(Dialect::Paper);
constexpr DialectSet kFx = dialect_bit(Dialect::Fx);
constexpr DialectSet kQ = dialect_bit(Dialect::Q);
constexpr DialectSet kAll = kPaper | kFx | kQ;

// The first row of an operation and dialect is the name that a list writer uses.
constexpr SourceInstruction kInstructions[] = {
    {"NOP", Op::Nop, OperandForm::None, kAll},
    {"LD", Op::Ld, OperandForm::Contact, kAll},
    {"LDI", Op::Ldi, OperandForm::Contact, kAll},
    {"AND", Op::And, OperandForm::Contact, kAll},
    {"ANI", Op::Ani, OperandForm::Contact, kAll},
    {"OR", Op::Or, OperandForm::Contact, kAll},
    {"ORI", Op::Ori, OperandForm::Contact, kAll},
    {"ANB", Op::Anb, OperandForm::None, kAll},
    {"ORB", Op::Orb, OperandForm::None, kAll},
    {"MPS", Op::Mps, OperandForm::None, kAll},
    {"MRD", Op::Mrd, OperandForm::None, kAll},
    {"MPP", Op::Mpp, OperandForm::None, kAll},
    {"OUT", Op::Out, OperandForm::Coil, kAll},
    {"SET", Op::Set, OperandForm::Coil, kAll},
    {"RST", Op::Rst, OperandForm::Reset, kAll},
    {"MV", Op::Mov, OperandForm::Move, kPaper},
    {"MOV", Op::Mov, OperandForm::Move, kAll},
    {"ADD", Op::Add, OperandForm::Arithmetic, kPaper | kFx},
    {"SUB", Op::Sub, OperandForm::Arithmetic, kPaper | kFx},
    {"MUL", Op::Mul, OperandForm::Arithmetic, kPaper | kFx},
    {"DIV", Op::Div, OperandForm::Arithmetic, kPaper | kFx},
    {"+", Op::Add, OperandForm::Arithmetic, kQ},
    {"-", Op::Sub, OperandForm::Arithmetic, kQ},
    {"*", Op::Mul, OperandForm::Arithmetic, kQ},
    {"/", Op::Div, OperandForm::Arithmetic, kQ},
};

}  // namespace

std::span<const SourceInstruction> source_instructions() { return kInstructions; }

const SourceInstruction* find_instruction(std::string_view name) {
  const auto* row = std::find_if(std::begin(kInstructions), std::end(kInstructions),
                                 [&](const SourceInstruction& i) { return i.name == name; });
  return row == std::end(kInstructions) ? nullptr : row;
}

std::string_view instruction_name(Op op, Dialect dialect) {
  return std::find_if(std::begin(kInstructions), std::end(kInstructions),
                      [&](const SourceInstruction& i) {
                        return i.op == op && (i.dialects & dialect_bit(dialect)) != 0;
                      })
      ->name;
}

OperandCount operand_count(OperandForm form, Dialect dialect) {
  switch (form) {
    case OperandForm::None:
      return {0, 0};
    case OperandForm::Contact:
    case OperandForm::Coil:
    case OperandForm::Reset:
      return {1, 1};
    case OperandForm::Move:
      return {2, 2};
    case OperandForm::Arithmetic:
      break;
  }
  return dialect == Dialect::Fx ? OperandCount{3, 3} : OperandCount{2, 3};
}

OperandCount operand_count(OperandForm form) { return operand_count(form, Dialect::Q); }

}  // namespace rung
