// SPDX-License-Identifier: Apache-2.0
#include "lower/wide.hpp"
#include "lower/words.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;

bool wide(const Context& context) { return context.source().width == 32; }

// Both words, or the one of a and the one of b, constants: the operation is worked out by hand.
bool all_constant(const Words& a, const Words& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].constant || !b[i].constant) return false;
  }
  return true;
}

std::int64_t number(const Words& words) {
  std::int64_t value = words.back().value;
  if (words.size() == 2) value = value * 65536 + static_cast<std::uint16_t>(words[0].value);
  return value;
}

Words words_of_number(std::int64_t value, int count) {
  Words words;
  for (int i = 0; i < count; ++i)
    words.push_back(constant(static_cast<std::int32_t>(value >> (16 * i) & 0xFFFF)));
  return words;
}

// A core instruction takes one constant: where both operands have one in the same word, the second
// goes through words of its own.
void separate(Context& context, const Words& a, Words& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].constant || !b[i].constant) continue;
    const Device device = context.temporary_word();
    context.always(Core::Mov, {device}, {b[i]});
    b[i] = word(device);
  }
}

std::vector<Device> temporaries(Context& context, int count) {
  std::vector<Device> devices;
  for (int i = 0; i < count; ++i) devices.push_back(context.temporary_word());
  return devices;
}

Words as_words(const std::vector<Device>& devices) {
  Words words;
  for (const Device device : devices) words.push_back(word(device));
  return words;
}

core::Instruction operation(Core op, const std::vector<Device>& targets, const Words& a,
                            const Words& b) {
  core::Instruction instruction;
  instruction.op = op;
  instruction.targets = targets;
  instruction.sources = a;
  instruction.sources.insert(instruction.sources.end(), b.begin(), b.end());
  return instruction;
}

// hidden words <- a +- b
Words sum(Context& context, bool subtract, const Words& a, Words b) {
  separate(context, a, b);
  const std::vector<Device> targets = temporaries(context, static_cast<int>(a.size()));
  const Core op =
      a.size() == 2 ? (subtract ? Core::Sub32 : Core::Add32) : (subtract ? Core::Sub : Core::Add);
  core::Instruction instruction = operation(op, targets, a, b);
  instruction.always = true;
  context.emit(std::move(instruction));
  return as_words(targets);
}

Device bit_15(Context& context, const WordSource& source) {
  const Device bit = context.temporary_bit();
  context.always(Core::Tb, {bit}, {source, constant(15)});
  return bit;
}

void set_flags(Context& context, const std::vector<Device>& flags, Device value) {
  for (const Device flag : flags) copy_bit(context, flag, value, true);
}

Device is_zero(Context& context, const Words& given) {
  const Words value = in_words(context, given);
  const Device low = context.temporary_bit();
  context.always(Core::Eq, {low}, {value[0], constant(0)});
  if (value.size() == 1) return low;
  const Device high = context.temporary_bit();
  context.always(Core::Eq, {high}, {value[1], constant(0)});
  const Device both = context.temporary_bit();
  context.compute(both, {{low, false}, {high, false}});
  return both;
}

struct Flags {
  std::vector<Device> zero, borrow, carry;
  bool any() const { return !zero.empty() || !borrow.empty() || !carry.empty(); }
};

Flags named_flags(const Context& context) {
  return {context.named_of_role(SpecialRole::Zero), context.named_of_role(SpecialRole::Borrow),
          context.dialect() == Dialect::Fx ? context.named_of_role(SpecialRole::Carry)
                                           : std::vector<Device>{}};
}

// The sum left the range where both operands had the sign that the result has not; of a difference
// the second operand counts with the opposite sign.
void sum_with_flags(Context& context, bool subtract, const Words& a, const Words& b,
                    const Flags& flags, const Place& to, const Requirements& requirements) {
  const Words result = sum(context, subtract, a, b);
  const WordSource first = combine(context, Core::Wxor, a.back(), result.back());
  const WordSource second = combine(context, Core::Wxor, subtract ? a.back() : b.back(),
                                    subtract ? b.back() : result.back());
  const Device left = bit_15(context, combine(context, Core::Wand, first, second));
  const Device negative = bit_15(context, result.back());
  const Device above = context.temporary_bit();
  const Device below = context.temporary_bit();
  context.compute(above, {{left, false}, {negative, false}});
  context.compute(below, {{left, false}, {negative, true}});
  const Device zero = is_zero(context, result);
  Execution execution(context, requirements);
  store(context, to, result);
  set_flags(context, flags.zero, zero);
  set_flags(context, flags.borrow, below);
  set_flags(context, flags.carry, above);
  execution.end();
}

void add_or_subtract(Context& context, bool subtract) {
  const Instruction& source = context.source();
  Requirements requirements;
  const Words a = read(context, source.operand(0), requirements.valid);
  Words b = read(context, source.operand(1), requirements.valid);
  const auto count = static_cast<int>(a.size());
  const Place to = place(context, source.operand(2), count, requirements.valid);
  const Flags flags = named_flags(context);
  if (flags.any() && context.dialect() == Dialect::Fx) {
    Words words = b;
    if (all_constant(a, b)) separate(context, a, words);
    return sum_with_flags(context, subtract, a, words, flags, to, requirements);
  }
  std::vector<Device> direct = direct_words(context, to, count);
  if (all_constant(a, b)) {
    const std::int64_t value = subtract ? number(a) - number(b) : number(a) + number(b);
    Execution execution(context, requirements);
    store(context, to, words_of_number(value, count));
    return execution.end();
  }
  if (direct.empty() || (count == 2 && (overwrites(direct[0], {a[1], b[1]})))) {
    const Words result = sum(context, subtract, a, b);
    Execution execution(context, requirements);
    store(context, to, result);
    return execution.end();
  }
  separate(context, a, b);
  const Core op =
      wide(context) ? (subtract ? Core::Sub32 : Core::Add32) : (subtract ? Core::Sub : Core::Add);
  Execution execution(context, requirements);
  context.emit(operation(op, direct, a, b));
  execution.end();
}

// INC, DEC, NEG: a +- b into the operand that one of them is.
void on_itself(Context& context, bool subtract, bool from_zero) {
  const Operand& target = context.source().operand(0);
  Requirements requirements;
  const Words value = read(context, target, requirements.valid);
  const auto count = static_cast<int>(value.size());
  const Place to = place(context, target, count, requirements.valid);
  const std::vector<Device> direct = direct_words(context, to, count);
  const Words other = words_of_number(from_zero ? 0 : 1, count);
  const Words& a = from_zero ? other : value;
  const Words& b = from_zero ? value : other;
  if (direct.empty()) {
    const Words result = sum(context, subtract, a, b);
    Execution execution(context, requirements);
    store(context, to, result);
    return execution.end();
  }
  const Core op =
      wide(context) ? (subtract ? Core::Sub32 : Core::Add32) : (subtract ? Core::Sub : Core::Add);
  Execution execution(context, requirements);
  context.emit(operation(op, direct, a, b));
  execution.end();
}

int result_words(const Instruction& source) {
  return source.width / 16 * (source.double_width ? 2 : 1);
}

// The result of two constants; none for a division by 0.
std::optional<Words> fold(const Instruction& source, const Words& a, const Words& b) {
  const std::int64_t x = number(a);
  const std::int64_t y = number(b);
  const int count = result_words(source);
  if (source.op == Op::Mul) {
    // The product of two 32-bit numbers fits 63 bits and a sign.
    return words_of_number(x * y, count);
  }
  if (y == 0) return std::nullopt;
  const int half = source.width / 16;
  Words words = words_of_number(x / y, half);
  if (count > half) {
    const Words rest = words_of_number(x % y, half);
    words.insert(words.end(), rest.begin(), rest.end());
  }
  return words;
}

void multiply_or_divide(Context& context) {
  const Instruction& source = context.source();
  const bool divide = source.op == Op::Div;
  Requirements requirements;
  const Words a = read(context, source.operand(0), requirements.valid);
  Words b = read(context, source.operand(1), requirements.valid);
  const int count = result_words(source);
  const Place to = place(context, source.operand(2), count, requirements.valid);
  if (all_constant(a, b)) {
    if (const auto result = fold(source, a, b)) {
      Execution execution(context, requirements);
      store(context, to, *result);
      return execution.end();
    }
  }
  // A constant divisor is 0 or is not; the one that is goes through words, to be found at fault.
  if (divide && all_constant(b, b) && number(b) == 0) b = in_words(context, b);
  separate(context, a, b);
  // The divider itself writes nothing when it divides by 0; others have to be told.
  const std::vector<Device> errors = context.named_of_role(SpecialRole::Error);
  std::vector<Device> targets = direct_words(context, to, count);
  const bool direct = !targets.empty();
  std::optional<Device> fault;
  if (divide && (!errors.empty() || !direct) && !all_constant(b, b)) fault = is_zero(context, b);
  const Core op =
      wide(context) ? (divide ? Core::Div32 : Core::Mul32) : (divide ? Core::Div : Core::Mul);
  if (!direct) targets = temporaries(context, count);
  Execution execution(context, requirements);
  context.emit(operation(op, targets, a, b));
  if (fault && !errors.empty()) {
    context.block(Core::Mps);
    context.contact(Core::And, *fault);
    for (const Device error : errors) context.coil(Core::Set, error, true);
    context.block(Core::Mpp);
  }
  if (!direct) {
    context.block(Core::Mps);
    if (fault) context.contact(Core::Ani, *fault);
    store(context, to, as_words(targets));
    context.block(Core::Mpp);
  }
  execution.end();
}

}  // namespace

bool lower_arithmetic(Context& context) {
  switch (context.source().op) {
    case Op::Add:
      add_or_subtract(context, false);
      return true;
    case Op::Sub:
      add_or_subtract(context, true);
      return true;
    case Op::Inc:
      on_itself(context, false, false);
      return true;
    case Op::Dec:
      on_itself(context, true, false);
      return true;
    case Op::Neg:
      on_itself(context, true, true);
      return true;
    case Op::Mul:
    case Op::Div:
      multiply_or_divide(context);
      return true;
    default:
      return false;
  }
}

}  // namespace rung::lower
