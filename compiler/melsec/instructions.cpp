// SPDX-License-Identifier: Apache-2.0
#include "melsec/instructions.hpp"

#include <algorithm>
#include <map>

#include "rungs/devices.hpp"

namespace rung {
namespace {

using enum Role;

constexpr DialectSet kPaper = dialect_bit(Dialect::Paper);
constexpr DialectSet kOnlyFx = dialect_bit(Dialect::Fx);
constexpr DialectSet kQ = dialect_bit(Dialect::Q);
constexpr DialectSet kFx = kPaper | kOnlyFx;
constexpr DialectSet kAll = kFx | kQ;

constexpr std::uint8_t kP = kPulseForm;
constexpr std::uint8_t kDP = kWideForm | kPulseForm;
constexpr std::uint8_t kTwoDP = kDP | kTwoOperands;

// The first row of an operation, width and dialect is the name that a list writer uses. paper has
// what fx has, on its own few devices. q has what a QnU or an iQ-R has.
constexpr SourceInstruction kInstructions[] = {
    {"NOP", Op::Nop, {}, kAll},
    {"LD", Op::Ld, {Contact}, kAll},
    {"LDI", Op::Ldi, {Contact}, kAll},
    {"AND", Op::And, {Contact}, kAll},
    {"ANI", Op::Ani, {Contact}, kAll},
    {"OR", Op::Or, {Contact}, kAll},
    {"ORI", Op::Ori, {Contact}, kAll},
    {"LDP", Op::LdP, {Edge}, kAll},
    {"LDF", Op::LdF, {Edge}, kAll},
    {"ANDP", Op::AndP, {Edge}, kAll},
    {"ANDF", Op::AndF, {Edge}, kAll},
    {"ORP", Op::OrP, {Edge}, kAll},
    {"ORF", Op::OrF, {Edge}, kAll},
    {"LD=", Op::LdCompare, {Source, Source}, kAll, kWideForm, Relation::Equal},
    {"LD<>", Op::LdCompare, {Source, Source}, kAll, kWideForm, Relation::NotEqual},
    {"LD<", Op::LdCompare, {Source, Source}, kAll, kWideForm, Relation::Less},
    {"LD>", Op::LdCompare, {Source, Source}, kAll, kWideForm, Relation::Greater},
    {"LD<=", Op::LdCompare, {Source, Source}, kAll, kWideForm, Relation::LessEqual},
    {"LD>=", Op::LdCompare, {Source, Source}, kAll, kWideForm, Relation::GreaterEqual},
    {"AND=", Op::AndCompare, {Source, Source}, kAll, kWideForm, Relation::Equal},
    {"AND<>", Op::AndCompare, {Source, Source}, kAll, kWideForm, Relation::NotEqual},
    {"AND<", Op::AndCompare, {Source, Source}, kAll, kWideForm, Relation::Less},
    {"AND>", Op::AndCompare, {Source, Source}, kAll, kWideForm, Relation::Greater},
    {"AND<=", Op::AndCompare, {Source, Source}, kAll, kWideForm, Relation::LessEqual},
    {"AND>=", Op::AndCompare, {Source, Source}, kAll, kWideForm, Relation::GreaterEqual},
    {"OR=", Op::OrCompare, {Source, Source}, kAll, kWideForm, Relation::Equal},
    {"OR<>", Op::OrCompare, {Source, Source}, kAll, kWideForm, Relation::NotEqual},
    {"OR<", Op::OrCompare, {Source, Source}, kAll, kWideForm, Relation::Less},
    {"OR>", Op::OrCompare, {Source, Source}, kAll, kWideForm, Relation::Greater},
    {"OR<=", Op::OrCompare, {Source, Source}, kAll, kWideForm, Relation::LessEqual},
    {"OR>=", Op::OrCompare, {Source, Source}, kAll, kWideForm, Relation::GreaterEqual},
    {"ANB", Op::Anb, {}, kAll},
    {"ORB", Op::Orb, {}, kAll},
    {"INV", Op::Inv, {}, kAll},
    {"MEP", Op::Mep, {}, kAll},
    {"MEF", Op::Mef, {}, kAll},
    {"MPS", Op::Mps, {}, kAll},
    {"MRD", Op::Mrd, {}, kAll},
    {"MPP", Op::Mpp, {}, kAll},
    {"MC", Op::Mc, {Level, Bit}, kAll},
    {"MCR", Op::Mcr, {Level}, kAll},
    {"STL", Op::Stl, {State}, kOnlyFx},
    {"RET", Op::Ret, {}, kOnlyFx},
    {"OUT", Op::Out, {Coil}, kAll},
    {"OUT", Op::OutT, {Timer, Preset}, kOnlyFx | kQ},
    {"OUT", Op::OutC, {Counter, Preset}, kOnlyFx | kQ},
    {kHighSpeedTimer, Op::OutT, {Timer, Preset}, kQ},
    {"OUTI", Op::Outi, {Coil}, kAll},
    {"SET", Op::Set, {Coil}, kAll},
    {"RST", Op::Rst, {Reset}, kAll},
    {"PLS", Op::Pls, {Bit}, kAll},
    {"PLF", Op::Plf, {Bit}, kAll},
    {"ALT", Op::Alt, {Bit}, kAll, kP},
    {"FF", Op::Alt, {Bit}, kAll, kOnlyPulse},
    {"SFT", Op::Sft, {Bit}, kQ, kP},
    {"SFTL", Op::Sftl, {SourceBits, TargetBits, Count, Count}, kAll, kP},
    {"SFTR", Op::Sftr, {SourceBits, TargetBits, Count, Count}, kAll, kP},
    {"BSFL", Op::Bsfl, {TargetBits, Count}, kQ, kP},
    {"BSFR", Op::Bsfr, {TargetBits, Count}, kQ, kP},
    {"MV", Op::Mov, {Source, Target}, kPaper, kDP},
    {"MOV", Op::Mov, {Source, Target}, kAll, kDP},
    {"CML", Op::Cml, {Source, Target}, kAll, kDP},
    {"BCD", Op::Bcd, {Source, Target}, kAll, kDP},
    {"BIN", Op::Bin, {Source, Target}, kAll, kDP},
    {"XCH", Op::Xch, {Target, Target}, kAll, kDP},
    {"SWAP", Op::Swap, {Target}, kAll, kDP},
    {"BMOV", Op::Bmov, {SourceBlock, TargetBlock, Count}, kAll, kP},
    {"FMOV", Op::Fmov, {Source, TargetBlock, Count}, kAll, kDP},
    {"ADD", Op::Add, {Source, Source, Target}, kFx, kTwoDP},
    {"SUB", Op::Sub, {Source, Source, Target}, kFx, kTwoDP},
    {"MUL", Op::Mul, {Source, Source, WordTarget}, kFx, kTwoDP},
    {"DIV", Op::Div, {Source, Source, WordTarget}, kFx, kTwoDP},
    {"+", Op::Add, {Source, Source, Target}, kQ, kTwoDP},
    {"-", Op::Sub, {Source, Source, Target}, kQ, kTwoDP},
    {"*", Op::Mul, {Source, Source, WordTarget}, kQ, kTwoDP},
    {"/", Op::Div, {Source, Source, WordTarget}, kQ, kTwoDP},
    // The makers drop the W in the 32-bit names.
    {"DAND", Op::Wand, {Source, Source, Target}, kAll, kOnlyWide | kP | kTwoOperands},
    {"DOR", Op::Wor, {Source, Source, Target}, kAll, kOnlyWide | kP | kTwoOperands},
    {"DXOR", Op::Wxor, {Source, Source, Target}, kAll, kOnlyWide | kP | kTwoOperands},
    {"DXNR", Op::Wxnr, {Source, Source, Target}, kQ, kOnlyWide | kP | kTwoOperands},
    {"WAND", Op::Wand, {Source, Source, Target}, kAll, kTwoDP},
    {"WOR", Op::Wor, {Source, Source, Target}, kAll, kTwoDP},
    {"WXOR", Op::Wxor, {Source, Source, Target}, kAll, kTwoDP},
    {"WXNR", Op::Wxnr, {Source, Source, Target}, kQ, kTwoDP},
    {"INC", Op::Inc, {Target}, kAll, kDP},
    {"DEC", Op::Dec, {Target}, kAll, kDP},
    {"NEG", Op::Neg, {Target}, kAll, kDP},
    {"ROL", Op::Rol, {Target, Count}, kAll, kDP},
    {"ROR", Op::Ror, {Target, Count}, kAll, kDP},
    // Without a carry relay, as in paper, there is nothing to rotate through.
    {"RCL", Op::Rcl, {Target, Count}, kOnlyFx | kQ, kDP},
    {"RCR", Op::Rcr, {Target, Count}, kOnlyFx | kQ, kDP},
    {"SFL", Op::Sfl, {Target, Count}, kAll, kP},
    {"SFR", Op::Sfr, {Target, Count}, kAll, kP},
    {"WSFL", Op::Wsfl, {SourceWords, TargetWords, Count, Count}, kAll, kP},
    {"WSFR", Op::Wsfr, {SourceWords, TargetWords, Count, Count}, kAll, kP},
    {"DSFL", Op::Dsfl, {TargetWords, Count}, kQ, kP},
    {"DSFR", Op::Dsfr, {TargetWords, Count}, kQ, kP},
    {"CMP", Op::Cmp, {Source, Source, TargetBits}, kAll, kDP},
    {"ZCP", Op::Zcp, {Source, Source, Source, TargetBits}, kAll, kDP},
    {"ZRST", Op::Zrst, {First, Last}, kAll, kP},
    {"CJ", Op::Cj, {Pointer}, kAll, kP},
    {"CALL", Op::Call, {Pointer}, kAll, kP},
    {"SRET", Op::Sret, {}, kAll},
    {"RET", Op::Sret, {}, kQ},
    {"FEND", Op::Fend, {}, kAll},
    {"FOR", Op::For, {Repeats}, kAll},
    {"NEXT", Op::Next, {}, kAll},
};

bool is_compare(Op op) {
  return op == Op::LdCompare || op == Op::AndCompare || op == Op::OrCompare;
}

std::string form_name(const InstructionForm& form) {
  std::string name(form.row->name);
  if (form.width == 32 && form.row->has(kWideForm)) {
    // LDD= has the D before the sign.
    name.insert(is_compare(form.row->op) ? name.find_first_of("=<>") : 0, "D");
  }
  if (form.pulse && form.row->has(kPulseForm)) name += 'P';
  return name;
}

// True for a timer that counts faster than its device does by itself.
bool is_high_speed(const Instruction& timer, Dialect dialect) {
  return !timer.operands.empty() && is_timer(timer.operand(0).device.kind) &&
         timer.base_us < timer_range(contact_of(timer.operand(0).device), dialect).base_us;
}

// Every form of every row, by its name.
using NameTable = std::map<std::string, std::vector<InstructionForm>, std::less<>>;
const NameTable& name_table() {
  static const NameTable table = [] {
    NameTable names;
    const auto add = [&](const InstructionForm& form) { names[form_name(form)].push_back(form); };
    for (const SourceInstruction& row : kInstructions) {
      for (const int width : {16, 32}) {
        if (width == 16 ? row.has(kOnlyWide) : !row.has(kOnlyWide) && !row.has(kWideForm)) continue;
        if (!row.has(kOnlyPulse)) add({&row, width, false});
        if (row.has(kPulseForm) || row.has(kOnlyPulse)) add({&row, width, true});
      }
    }
    return names;
  }();
  return table;
}

bool is_form_of(const InstructionForm& form, const Instruction& instruction, Dialect dialect) {
  const SourceInstruction& row = *form.row;
  const int width = instruction.op == Op::OutC ? 16 : instruction.width;
  if (row.op == Op::OutT && (row.name == kHighSpeedTimer) != is_high_speed(instruction, dialect)) {
    return false;
  }
  return row.op == instruction.op && (row.dialects & dialect_bit(dialect)) != 0 &&
         form.width == width && form.pulse == instruction.pulse &&
         (!is_compare(row.op) || row.relation == instruction.relation);
}

}  // namespace

int SourceInstruction::operands() const {
  return static_cast<int>(std::find(roles.begin(), roles.end(), Role::None) - roles.begin());
}

std::span<const SourceInstruction> source_instructions() { return kInstructions; }

std::span<const InstructionForm> find_instruction(std::string_view name) {
  const auto found = name_table().find(name);
  if (found == name_table().end()) return {};
  return found->second;
}

std::vector<std::string_view> instruction_names() {
  std::vector<std::string_view> names;
  const auto add = [&](std::string_view name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const SourceInstruction& row : kInstructions) add(row.name);
  for (const auto& [name, forms] : name_table()) add(name);
  return names;
}

std::string_view instruction_name(const Instruction& instruction, Dialect dialect) {
  // Of the names that fit, the one of the first row.
  const SourceInstruction* first = nullptr;
  std::string_view found;
  for (const auto& [name, forms] : name_table()) {
    for (const InstructionForm& form : forms) {
      if (is_form_of(form, instruction, dialect) && (first == nullptr || form.row < first)) {
        first = form.row;
        found = name;
      }
    }
  }
  return found;
}

std::string_view instruction_name(Op op, Dialect dialect) {
  Instruction plain;
  plain.op = op;
  return instruction_name(plain, dialect);
}

OperandCount operand_count(const SourceInstruction& row, Dialect dialect) {
  const int all = row.operands();
  return {row.has(kTwoOperands) && dialect != Dialect::Fx ? 2 : all, all};
}

OperandCount operand_count(std::span<const InstructionForm> forms) {
  OperandCount count{9, 0};
  for (const InstructionForm& form : forms) {
    const OperandCount each = operand_count(*form.row, Dialect::Q);
    count = {std::min(count.least, each.least), std::max(count.most, each.most)};
  }
  return count;
}

CountRange count_range(Op op, int width, Dialect dialect) {
  const bool q = dialect == Dialect::Q;
  switch (op) {
    case Op::Rol:
    case Op::Ror:
    case Op::Rcl:
    case Op::Rcr:
      return {0, q ? width - 1 : width};
    case Op::Sfl:
    case Op::Sfr:
      return {0, 15};
    case Op::Sftl:
    case Op::Sftr:
      return {1, 1024};
    case Op::Bsfl:
    case Op::Bsfr:
    case Op::Dsfl:
    case Op::Dsfr:
      return {1, INT16_MAX};
    default:
      return {1, q ? INT16_MAX : 512};
  }
}

}  // namespace rung
