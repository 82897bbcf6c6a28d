// SPDX-License-Identifier: Apache-2.0
#include "rungs/devices.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "rungs/special.hpp"

namespace rung {
namespace {

using enum DeviceKind;

// fx: as an FX3U's Modbus map and programming manual list them, X and Y as far as the map goes
// (Y000-Y377), counters below the high-speed ones. paper: the paper shows single digits only and
// is by users of Mitsubishi's controllers, so its devices are those of fx. q: what a QnU CPU has
// before its parameters are changed; of retentive timers, which it then lacks, as many as timers.
constexpr DeviceRange kRanges[] = {
    {Dialect::Paper, X, 8, 0377},     {Dialect::Paper, Y, 8, 0377}, {Dialect::Paper, M, 10, 7679},
    {Dialect::Paper, D, 10, 7999},  //
    {Dialect::Fx, X, 8, 0377},        {Dialect::Fx, Y, 8, 0377},    {Dialect::Fx, M, 10, 7679},
    {Dialect::Fx, S, 10, 4095},       {Dialect::Fx, TS, 10, 511},   {Dialect::Fx, CS, 10, 234},
    {Dialect::Fx, D, 10, 7999},       {Dialect::Fx, R, 10, 32767},  {Dialect::Fx, V, 10, 7},
    {Dialect::Fx, Z, 10, 7},          {Dialect::Fx, TN, 10, 511},   {Dialect::Fx, CN, 10, 234},
    {Dialect::Fx, CNH, 10, 234, 200},  //
    {Dialect::Q, X, 16, 0x1FFF},      {Dialect::Q, Y, 16, 0x1FFF},  {Dialect::Q, M, 10, 8191},
    {Dialect::Q, L, 10, 8191},        {Dialect::Q, F, 10, 2047},    {Dialect::Q, B, 16, 0x1FFF},
    {Dialect::Q, SB, 16, 0x7FF},      {Dialect::Q, S, 10, 8191},    {Dialect::Q, TS, 10, 2047},
    {Dialect::Q, STS, 10, 2047},      {Dialect::Q, CS, 10, 1023},   {Dialect::Q, D, 10, 12287},
    {Dialect::Q, W, 16, 0x1FFF},      {Dialect::Q, SW, 16, 0x7FF},  {Dialect::Q, R, 10, 32767},
    {Dialect::Q, Z, 10, 19},          {Dialect::Q, TN, 10, 2047},   {Dialect::Q, STN, 10, 2047},
    {Dialect::Q, CN, 10, 1023},
};

constexpr TimerRange kTimers[] = {
    {Dialect::Fx, TS, 0, 199, 100'000, false}, {Dialect::Fx, TS, 200, 245, 10'000, false},
    {Dialect::Fx, TS, 246, 249, 1'000, true},  {Dialect::Fx, TS, 250, 255, 100'000, true},
    {Dialect::Fx, TS, 256, 511, 1'000, false}, {Dialect::Q, TS, 0, 2047, 100'000, false},
    {Dialect::Q, STS, 0, 2047, 100'000, true},
};

// In the order of DeviceKind.
constexpr std::string_view kLetters[] = {"X",  "Y",   "M",  "L",  "F",   "B",  "SB", "S",  "SM",
                                         "TS", "STS", "CS", "%B", "%PB", "D",  "W",  "SW", "R",
                                         "V",  "Z",   "SD", "TN", "STN", "CN", "CN", "%W", "%PW"};
static_assert(std::size(kLetters) == kDeviceKinds);

struct Prefix {
  std::string_view letters;
  DeviceKind kind;
};
// What a name may begin with; of several that fit, the longest counts.
constexpr Prefix kPrefixes[] = {
    {"STS", STS}, {"STN", STN}, {"SB", SB}, {"SM", SM},  {"SW", SW}, {"SD", SD}, {"TS", TS},
    {"TN", TN},   {"CS", CS},   {"CN", CN}, {"ST", STS}, {"X", X},   {"Y", Y},   {"M", M},
    {"L", L},     {"F", F},     {"B", B},   {"S", S},    {"T", TS},  {"C", CS},  {"D", D},
    {"W", W},     {"R", R},     {"V", V},   {"Z", Z},
};

// First and last number of an FX's special relays (M) and registers (D).
constexpr std::uint32_t kFirstSpecial = 8000;
constexpr std::uint32_t kLastSpecial = 8511;

int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  return c - 'A' + 10;
}

bool is_special(DeviceKind kind, std::uint64_t number, Dialect dialect) {
  if (kind == SM || kind == SD) return true;
  return dialect == Dialect::Fx && (kind == M || kind == D) && number >= kFirstSpecial &&
         number <= kLastSpecial;
}

}  // namespace

std::span<const DeviceRange> device_ranges() { return kRanges; }

const DeviceRange* find_device_range(DeviceKind kind, Dialect dialect) {
  const auto* found = std::find_if(
      std::begin(kRanges), std::end(kRanges),
      [&](const DeviceRange& range) { return range.kind == kind && range.dialect == dialect; });
  return found == std::end(kRanges) ? nullptr : found;
}

const DeviceRange& device_range(DeviceKind kind, Dialect dialect) {
  return *find_device_range(kind, dialect);
}

std::string_view kind_letters(DeviceKind kind) { return kLetters[static_cast<std::size_t>(kind)]; }

bool is_32_bit_counter(Device counter, Dialect dialect) {
  return dialect == Dialect::Fx && is_counter(counter.kind) && counter.number >= 200;
}

Device high_word(Device device, Dialect dialect) {
  if (device.kind == CN && is_32_bit_counter(device, dialect)) return {CNH, device.number};
  return {device.kind, device.number + 1};
}

Device contact_of(Device device) {
  switch (device.kind) {
    case TN:
      return {TS, device.number};
    case STN:
      return {STS, device.number};
    case CN:
    case CNH:
      return {CS, device.number};
    default:
      return device;
  }
}

Device value_of(Device device) {
  switch (device.kind) {
    case TS:
      return {TN, device.number};
    case STS:
      return {STN, device.number};
    case CS:
      return {CN, device.number};
    default:
      return device;
  }
}

bool is_timer(DeviceKind kind) { return kind == TS || kind == STS || kind == TN || kind == STN; }
bool is_counter(DeviceKind kind) { return kind == CS || kind == CN || kind == CNH; }

const TimerRange& timer_range(Device contact, Dialect dialect) {
  return *std::find_if(std::begin(kTimers), std::end(kTimers), [&](const TimerRange& range) {
    return range.dialect == dialect && range.kind == contact.kind &&
           contact.number >= range.first && contact.number <= range.last;
  });
}

ParsedDevice parse_device(std::string_view text, Dialect dialect) {
  std::string upper(text);
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const bool high = upper.ends_with(":H");
  if (high) upper.resize(upper.size() - 2);
  for (const Prefix& prefix : kPrefixes) {
    if (!upper.starts_with(prefix.letters)) continue;
    const DeviceRange* range = find_device_range(prefix.kind, dialect);
    const bool special_kind = dialect == Dialect::Q && (prefix.kind == SM || prefix.kind == SD);
    if (range == nullptr && !special_kind) continue;
    const int base = range != nullptr ? range->base : 10;
    const std::string_view digits = std::string_view(upper).substr(prefix.letters.size());
    const bool well_formed =
        !digits.empty() && std::all_of(digits.begin(), digits.end(),
                                       [](unsigned char c) { return std::isxdigit(c) != 0; });
    // XA is a device where numbers are hexadecimal, and else some other word.
    if (!well_formed ||
        (std::isdigit(static_cast<unsigned char>(digits.front())) == 0 && base != 16))
      continue;
    std::uint64_t number = 0;
    for (const char c : digits) {
      const int value = digit_value(c);
      if (value >= base) return {DeviceError::Digit, {prefix.kind, 0}};
      number = number * static_cast<unsigned>(base) + static_cast<unsigned>(value);
      number = std::min<std::uint64_t>(number, UINT32_MAX);
    }
    const Device device{prefix.kind, static_cast<std::uint32_t>(number)};
    if (is_special(prefix.kind, number, dialect)) {
      if (high || find_special(device, dialect) == nullptr) {
        return {DeviceError::Special, {prefix.kind, 0}};
      }
      return {DeviceError::None, device};
    }
    if (number > range->last) return {DeviceError::Range, {prefix.kind, 0}};
    if (!high) return {DeviceError::None, device};
    if (prefix.kind != CN || !is_32_bit_counter(device, dialect)) {
      return {DeviceError::Form, {}};
    }
    return {DeviceError::None, {CNH, device.number}};
  }
  return {DeviceError::Form, {}};
}

std::optional<Device> parse_device_name(std::string_view text, Dialect dialect) {
  const ParsedDevice parsed = parse_device(text, dialect);
  if (parsed.error != DeviceError::None) return std::nullopt;
  return parsed.device;
}

}  // namespace rung
