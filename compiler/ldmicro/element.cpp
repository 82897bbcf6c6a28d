// SPDX-License-Identifier: Apache-2.0
#include "ldmicro/element.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ldmicro/comment_text.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

enum class Form : std::uint8_t {
  Comment,
  Plain,
  Contacts,
  Coil,
  Timer,
  Counter,
  Variable,
  Move,
  Arithmetic,
  Compare,
  Other,
};

struct Row {
  std::string_view keyword;
  Op op;
  Form form;
  int operands;  // at least
  const char* usage;
  Relation relation = Relation::Equal;
};

constexpr Row kRows[] = {
    {"COMMENT", Op::Comment, Form::Comment, 0, ""},
    {"SHORT", Op::Short, Form::Plain, 0, "SHORT"},
    {"OPEN", Op::Open, Form::Plain, 0, "OPEN"},
    {"MASTER_RELAY", Op::MasterRelay, Form::Plain, 0, "MASTER_RELAY"},
    {"OSR", Op::Osr, Form::Plain, 0, "OSR"},
    {"OSF", Op::Osf, Form::Plain, 0, "OSF"},
    {"CONTACTS", Op::And, Form::Contacts, 2, "CONTACTS name negated"},
    {"COIL", Op::Out, Form::Coil, 4, "COIL name negated set reset"},
    {"TON", Op::Ton, Form::Timer, 2, "TON variable microseconds"},
    {"TOF", Op::Tof, Form::Timer, 2, "TOF variable microseconds"},
    {"RTO", Op::Rto, Form::Timer, 2, "RTO variable microseconds"},
    {"CTU", Op::Ctu, Form::Counter, 2, "CTU variable limit"},
    {"CTD", Op::Ctd, Form::Counter, 2, "CTD variable limit"},
    {"CTC", Op::Ctc, Form::Counter, 2, "CTC variable limit"},
    {"RES", Op::Res, Form::Variable, 1, "RES variable"},
    {"READ_ADC", Op::ReadAdc, Form::Variable, 1, "READ_ADC variable"},
    {"PERSIST", Op::Persist, Form::Variable, 1, "PERSIST variable"},
    {"UART_SEND", Op::UartSend, Form::Variable, 1, "UART_SEND variable"},
    {"UART_RECV", Op::UartRecv, Form::Variable, 1, "UART_RECV variable"},
    {"SET_PWM", Op::SetPwm, Form::Variable, 2, "SET_PWM variable hertz"},
    {"MOVE", Op::Mov, Form::Move, 2, "MOVE target source"},
    {"ADD", Op::Add, Form::Arithmetic, 3, "ADD target operand operand"},
    {"SUB", Op::Sub, Form::Arithmetic, 3, "SUB target operand operand"},
    {"MUL", Op::Mul, Form::Arithmetic, 3, "MUL target operand operand"},
    {"DIV", Op::Div, Form::Arithmetic, 3, "DIV target operand operand"},
    {"EQU", Op::AndCompare, Form::Compare, 2, "EQU operand operand", Relation::Equal},
    {"NEQ", Op::AndCompare, Form::Compare, 2, "NEQ operand operand", Relation::NotEqual},
    {"GRT", Op::AndCompare, Form::Compare, 2, "GRT operand operand", Relation::Greater},
    {"GEQ", Op::AndCompare, Form::Compare, 2, "GEQ operand operand", Relation::GreaterEqual},
    {"LES", Op::AndCompare, Form::Compare, 2, "LES operand operand", Relation::Less},
    {"LEQ", Op::AndCompare, Form::Compare, 2, "LEQ operand operand", Relation::LessEqual},
    {"SHIFT_REGISTER", Op::ShiftRegister, Form::Other, 2, "SHIFT_REGISTER name stages"},
    {"LOOK_UP_TABLE", Op::LookUpTable, Form::Other, 4,
     "LOOK_UP_TABLE target index count shown_as_string value ..."},
    {"PIECEWISE_LINEAR", Op::PiecewiseLinear, Form::Other, 3,
     "PIECEWISE_LINEAR target index count x y x y ..."},
    {"FORMATTED_STRING", Op::FormattedString, Form::Other, 1,
     "FORMATTED_STRING variable count code ..., or (none) for the variable"},
};

Operand constant(std::int64_t value, Operand::Kind kind = Operand::Kind::Constant) {
  Operand operand;
  operand.kind = kind;
  operand.value = static_cast<std::int32_t>(value);
  return operand;
}

void read_comment(const LdElement& element, Instruction& instruction) {
  constexpr std::size_t kText = 8;  // behind "COMMENT "
  const std::string& raw = element.line().raw;
  instruction.note = raw.size() > kText ? ld_note(raw.substr(kText)) : "";
}

Op coil_op(bool negated, bool set, bool reset) {
  return negated ? Op::Outi : set ? Op::Set : reset ? Op::Rst : Op::Out;
}

void read_coil(LdElement& element, Instruction& instruction) {
  const SourcePosition position = element.peek().position;
  instruction.operands = {element.bit()};
  const bool negated = element.flag() != 0;
  const bool set = element.flag() != 0;
  const bool reset = element.flag() != 0;
  instruction.op = coil_op(negated, set, reset);
  if (element.good() && instruction.operand(0).device.kind == DeviceKind::X) {
    element.refuse(position, "COIL on an input: names with X are what comes from outside",
                   "give the relay a name with another letter, R for instance");
  }
}

// The delay in scans as LDmicro 2.3 counts it.
void read_timer(LdElement& element, Instruction& instruction) {
  const std::int64_t cycle = element.context().header.settings.cycle_us;
  instruction.operands = {element.variable()};
  const SourcePosition position = element.peek().position;
  instruction.base_us = element.whole_number();
  if (!element.good()) return;
  const std::int64_t scans = instruction.base_us / cycle - 1;
  if (scans < 1) {
    element.refuse(
        position,
        fmt::format("{}: {} us is too short for a CYCLE of {} us", instruction.text,
                    instruction.base_us, cycle),
        fmt::format("a delay is at least two cycles: {} us, or a shorter CYCLE", 2 * cycle));
  } else if (scans > INT16_MAX) {
    element.refuse(position,
                   fmt::format("{}: {} us is too long for a CYCLE of {} us: the variable counts "
                               "16 bits",
                               instruction.text, instruction.base_us, cycle),
                   fmt::format("at most {} us, or a longer CYCLE, or a counter behind the timer",
                               (INT16_MAX + 2LL) * cycle - 1));
  }
  instruction.operands.push_back(constant(std::clamp<std::int64_t>(scans, 0, INT16_MAX)));
}

void number_channel(LdElement& element, Instruction& instruction, const LdWord& name) {
  LdContext& context = element.context();
  const Device channel = context.symbols.channel(name.text);
  const int number = static_cast<int>(channel.number - port::adc.number);
  if (number >= port::adc_count) {
    element.refuse(name.position,
                   fmt::format("READ_ADC {}: one analogue channel more than the {} that there are",
                               shown(name.text), port::adc_count),
                   "read the channels that are left into the variables that have one");
  }
  instruction.operands.push_back(constant(number, Operand::Kind::Number));
}

void number_kept(LdElement& element, Instruction& instruction) {
  const int number = element.context().kept++;
  if (number >= port::persist_value_count) {
    element.refuse(element.line().position(),
                   fmt::format("PERSIST {}: the lasting memory keeps {} values", number + 1,
                               port::persist_value_count),
                   "keep fewer variables");
  }
  instruction.operands.push_back(constant(number, Operand::Kind::Number));
}

void read_variable(LdElement& element, Instruction& instruction) {
  const LdWord& name = element.peek();
  instruction.operands = {element.variable()};
  if (!element.good()) return;
  if (instruction.op == Op::ReadAdc) number_channel(element, instruction, name);
  if (instruction.op == Op::Persist) number_kept(element, instruction);
  if (instruction.op != Op::SetPwm) return;
  const SourcePosition position = element.peek().position;
  const std::int64_t hertz = element.whole_number();
  if (element.good() && hertz < 1) {
    element.refuse(position, fmt::format("SET_PWM: a frequency of {} Hz", hertz),
                   "write 1 Hz or more");
  }
  instruction.operands.push_back(constant(hertz));
}

void read_form(Form form, LdElement& element, Instruction& instruction) {
  switch (form) {
    case Form::Comment:
      return read_comment(element, instruction);
    case Form::Plain:
    case Form::Other:
      return;
    case Form::Contacts:
      instruction.operands = {element.bit()};
      if (element.flag() != 0) instruction.op = Op::Ani;
      return;
    case Form::Coil:
      return read_coil(element, instruction);
    case Form::Timer:
      return read_timer(element, instruction);
    case Form::Counter:
      instruction.operands = {element.variable()};
      instruction.operands.push_back(constant(element.number16("the limit of a counter")));
      return;
    case Form::Variable:
      return read_variable(element, instruction);
    case Form::Move: {
      const Operand target = element.variable();
      instruction.operands = {element.variable_or_number(), target};
      return;
    }
    case Form::Arithmetic: {
      const Operand target = element.variable();
      const Operand left = element.variable_or_number();
      instruction.operands = {left, element.variable_or_number(), target};
      return;
    }
    case Form::Compare: {
      const Operand left = element.variable_or_number();
      instruction.operands = {left, element.variable_or_number()};
      return;
    }
  }
}

void read_other(LdElement& element, Instruction& instruction) {
  switch (instruction.op) {
    case Op::ShiftRegister:
      return read_shift_register(element, instruction);
    case Op::LookUpTable:
      return read_look_up_table(element, instruction);
    case Op::PiecewiseLinear:
      return read_piecewise_linear(element, instruction);
    default:
      return read_formatted_string(element, instruction);
  }
}

}  // namespace

std::optional<Instruction> read_ld_element(const LdLine& line, LdContext& context) {
  const auto* const row = std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& each) {
    return each.keyword == line.keyword();
  });
  if (row == std::end(kRows)) {
    refuse_ld_keyword(line, context);
    return std::nullopt;
  }
  Instruction instruction;
  instruction.op = row->op;
  instruction.relation = row->relation;
  instruction.position = line.position();
  instruction.text = line.text();
  LdElement element(line, context);
  const int missing = row->operands - static_cast<int>(element.left());
  if (missing > 0) {
    element.refuse(line.position(),
                   fmt::format("{}: {} of its operands {} missing", row->keyword, missing,
                               missing == 1 ? "is" : "are"),
                   fmt::format("write: {}", row->usage));
    return std::nullopt;
  }
  if (row->form == Form::Other) {
    read_other(element, instruction);
  } else {
    read_form(row->form, element, instruction);
  }
  if (element.good()) check_ld_tail(element, row->op);
  if (!element.good()) return std::nullopt;
  return instruction;
}

}  // namespace rung
