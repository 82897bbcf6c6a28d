// SPDX-License-Identifier: Apache-2.0
#include "lower/wide.hpp"
#include "lower/words.hpp"

namespace rung::lower {
namespace {

using Core = core::Op;

// Bits 0 to n-1.
int low_mask(int n) { return (1 << n) - 1; }

WordSource rotate(Context& context, const WordSource& value, int n) {
  return combine(context, Core::Rol, value, constant(n & 15));
}

WordSource masked(Context& context, const WordSource& value, int mask) {
  return combine(context, Core::Wand, value, constant(mask));
}

// value << n, 0 <= n <= 16 per word; of two words the bits that leave the lower enter the upper.
Words shift_left(Context& context, const Words& value, int n) {
  if (n == 0) return value;
  if (value.size() == 1) {
    if (n >= 16) return {constant(0)};
    return {masked(context, rotate(context, value[0], n), ~low_mask(n))};
  }
  if (n >= 32) return {constant(0), constant(0)};
  if (n >= 16) return {constant(0), shift_left(context, {value[0]}, n - 16)[0]};
  const WordSource low = rotate(context, value[0], n);
  const WordSource high = rotate(context, value[1], n);
  return {masked(context, low, ~low_mask(n)),
          combine(context, Core::Wor, masked(context, high, ~low_mask(n)),
                  masked(context, low, low_mask(n)))};
}

// value >> n, 0 moving in.
Words shift_right(Context& context, const Words& value, int n) {
  if (n == 0) return value;
  if (value.size() == 1) {
    if (n >= 16) return {constant(0)};
    return {masked(context, rotate(context, value[0], 16 - n), low_mask(16 - n))};
  }
  if (n >= 32) return {constant(0), constant(0)};
  if (n >= 16) return {shift_right(context, {value[1]}, n - 16)[0], constant(0)};
  const int keep = low_mask(16 - n);
  const WordSource low = rotate(context, value[0], 16 - n);
  const WordSource high = rotate(context, value[1], 16 - n);
  return {combine(context, Core::Wor, masked(context, low, keep), masked(context, high, ~keep)),
          masked(context, high, keep)};
}

Device bit_of(Context& context, const Words& value, int n) {
  const Device bit = context.temporary_bit();
  const Words source = in_words(context, {value[static_cast<std::size_t>(n / 16)]});
  context.always(Core::Tb, {bit}, {source[0], constant(n % 16)});
  return bit;
}

// The relays of carry <- `left`, or 0, under the current result.
void set_carry(Context& context, const std::vector<Device>& relays, std::optional<Device> left) {
  for (const Device relay : relays) {
    if (left) {
      copy_bit(context, relay, *left, true);
    } else {
      context.coil(Core::Rst, relay, true);
    }
  }
}

// By n to the left; to the right is a turn to the left by the rest.
Words rotate_all(Context& context, const Words& value, int n, int bits) {
  if (value.size() == 1) return {rotate(context, value[0], n)};
  const Words up = shift_left(context, value, n);
  const Words down = shift_right(context, value, bits - n);
  return combine(context, Core::Wor, up, down);
}

// Through carry: a ring of one bit more, in which a turn to the right is one to the left by the
// rest.
Words rotate_through(Context& context, const Words& value, int left, int bits, Device carry) {
  core::Instruction gather;
  gather.op = Core::Gather;
  gather.always = true;
  const Device in = context.temporary_word();
  gather.targets = {in};
  gather.reads = {carry};
  context.emit(std::move(gather));
  Words entering{word(in)};
  if (value.size() == 2) entering.push_back(constant(0));
  const Words up = shift_left(context, value, left);
  const Words middle = shift_left(context, entering, left - 1);
  const Words down = shift_right(context, value, bits + 1 - left);
  return combine(context, Core::Wor, combine(context, Core::Wor, up, middle), down);
}

void turn(Context& context, bool left, bool through) {
  const Instruction& source = context.source();
  const int bits = source.width;
  const int ring = through ? bits + 1 : bits;
  const int given = source.operand(1).value;
  Requirements requirements;
  if (given == 0) {
    // Nothing moves, but an index outside of its window is still an error.
    place(context, source.operand(0), bits / 16, requirements.valid);
    return Execution(context, requirements).end();
  }
  const int by = given % ring;
  const Words value = read(context, source.operand(0), requirements.valid);
  const std::vector<Device> relays = context.named_of_role(SpecialRole::Carry);
  const int up = left ? by : (ring - by) % ring;  // to the left, 0 for a whole turn
  std::optional<Device> out;
  Words result = value;
  if (through) {
    if (up != 0) {
      // Read before anything is written: the place that becomes the carry.
      out = bit_of(context, value, bits - up);
      result = rotate_through(context, value, up, bits, relays.front());
    }
  } else {
    if (up != 0) result = rotate_all(context, value, up, bits);
    out = left ? bit_of(context, value, (2 * bits - by) % bits)
               : bit_of(context, value, (bits + by - 1) % bits);
  }
  const Place to = place(context, source.operand(0), bits / 16, requirements.valid);
  Execution execution(context, requirements);
  store(context, to, result);
  if (out) set_carry(context, relays, out);
  execution.end();
}

void shift(Context& context, bool left) {
  const Instruction& source = context.source();
  const int bits = source.width;
  const int by = source.operand(1).value % bits;
  Requirements requirements;
  const Words value = read(context, source.operand(0), requirements.valid);
  const std::vector<Device> relays = context.named_of_role(SpecialRole::Carry);
  std::optional<Device> out;
  if (by != 0) out = bit_of(context, value, left ? bits - by : by - 1);
  const Words result = left ? shift_left(context, value, by) : shift_right(context, value, by);
  const Place to = place(context, source.operand(0), bits / 16, requirements.valid);
  Execution execution(context, requirements);
  store(context, to, result);
  set_carry(context, relays, out);
  execution.end();
}

std::vector<Device> words_from(Device head, int count) {
  std::vector<Device> words;
  for (int i = 0; i < count; ++i) {
    words.push_back({head.kind, head.number + static_cast<std::uint32_t>(i)});
  }
  return words;
}

// Word by word, in an order in which every word is read before it is written.
void shift_words(Context& context, const std::vector<Device>& words, int by, bool up,
                 const Words& entering) {
  const auto n = static_cast<int>(words.size());
  for (int k = 0; k < n - by; ++k) {
    const int to = up ? n - 1 - k : k;
    context.gated(Core::Mov, {words[to]}, {word(words[up ? to - by : to + by])});
  }
  for (int k = 0; k < by; ++k) {
    context.gated(Core::Mov, {words[up ? k : n - by + k]}, {entering[k]});
  }
}

void shift_words_from(Context& context, bool up) {
  const Instruction& source = context.source();
  const std::vector<Device> words = words_from(source.operand(1).device, source.operand(2).value);
  const std::vector<Device> from = words_from(source.operand(0).device, source.operand(3).value);
  if (words.empty()) return;
  Words entering;
  for (const Device device : from) {
    // A source that is itself shifted is read first.
    const bool inside = device.kind == words.front().kind &&
                        device.number >= words.front().number &&
                        device.number <= words.back().number;
    if (!inside) {
      entering.push_back(word(device));
      continue;
    }
    const Device before = context.temporary_word();
    context.always(Core::Mov, {before}, {word(device)});
    entering.push_back(word(before));
  }
  Execution execution(context, {});
  shift_words(context, words, source.operand(3).value, up, entering);
  execution.end();
}

void shift_words_by_one(Context& context, bool up) {
  const Instruction& source = context.source();
  const std::vector<Device> words = words_from(source.operand(0).device, source.operand(1).value);
  if (words.empty()) return;
  Execution execution(context, {});
  shift_words(context, words, 1, up, {constant(0)});
  execution.end();
}

}  // namespace

bool lower_shifts(Context& context) {
  switch (context.source().op) {
    case Op::Rol:
      turn(context, true, false);
      return true;
    case Op::Ror:
      turn(context, false, false);
      return true;
    case Op::Rcl:
      turn(context, true, true);
      return true;
    case Op::Rcr:
      turn(context, false, true);
      return true;
    case Op::Sfl:
      shift(context, true);
      return true;
    case Op::Sfr:
      shift(context, false);
      return true;
    case Op::Wsfl:
      shift_words_from(context, true);
      return true;
    case Op::Wsfr:
      shift_words_from(context, false);
      return true;
    case Op::Dsfl:
      shift_words_by_one(context, true);
      return true;
    case Op::Dsfr:
      shift_words_by_one(context, false);
      return true;
    default:
      return false;
  }
}

}  // namespace rung::lower
