// SPDX-License-Identifier: Apache-2.0
#include "programs/ldmicro_elements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace rung {
namespace {

constexpr int kLow = -32768;
constexpr int kHigh = 32767;
// Where signs, carries, divisions, limits and decimal digits go wrong.
constexpr int kCorners[] = {0,      1,      -1,    2,      -2,    3,    7,    10,   -7,
                            9,      99,     100,   255,    256,   -256, 999,  9999, 10000,
                            -10000, 16384,  16385, 300,    181,   182,  1432, kLow, kHigh,
                            -9999,  -32767, 32766, -32766, kHigh, kLow};
constexpr int kMostChannels = 3;
constexpr int kTimers = 3;
constexpr int kCounters = 3;
// Longer than what random programs run, and the longest that there is.
constexpr int kLongScans = 500;
constexpr int kLongestScans = 32768;

template <typename Value, std::size_t count>
const Value& pick(RandomSource& random, const Value (&table)[count]) {
  return table[random.below(static_cast<int>(count))];
}

}  // namespace

LdmicroElements::LdmicroElements(RandomSource& random, const RandomLdmicroOptions& options)
    : random_(random), options_(options) {
  weights_.assign(options.weights.begin(),
                  options.weights.begin() + static_cast<int>(LdmicroFamily::Shared));
}

std::string LdmicroElements::numbered(std::string_view letters, int count) {
  return fmt::format("{}{}", letters, random_.below(count));
}

std::string LdmicroElements::bit() {
  if (random_.percent(options_.weight(LdmicroFamily::Shared))) {
    return numbered(random_.percent(50) ? "v" : "C", 2);
  }
  return random_.percent(45) ? numbered("Y", options_.outputs) : numbered("R", options_.relays);
}

std::string LdmicroElements::contact() {
  const std::string name = random_.percent(60) ? numbered("X", options_.inputs) : bit();
  return fmt::format("CONTACTS {} {}", name, random_.below(2));
}

std::string LdmicroElements::coil() {
  const int kind = random_.below(100);
  const bool several = kind >= 95;
  const bool negated = kind < 12 || (several && random_.percent(50));
  const bool set = (kind >= 12 && kind < 30) || (several && random_.percent(70));
  const bool reset = (kind >= 30 && kind < 48) || (several && random_.percent(70));
  return fmt::format("COIL {} {} {} {}", bit(), int{negated}, int{set}, int{reset});
}

std::string LdmicroElements::variable() {
  if (random_.percent(options_.weight(LdmicroFamily::Shared))) {
    static constexpr const char* kBits[] = {"X", "Y", "R"};
    return numbered(pick(random_, kBits), 2);
  }
  if (has(LdmicroFamily::Timers) && random_.percent(10)) return numbered("T", kTimers);
  if (has(LdmicroFamily::Counters) && random_.percent(10)) return numbered("C", kCounters);
  if (has(LdmicroFamily::Analogue) && random_.percent(8)) return numbered("A", kMostChannels);
  if (has(LdmicroFamily::Registers) && random_.percent(8)) return numbered("s", 4);
  return numbered("v", options_.variables);
}

std::string LdmicroElements::own(char letter) {
  if (random_.percent(12)) return variable();
  return fmt::format("{}{}", letter, random_.below(letter == 'T' ? kTimers : kCounters));
}

int LdmicroElements::small() { return random_.below(16) - 4; }

int LdmicroElements::literal() {
  const int which = random_.below(100);
  if (which < 45) return small();
  if (which < 85) return pick(random_, kCorners);
  return random_.below(kHigh - kLow + 1) + kLow;
}

std::string LdmicroElements::value() {
  const int which = random_.below(100);
  if (which < 55) return variable();
  if (which < 58) return fmt::format("'{}'", static_cast<char>('!' + random_.below(90)));
  return std::to_string(literal());
}

// The choices of a line are made one after another, in statements of their own: the order in which
// a function's arguments are evaluated differs between compilers.

std::string LdmicroElements::timer() {
  static constexpr const char* kTimerNames[] = {"TON", "TON", "TOF", "TOF", "RTO"};
  if (random_.percent(20)) return "RES " + own('T');
  const int which = random_.below(100);
  const int scans = which < 85   ? 2 + random_.below(6)
                    : which < 95 ? 8 + random_.below(kLongScans)
                                 : kLongestScans;
  // What is no multiple of the cycle is rounded down.
  const std::int64_t more = scans < kLongestScans && random_.percent(30)
                                ? random_.below(static_cast<int>(options_.cycle_us))
                                : 0;
  const char* const name = pick(random_, kTimerNames);
  return fmt::format("{} {} {}", name, own('T'), scans * options_.cycle_us + more);
}

std::string LdmicroElements::counter() {
  static constexpr const char* kCounterNames[] = {"CTU", "CTD", "CTC"};
  if (random_.percent(15)) return "RES " + own('C');
  const int limit = random_.percent(70) ? random_.below(6) - 1 : literal();
  const char* const name = pick(random_, kCounterNames);
  return fmt::format("{} {} {}", name, own('C'), limit);
}

std::string LdmicroElements::compare() {
  static constexpr const char* kCompares[] = {"EQU", "NEQ", "GRT", "GEQ", "LES", "LEQ"};
  const char* const name = pick(random_, kCompares);
  const std::string first = random_.percent(10) ? value() : variable();
  return fmt::format("{} {} {}", name, first, value());
}

std::string LdmicroElements::move() {
  // Counters are rarely led to where they wrap.
  if (has(LdmicroFamily::Counters) && random_.percent(15)) {
    const std::string counter = own('C');
    return fmt::format("MOVE {} {}", counter, random_.percent(50) ? kHigh : kLow);
  }
  const std::string target = variable();
  return fmt::format("MOVE {} {}", target, value());
}

std::string LdmicroElements::arithmetic() {
  static constexpr const char* kOperations[] = {"ADD", "SUB", "MUL", "DIV"};
  const char* const name = pick(random_, kOperations);
  const std::string target = variable();
  // The quotient that 16 bits do not hold.
  if (random_.percent(3)) return fmt::format("{} {} {} -1", name, target, kLow);
  const std::string first = value();
  return fmt::format("{} {} {} {}", name, target, first, value());
}

std::string LdmicroElements::shift_register() {
  // Its stages are those of the general variables, the counters or the timers, or its own.
  static constexpr const char* kHeads[] = {"s", "s", "v", "C", "T"};
  const char* const head = pick(random_, kHeads);
  return fmt::format("SHIFT_REGISTER {} {}", head, 1 + random_.below(5));
}

std::string LdmicroElements::look_up_table() {
  const int rows = 1 + random_.below(random_.percent(10) ? 40 : 7);
  std::vector<int> values;
  for (int i = 0; i < rows; ++i) {
    // Values that are rows again matter where target and index are the same variable.
    values.push_back(random_.percent(60) ? random_.below(rows + 2) : literal());
  }
  const std::string target = variable();
  const std::string index = random_.percent(30) ? target : variable();
  return fmt::format("LOOK_UP_TABLE {} {} {} {} {}", target, index, rows, random_.below(2),
                     fmt::join(values, " "));
}

std::string LdmicroElements::piecewise_linear() {
  const int points = random_.percent(8) ? 1 : 2 + random_.below(random_.percent(10) ? 20 : 4);
  int x = random_.percent(15) ? kLow + random_.below(3) : random_.below(60) - 40;
  int y = literal();
  std::string text = fmt::format(" {} {}", x, y);
  int count = 1;
  while (count < points && x < kHigh) {
    const int kind = random_.below(100);
    int next = x + 1 + random_.below(kind < 70 ? 12 : kind < 85 ? 400 : kHigh);
    if (kind >= 97) next = kHigh;  // whose successor is the lowest number
    if (next > kHigh) next = kHigh;
    // The slope's product must stay within 16 bits.
    const int most = kHigh / (next - x);
    int rise = most == 0 ? 0 : random_.below(2 * most + 1) - most;
    if (random_.percent(60) && most > 40) rise = random_.below(80) - 40;
    y += rise;
    if (y < kLow || y > kHigh) y -= 2 * rise;
    x = next;
    text += fmt::format(" {} {}", x, y);
    ++count;
  }
  const std::string target = variable();
  const std::string index = random_.percent(25) ? target : variable();
  return fmt::format("PIECEWISE_LINEAR {} {} {}{}", target, index, count, text);
}

std::string LdmicroElements::characters(int most) {
  static constexpr const char* kEscapes[] = {R"(\r)", R"(\n)",   R"(\b)",   R"(\f)",
                                             R"(\\)", R"(\x00)", R"(\xFF)", R"(\x4A)"};
  std::string text;
  for (int i = random_.below(most + 1); i > 0; --i) {
    const int kind = random_.below(100);
    if (kind < 20) {
      text += pick(random_, kEscapes);
    } else if (kind < 28) {
      text += static_cast<char>(128 + random_.below(128));
    } else {
      text += static_cast<char>(random_.percent(50) ? '0' + random_.below(10)
                                                    : ' ' + random_.below('\\' - ' '));
    }
  }
  return text;
}

std::string LdmicroElements::formatted_string() {
  const bool number = random_.percent(75);
  std::string text = characters(3);
  if (number) {
    text += '\\';
    if (random_.percent(55)) text += '-';
    text += static_cast<char>('1' + random_.below(5));
    text += characters(2);
  } else if (text.empty()) {
    text = "!";
  }
  std::vector<int> codes;
  codes.reserve(text.size());
  for (const char c : text) codes.push_back(static_cast<unsigned char>(c));
  return fmt::format("FORMATTED_STRING {} {} {}", number ? variable() : "(none)", codes.size(),
                     fmt::join(codes, " "));
}

std::string LdmicroElements::pulse_width() {
  const std::string duty = variable();
  return fmt::format("SET_PWM {} {}", duty, 1000 * (1 + random_.below(50)));
}

std::string LdmicroElements::other() {
  if (std::all_of(weights_.begin(), weights_.end(), [](int weight) { return weight == 0; })) {
    return contact();
  }
  const bool first = random_.percent(50);
  switch (static_cast<LdmicroFamily>(random_.weighted(weights_))) {
    case LdmicroFamily::Edges:
      return first ? "OSR" : "OSF";
    case LdmicroFamily::Timers:
      return timer();
    case LdmicroFamily::Counters:
      return counter();
    case LdmicroFamily::Compares:
      return compare();
    case LdmicroFamily::Moves:
      return move();
    case LdmicroFamily::Arithmetic:
      return arithmetic();
    case LdmicroFamily::Registers:
      return shift_register();
    case LdmicroFamily::Tables:
      return first ? look_up_table() : piecewise_linear();
    case LdmicroFamily::Serial:
      return (first ? "UART_SEND " : "UART_RECV ") + variable();
    case LdmicroFamily::Strings:
      return formatted_string();
    case LdmicroFamily::Analogue:
      if (random_.percent(70)) return "READ_ADC " + numbered("A", kMostChannels);
      return pulse_width();
    case LdmicroFamily::Lasting:
      return "PERSIST " + variable();
    case LdmicroFamily::Wires:
      return random_.percent(70) ? "SHORT" : "OPEN";
    case LdmicroFamily::Relay:
      return "MASTER_RELAY";
    default:
      return contact();
  }
}

}  // namespace rung
