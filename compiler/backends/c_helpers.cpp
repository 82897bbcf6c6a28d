// SPDX-License-Identifier: Apache-2.0
#include "backends/c_helpers.hpp"

#include <iterator>
#include <optional>
#include <string_view>

namespace rung {
namespace {

struct Entry {
  CHelper helper;
  std::string_view name;
  std::string_view text;
  std::optional<CHelper> needs = std::nullopt;
};

// `%t` in the text of a shift is its type, `%n` its name.
constexpr std::string_view kRise =
    R"(/* Of `length` elements, each takes the value `count` below it; the lowest take those of source,
 * a copy that does not overlap. */
static void @_%n(%t *target, const %t *source, uint32_t length, uint32_t count) {
  uint32_t i;
  for (i = length; i-- > 0;) target[i] = i >= count ? target[i - count] : source[i];
})";
constexpr std::string_view kFall =
    R"(/* Of `length` elements, each takes the value `count` above it; the highest take those of source,
 * a copy that does not overlap. */
static void @_%n(%t *target, const %t *source, uint32_t length, uint32_t count) {
  uint32_t i;
  for (i = 0; i < length; ++i) {
    target[i] = i + count < length ? target[i + count] : source[i + count - length];
  }
})";

constexpr Entry kEntries[] = {
    {CHelper::Word, "word",
     R"(/* The low 16 bits as a signed word. */
static int16_t @_word(uint32_t bits) {
  bits &= 0xFFFFu;
  return (int16_t)(bits < 0x8000u ? (int32_t)bits : (int32_t)bits - 0x10000);
})"},
    {CHelper::Long, "long",
     R"(/* 32 bits as a signed number. */
static int32_t @_long(uint32_t bits) {
  return bits < 0x80000000u ? (int32_t)bits : -(int32_t)(0xFFFFFFFFu - bits) - 1;
})"},
    {CHelper::Pair, "pair",
     R"(/* Two words as a number of 32 bits. */
static int32_t @_pair(int16_t low, int16_t high) {
  return @_long((uint32_t)(uint16_t)high << 16 | (uint16_t)low);
})",
     CHelper::Long},
    {CHelper::Compare, "compare",
     R"(/* -1, 0 or 1 as a is below, equal to or above b. */
static int @_compare(int32_t a, int32_t b) { return (a > b) - (a < b); })"},
    {CHelper::Digits, "digits",
     R"(/* The number that so many bits make, the lowest first. */
static uint32_t @_digits(const uint8_t *bits, unsigned count) {
  uint32_t value = 0;
  while (count-- > 0) value = value << 1 | bits[count];
  return value;
})"},
    {CHelper::SetDigits, "set_digits",
     R"(/* The low bits of a value to so many bits, the lowest first. */
static void @_set_digits(uint8_t *bits, unsigned count, uint32_t value) {
  unsigned i;
  for (i = 0; i < count; ++i) bits[i] = (uint8_t)(value >> i & 1u);
})"},
    {CHelper::ToBcd, "to_bcd",
     R"(/* The decimal digits of a value, four bits each. */
static uint32_t @_to_bcd(uint32_t value) {
  uint32_t digits = 0;
  unsigned shift;
  for (shift = 0; shift < 32; shift += 4) {
    digits |= value % 10u << shift;
    value /= 10u;
  }
  return digits;
})"},
    {CHelper::FromBcd, "from_bcd",
     R"(/* The value of decimal digits of four bits each; 0xFFFFFFFF where one is above 9. */
static uint32_t @_from_bcd(uint32_t digits) {
  uint32_t value = 0;
  unsigned i;
  for (i = 0; i < 8; ++i) {
    const uint32_t digit = digits >> 28;
    if (digit > 9u) return 0xFFFFFFFFu;
    value = 10u * value + digit;
    digits <<= 4;
  }
  return value;
})"},
    {CHelper::RiseBits, "rise_bits", kRise},
    {CHelper::FallBits, "fall_bits", kFall},
    {CHelper::RiseWords, "rise_words", kRise},
    {CHelper::FallWords, "fall_words", kFall},
    {CHelper::Ticks, "ticks",
     R"(/* How many times `base` went by in the time elapsed; *rest is what is left of it. */
static uint16_t @_ticks(uint32_t elapsed, uint32_t *rest, uint32_t base) {
  const uint32_t sum = *rest + elapsed % base;
  const uint32_t ticks = elapsed / base + sum / base;
  *rest = sum % base;
  return (uint16_t)(ticks < 32767u ? ticks : 32767u);
})"},
    {CHelper::Timer, "timer",
     R"(/* OUT T. State: bit 0 is the coil, bit 1 says that this scan's ticks were used. */
static void @_timer(uint8_t *contact, int16_t *value, uint8_t *state, unsigned cond,
                     uint16_t preset, uint16_t ticks, int retentive) {
  if (!cond) {
    if (!retentive) {
      *value = 0;
      *contact = 0;
    }
  } else {
    if ((*state & 1u) && !*contact) {
      const uint16_t now = (uint16_t)((uint16_t)*value + ((*state & 2u) ? 0 : ticks));
      *value = @_word(now < preset ? now : preset);
    }
    if ((uint16_t)*value >= preset) *contact = 1;
  }
  *state = cond ? 3 : 2;
})",
     CHelper::Word},
    {CHelper::Counter, "counter",
     R"(/* OUT C. State: bit 0 is the coil, bit 1 is 1 while RST C is driven. */
static void @_counter(uint8_t *contact, int16_t *value, uint8_t *state, unsigned cond,
                       int16_t preset) {
  const int rise = cond && !*state;
  *state = (uint8_t)((*state & 2u) | cond);
  if (!rise || *contact) return;
  *value = @_word((uint32_t)*value + 1u);
  if (*value >= preset) *contact = 1;
})",
     CHelper::Word},
    {CHelper::DoubleCounter, "double_counter",
     R"(/* OUT C of 32 bits, up or down. State: bit 0 is the coil, bit 1 is 1 while RST C is driven. */
static void @_double_counter(uint8_t *contact, int16_t *low, int16_t *high, uint8_t *state,
                              unsigned cond, int32_t preset, unsigned down) {
  const int rise = cond && !*state;
  uint32_t value = (uint32_t)(uint16_t)*high << 16 | (uint16_t)*low;
  *state = (uint8_t)((*state & 2u) | cond);
  if (!rise) return;
  if (down) {
    if (value == (uint32_t)preset) *contact = 0;
    --value;
  } else {
    ++value;
    if (value == (uint32_t)preset) *contact = 1;
  }
  *low = @_word(value);
  *high = @_word(value >> 16);
})",
     CHelper::Word},
    {CHelper::Rise, "rise",
     R"(/* Whether s goes on; *edge is what it was before. */
static unsigned @_rise(uint8_t *edge, unsigned s) {
  const unsigned rises = s & (*edge ^ 1u);
  *edge = (uint8_t)s;
  return rises;
})"},
    {CHelper::Ton, "ton",
     R"(/* TON: counts the scans with s up to count, then the output is on. */
static unsigned @_ton(int16_t *value, unsigned s, int16_t count) {
  if (s && *value >= count) return 1;
  *value = (int16_t)(s ? *value + 1 : 0);
  return 0;
})"},
    {CHelper::Tof, "tof",
     R"(/* TOF: counts the scans without s up to count, then the output is off. */
static unsigned @_tof(int16_t *value, unsigned s, int16_t count) {
  if (!s && *value >= count) return 0;
  *value = (int16_t)(s ? 0 : *value + 1);
  return 1;
})"},
    {CHelper::Rto, "rto",
     R"(/* RTO: counts the scans with s up to count, then the output is on until the next RES. */
static unsigned @_rto(int16_t *value, unsigned s, int16_t count) {
  if (*value >= count) return 1;
  if (s) ++*value;
  return 0;
})"},
    {CHelper::LookUp, "look_up",
     R"(/* LOOK UP TABLE: row number `index`; target where there is none. */
static int16_t @_look_up(const int16_t *rows, uint16_t count, int16_t index, int16_t target) {
  return index >= 0 && (uint16_t)index < count ? rows[index] : target;
})"},
    {CHelper::LookUpOwn, "look_up_own",
     R"(/* LOOK UP TABLE whose target is its index: a later row may match what an earlier one gave. */
static int16_t @_look_up_own(const int16_t *rows, uint16_t count, int16_t index) {
  int16_t row = -1;
  while (index > row && (uint16_t)index < count) {
    row = index;
    index = rows[row];
  }
  return index;
})"},
    {CHelper::Piecewise, "piecewise",
     R"(/* PIECEWISE LINEAR through `count` points x, y: the new value of target; own: it is the index.
 * All steps are of 16 bits. */
static int16_t @_piecewise(const int16_t *points, uint16_t count, int16_t index, int16_t target,
                           int own) {
  const int16_t *p = points + 2 * count;
  while (p > points + 2) {
    p -= 2;
    if (index < @_word((uint32_t)p[0] + 1u)) {
      const int16_t x = @_word((uint32_t)index - (uint32_t)p[-2]);
      const int16_t width = @_word((uint32_t)p[0] - (uint32_t)p[-2]);
      const int16_t height = @_word((uint32_t)p[1] - (uint32_t)p[-1]);
      const int32_t area = @_word((uint32_t)((int32_t)x * height));
      target = @_word((uint32_t)(area / width) + (uint32_t)p[-1]);
      if (own) index = target;
    }
  }
  return target;
})",
     CHelper::Word},
    {CHelper::Digit, "digit",
     R"(/* The next digit of *kept as a character; a 0 before the first other one is a blank. */
static uint8_t @_digit(int16_t *kept, uint8_t *seen, int16_t power, unsigned last) {
  const int16_t digit = (int16_t)(*kept / power);
  *kept = (int16_t)(*kept % power);
  if (digit != 0) *seen = 1;
  return (uint8_t)(*seen || last ? 48u + (uint16_t)digit : 32u);
})"},
    {CHelper::Fault, "fault", ""},
};

std::string fill(const Entry& entry) {
  const bool words = entry.helper == CHelper::RiseWords || entry.helper == CHelper::FallWords;
  std::string text;
  for (std::size_t i = 0; i < entry.text.size(); ++i) {
    const char next = i + 1 < entry.text.size() ? entry.text[i + 1] : ' ';
    if (entry.text[i] != '%' || (next != 't' && next != 'n')) {
      text += entry.text[i];
      continue;
    }
    ++i;
    text += next == 't' ? (words ? "int16_t" : "uint8_t") : entry.name;
  }
  return text;
}

}  // namespace

std::string CHelpers::use(CHelper helper) {
  const Entry& entry = kEntries[static_cast<std::size_t>(helper)];
  used_.insert(helper);
  if (entry.needs) used_.insert(*entry.needs);
  return (shared_ && !entry.text.empty() ? "plc_" : "@_") + std::string(entry.name);
}

void CHelpers::write(CSource& source) const {
  CSource common("Plc");
  CSource& lines = shared_ ? common : source;
  for (const CHelper helper : used_) {
    const Entry& entry = kEntries[static_cast<std::size_t>(helper)];
    if (entry.text.empty()) continue;
    if (shared_) lines.line("#ifndef PLC_HAS_{0}\n#define PLC_HAS_{0}", entry.name);
    lines.code(fill(entry));
    lines.code(shared_ ? "#endif\n" : "");
  }
  if (shared_) source.append(common);
}

}  // namespace rung
