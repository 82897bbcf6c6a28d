// SPDX-License-Identifier: Apache-2.0
// Which operand may stand where (compiler/SEMANTICS.md).
#include <fmt/format.h>

#include "melsec/operands.hpp"
#include "rungs/devices.hpp"
#include "rungs/special.hpp"

namespace rung {
namespace {

using Kind = Operand::Kind;

bool is_index_register(DeviceKind kind) { return kind == DeviceKind::V || kind == DeviceKind::Z; }

bool is_written(Role role) {
  switch (role) {
    case Role::Coil:
    case Role::Reset:
    case Role::Bit:
    case Role::TargetBits:
    case Role::State:
    case Role::Timer:
    case Role::Counter:
    case Role::Target:
    case Role::WordTarget:
    case Role::TargetBlock:
    case Role::TargetWords:
    case Role::First:
    case Role::Last:
      return true;
    default:
      return false;
  }
}

bool is_word_role(Role role) { return role >= Role::Preset && role <= Role::TargetWords; }
bool takes_constant(Role role) {
  return role == Role::Source || role == Role::Preset || role == Role::Count ||
         role == Role::Repeats;
}
bool takes_digits(Role role) {
  return role == Role::Source || role == Role::Target || role == Role::SourceBlock ||
         role == Role::TargetBlock;
}
bool takes_word_bit(Role role) {
  return role == Role::Contact || role == Role::Edge || role == Role::Coil || role == Role::Reset;
}
bool takes_index(Role role) {
  return role == Role::Contact || role == Role::Coil || role == Role::Reset ||
         role == Role::Source || role == Role::Target || role == Role::WordTarget;
}
// One of a row: its neighbours belong to it.
bool is_row(Role role) {
  return role == Role::SourceBits || role == Role::TargetBits || role == Role::First ||
         role == Role::Last;
}

std::string_view examples(Role role) {
  switch (role) {
    case Role::State:
      return "name a state (S)";
    case Role::Timer:
    case Role::Counter:
      return "name a timer (T) or counter (C)";
    case Role::Contact:
    case Role::Edge:
    case Role::SourceBits:
      return "name an X, Y or M";
    case Role::Source:
    case Role::Preset:
      return "name a D, or a constant such as K10";
    case Role::SourceBlock:
    case Role::SourceWords:
    case Role::TargetWords:
    case Role::TargetBlock:
      return "name a D";
    case Role::Target:
    case Role::WordTarget:
      return "this operand is a target: name a D";
    case Role::First:
    case Role::Last:
      return "name a Y, M, D, T or C";
    case Role::Pointer:
      return "name a pointer such as P10";
    case Role::Level:
      return "name a nesting level, N0 to N7";
    case Role::Count:
    case Role::Repeats:
      return "write a constant such as K4";
    default:
      return "name a Y or M";
  }
}

}  // namespace

std::optional<Operand> OperandReader::read(const ListWord& word, Role role, int width) {
  std::optional<Operand> operand = parse(word, width);
  if (!operand || !fits(word, *operand, role, width)) return std::nullopt;
  if (is_word_role(role) && operand->kind == Kind::Device) {
    operand->device = value_of(operand->device);
  }
  if ((role == Role::Timer || role == Role::Counter || role == Role::Reset || is_row(role)) &&
      operand->kind == Kind::Device) {
    operand->device = contact_of(operand->device);
  }
  return operand;
}

bool OperandReader::fits(const ListWord& word, const Operand& operand, Role role, int width) {
  const std::string mend(examples(role));
  if (role == Role::Pointer || role == Role::Level) {
    const char letter = role == Role::Pointer ? 'P' : 'N';
    if (operand.kind == Kind::Number && word.upper.front() == letter) return true;
    error(word, role == Role::Pointer ? "not a pointer" : "not a nesting level", mend);
    return false;
  }
  switch (operand.kind) {
    case Kind::Number:
      error(word, "a pointer or nesting level, which has no value", mend);
      return false;
    case Kind::Constant:
      if (takes_constant(role)) return true;
      error(word,
            is_written(role)     ? "a constant cannot be written"
            : is_word_role(role) ? "a constant where words are read"
                                 : "a constant where a bit is read",
            mend);
      return false;
    default:
      break;
  }
  if (role == Role::Count) {
    error(word, "a count that only the run shows: a constant scan needs a constant", mend);
    return false;
  }
  if (role == Role::Repeats) {
    error(word, "a loop whose count only the run shows: a constant scan needs a constant", mend);
    return false;
  }
  if (is_written(role) && operand.device.kind == DeviceKind::X && operand.kind != Kind::WordBit) {
    error(word, "an input, and inputs cannot be written", mend);
    return false;
  }
  if (const SpecialRange* special = find_special(operand.device, dialect_)) {
    if (is_written(role) && is_driven(special->role)) {
      error(word, "driven by the controller and cannot be written", mend);
      return false;
    }
    if (is_row(role) || operand.kind == Kind::Digits || operand.index) {
      error(word, "a special relay, whose neighbours mean other things",
            "name it where one bit is read or written");
      return false;
    }
  }
  if (!fits_index(word, operand, role)) return false;
  Operand value = operand;
  return is_word_role(role) ? fits_word(word, value, role, width) : fits_bit(word, operand, role);
}

bool OperandReader::fits_index(const ListWord& word, const Operand& operand, Role role) {
  if (!operand.index) return true;
  const DeviceKind kind = operand.device.kind;
  if (!takes_index(role)) {
    error(word, "an index is not supported here",
          "index the contacts LD, AND, OR and their inverses, OUT, SET, RST, or a word that stands "
          "for itself");
    return false;
  }
  const bool state = kind == DeviceKind::S && is_written(role);
  if (is_timer(kind) || is_counter(kind) || is_index_register(kind) || state) {
    error(word, fmt::format("{} with an index, which is not supported", kind_name(kind)),
          "index a D, X, Y or M");
    return false;
  }
  return true;
}

bool OperandReader::fits_bit(const ListWord& word, const Operand& operand, Role role) {
  const DeviceKind kind = operand.device.kind;
  const std::string mend(examples(role));
  const bool timer = is_timer(kind) || is_counter(kind);
  if (operand.kind == Kind::WordBit) {
    if (takes_word_bit(role)) return true;
    error(word, "a bit of a word, which is not supported here", mend);
    return false;
  }
  if (operand.kind == Kind::Digits) {
    error(word, "a digit group where a bit is named", mend);
    return false;
  }
  switch (role) {
    case Role::State:
      if (kind == DeviceKind::S) return true;
      error(word, fmt::format("{}, not a state", kind_name(kind)), mend);
      return false;
    case Role::Timer:
    case Role::Counter:
      if (!is_word(kind) && (role == Role::Timer ? is_timer(kind) : is_counter(kind))) return true;
      error(word, fmt::format("{}, not a timer or counter", kind_name(kind)), mend);
      return false;
    case Role::Reset:
      return true;
    case Role::First:
    case Role::Last:
      if (!is_index_register(kind)) return true;
      error(word, "an index register, which is reset one by one", "use RST");
      return false;
    default:
      break;
  }
  if (is_word(kind)) {
    error(word, fmt::format("a word where a bit is {}", is_written(role) ? "written" : "read"),
          is_written(role) ? fmt::format("{}; a word is written by {}", mend,
                                         dialect_ == Dialect::Paper ? "MV" : "MOV")
                           : mend);
    return false;
  }
  if (timer && (is_written(role) || role == Role::SourceBits)) {
    error(word, fmt::format("{}, which only OUT and RST name", kind_name(kind)), mend);
    return false;
  }
  return true;
}

bool OperandReader::fits_word(const ListWord& word, Operand& operand, Role role, int width) {
  const std::string mend(examples(role));
  if (operand.kind == Kind::WordBit) {
    error(word, "a bit where a word is named", mend);
    return false;
  }
  if (operand.kind == Kind::Digits) {
    if (!takes_digits(role)) {
      error(word, "a digit group, which is not supported here", mend);
      return false;
    }
    const DeviceKind kind = operand.device.kind;
    if (is_word(kind) || is_timer(kind) || is_counter(kind)) {
      error(word, fmt::format("a digit group of {}", kind_name(kind)),
            "groups are taken of X, Y, M and the like: K4M0");
      return false;
    }
    if (operand.digits < 1 || operand.digits > width / 4) {
      error(word, fmt::format("a word of {} bits takes 1 to {} groups of four", width, width / 4),
            fmt::format("write K1 to K{} before the device", width / 4));
      return false;
    }
    return true;
  }
  const Device device = value_of(operand.device);
  if (!is_word(device)) {
    error(word,
          fmt::format("{} where a word is {}", kind_name(device.kind),
                      is_written(role) ? "written" : "read"),
          mend);
    return false;
  }
  const bool row = role >= Role::SourceBlock && role <= Role::TargetWords;
  const bool wide_counter = is_32_bit_counter(device, dialect_);
  if (wide_counter && (width != 32 || row)) {
    error(word, "a counter of 32 bits where 16 are taken", "use a 32-bit instruction (D form)");
    return false;
  }
  if (is_index_register(device.kind) && (width == 32 || row || role == Role::WordTarget)) {
    error(word, "an index register has 16 bits and stands for itself", mend);
    return false;
  }
  return true;
}

}  // namespace rung
