// SPDX-License-Identifier: Apache-2.0
#include "programs/melsec_operands.hpp"

#include <fmt/format.h>

#include <iterator>

namespace rung {
namespace {

// Constants worth trying beside any other: where signs, carries, divisions and decimal digits go
// wrong.
constexpr int kCorners[] = {0,    1,     -1,     2,      -2,     3,      7,      9,      10,
                            15,   16,    255,    256,    9999,   10000,  0x0999, 0x1234, 0x000A,
                            4096, 32767, -32768, -32767, -26215, 0x4000, 100};
constexpr std::int64_t kWideCorners[] = {
    0,          1,          -1,         2,           -2,         10,          32767,     32768,
    -32768,     -32769,     65535,      65536,       -65536,     99999999,    100000000, 0x12345678,
    0x09999999, 0x0000A000, 2147483647, -2147483648, 2147483646, -2147483647, 46341,     -65537};

// Timers of each base, and which of them keep their value.
constexpr const char* kFxTimers[] = {"T0", "T1", "T200", "T256", "T257"};
constexpr const char* kFxRetentive[] = {"T246", "T250"};
constexpr const char* kQTimers[] = {"T0", "T1", "T2"};
constexpr const char* kQRetentive[] = {"ST0", "ST1"};

constexpr const char* kFxRead[] = {"M8000", "M8001", "M8002", "M8003", "M8011", "M8012",
                                   "M8013", "M8014", "M8020", "M8021", "M8022", "M8020",
                                   "M8021", "M8022", "M8022", "M8067", "M8068", "M8200"};
constexpr const char* kFxWritten[] = {"M8020", "M8021", "M8022", "M8022", "M8067",
                                      "M8068", "M8200", "M8201", "M8200"};
constexpr const char* kQRead[] = {"SM400", "SM401", "SM402", "SM403", "SM409", "SM410", "SM411",
                                  "SM412", "SM413", "SM700", "SM700", "SM700", "SM0",   "SM56"};
constexpr const char* kQWritten[] = {"SM700", "SM700", "SM0", "SM56"};

template <typename Value, std::size_t count>
const Value& pick(RandomSource& random, const Value (&table)[count]) {
  return table[random.below(static_cast<int>(count))];
}

}  // namespace

std::string MelsecOperands::name(DeviceKind kind, int number) const {
  return device_name({kind, static_cast<std::uint32_t>(number)}, options_.dialect);
}

std::string MelsecOperands::index() {
  if (!fx()) return fmt::format("Z{}", random_.below(2));
  return fmt::format("{}{}", random_.percent(50) ? 'V' : 'Z', random_.below(2));
}

// An internal bit: mostly M, at times one of the kinds that are only other names for it.
std::string MelsecOperands::relay(int first_beyond) {
  static constexpr DeviceKind kQRelays[] = {DeviceKind::L, DeviceKind::F, DeviceKind::B,
                                            DeviceKind::SB, DeviceKind::S};
  if (random_.percent(80)) return any(DeviceKind::M, first_beyond);
  if (fx()) return any(DeviceKind::S, 4);
  return any(pick(random_, kQRelays), 4);
}

std::string MelsecOperands::read_special() {
  return fx() ? pick(random_, kFxRead) : pick(random_, kQRead);
}

std::string MelsecOperands::written_special() {
  return fx() ? pick(random_, kFxWritten) : pick(random_, kQWritten);
}

std::string MelsecOperands::word_bit() {
  return fmt::format("{}.{:X}", any(DeviceKind::D, options_.words), random_.below(16));
}

std::string MelsecOperands::contact(bool indexable) {
  if (chance(Family::WordBits)) return word_bit();
  if (chance(Family::Special)) return read_special();
  if (has(Family::Timers) && random_.percent(12)) {
    return random_.percent(70) ? timer() : retentive_timer();
  }
  if (has(Family::Counters) && random_.percent(12)) return counter(random_.percent(40));
  const bool indexed = indexable && chance(Family::Index);
  std::string text;
  const int which = random_.below(100);
  if (which < 45) {
    text = any(DeviceKind::X, options_.inputs);
  } else if (which < 60) {
    text = any(DeviceKind::Y, options_.outputs);
  } else {
    text = indexed ? any(DeviceKind::M, options_.relays) : relay(options_.relays);
  }
  return indexed ? text + index() : text;
}

std::string MelsecOperands::coil(bool any_form) {
  if (any_form && chance(Family::WordBits)) return word_bit();
  if (has(Family::Special) && random_.percent(8)) return written_special();
  const bool indexed = any_form && chance(Family::Index);
  const bool output = random_.percent(45);
  if (indexed) {
    return (output ? any(DeviceKind::Y, options_.outputs) : any(DeviceKind::M, options_.relays)) +
           index();
  }
  return output ? any(DeviceKind::Y, options_.outputs) : relay(options_.relays);
}

std::string MelsecOperands::source_bits(int count) {
  if (random_.percent(30)) return any(DeviceKind::X, options_.inputs);
  return target_bits(count);
}

std::string MelsecOperands::target_bits(int count) {
  if (random_.percent(25)) return any(DeviceKind::Y, options_.outputs);
  // Near the others, and at times beside them.
  return any(DeviceKind::M, options_.relays + count / 2);
}

std::string MelsecOperands::digits(int n, bool written) {
  std::string head;
  const int which = random_.below(100);
  if (which < 35 && !written) {
    head = any(DeviceKind::X, options_.inputs);
  } else if (which < 50) {
    head = any(DeviceKind::Y, options_.outputs);
  } else if (which < 60 && fx()) {
    head = any(DeviceKind::S, 4);
  } else {
    head = any(DeviceKind::M, options_.relays);
  }
  return fmt::format("K{}{}", n, head);
}

std::string MelsecOperands::constant(int width) {
  if (width == 32) {
    const std::int64_t value = random_.percent(60)
                                   ? pick(random_, kWideCorners)
                                   : static_cast<std::int32_t>(random_.bits() & 0xFFFFFFFF);
    if (random_.percent(20)) return fmt::format("H{:X}", value & 0xFFFFFFFF);
    return fmt::format("K{}", value);
  }
  const int value = random_.percent(70) ? pick(random_, kCorners) : random_.below(65536) - 32768;
  if (random_.percent(20)) return fmt::format("H{:X}", value & 0xFFFF);
  return fmt::format("K{}", value);
}

std::string MelsecOperands::registers(int count, bool indexed) {
  const bool with_index = indexed && chance(Family::Index);
  const int heads = std::max(1, options_.words - count + 1);
  DeviceKind kind = DeviceKind::D;
  if (random_.percent(12)) kind = fx() || random_.percent(50) ? DeviceKind::R : DeviceKind::W;
  return any(kind, heads) + (with_index ? index() : "");
}

std::string MelsecOperands::source(int width) {
  if (random_.percent(25)) return constant(width);
  if (has(Family::Timers) && random_.percent(5)) return timer();
  if (has(Family::Counters) && random_.percent(5)) {
    return counter(width == 32 && random_.percent(70));
  }
  if (chance(Family::Digits)) return digits(1 + random_.below(width / 4), false);
  if (width == 16 && has(Family::Index) && random_.percent(8)) return index();
  return registers(width / 16, true);
}

std::string MelsecOperands::target(int width) {
  if (has(Family::Timers) && random_.percent(4)) return timer();
  if (has(Family::Counters) && random_.percent(4)) {
    return counter(width == 32 && random_.percent(70));
  }
  if (chance(Family::Digits)) return digits(1 + random_.below(width / 4), true);
  if (width == 16 && has(Family::Index) && random_.percent(12)) return index();
  return registers(width / 16, true);
}

std::string MelsecOperands::timer() {
  return fx() ? pick(random_, kFxTimers) : pick(random_, kQTimers);
}

std::string MelsecOperands::retentive_timer() {
  return fx() ? pick(random_, kFxRetentive) : pick(random_, kQRetentive);
}

std::string MelsecOperands::counter(bool wide) {
  return fmt::format("C{}", random_.below(2) + (wide && fx() ? 200 : 0));
}

std::string MelsecOperands::timer_preset() {
  if (random_.percent(20)) return any(DeviceKind::D, options_.words);
  return fmt::format("K{}", random_.percent(80) ? 1 + random_.below(12) : 1 + random_.below(32767));
}

std::string MelsecOperands::counter_preset(bool wide) {
  if (random_.percent(25)) return any(DeviceKind::D, options_.words - 1);
  const int value = wide ? random_.below(7) - 3 : 1 + random_.below(4);
  return fmt::format("K{}", value);
}

std::string MelsecOperands::state() { return any(DeviceKind::S, 4); }

std::string MelsecOperands::range() {
  const auto pair = [&](DeviceKind kind, int first, int count) {
    const int from = first + random_.below(count);
    // At times the wrong way round: only the first one is reset then.
    const int to = random_.percent(80) ? from + random_.below(first + count - from)
                                       : first + random_.below(count);
    return name(kind, from) + " " + name(kind, to);
  };
  const int which = random_.below(100);
  if (which < 25) return pair(DeviceKind::M, 0, options_.relays);
  if (which < 40) return pair(DeviceKind::Y, 0, options_.outputs);
  if (which < 50) return pair(DeviceKind::S, 0, 4);
  if (which < 70) return pair(DeviceKind::D, 0, options_.words);
  const auto spelled = [&](const char* letter, int first, int count) {
    const int from = first + random_.below(count);
    return fmt::format("{0}{1} {0}{2}", letter, from, from + random_.below(first + count - from));
  };
  if (which < 80) return spelled("T", 0, 2);
  if (which < 90) return spelled("C", 0, 2);
  return fx() ? spelled("C", 200, 2) : spelled("T", 0, 3);
}

}  // namespace rung
