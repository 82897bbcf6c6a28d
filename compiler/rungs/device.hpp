// SPDX-License-Identifier: Apache-2.0
// Devices: what a program reads and writes, by kind and number.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rung {

enum class Dialect : std::uint8_t { Paper, Fx, Q, Ldmicro };
// "paper", "fx", "q", "ldmicro"
std::string_view dialect_name(Dialect dialect);
// The reverse.
std::optional<Dialect> find_dialect(std::string_view name);

// Kinds of devices. The order is that of a trace's state. An LDmicro program has X, Y and M, which
// are its names with X, with Y and with any other letter, and D, its variables; they are numbered
// as they come, and their names are the program's (Program::names).
enum class DeviceKind : std::uint8_t {
  // bits
  X,    // inputs
  Y,    // outputs
  M,    // relays; of fx from 8000 special ones
  L,    // latched relays (q)
  F,    // annunciators, used as relays (q)
  B,    // link relays (q)
  SB,   // special link relays (q)
  S,    // states, step relays
  SM,   // special relays (q)
  TS,   // contacts of timers
  STS,  // contacts of retentive timers (q)
  CS,   // contacts of counters
  HB,   // of the lowering: memories of edges, temporaries; no program names them
  PB,   // device ports (ports.hpp)
  // words
  D,
  W,    // link registers (q)
  SW,   // special link registers (q)
  R,    // file registers
  V,    // index registers (fx)
  Z,    // index registers
  SD,   // special registers (q)
  TN,   // values of timers
  STN,  // values of retentive timers (q)
  CN,   // values of counters; of a 32-bit counter the low word
  CNH,  // high words of 32-bit counters (fx C200 to C234)
  HW,   // of the lowering: ticks, temporaries
  PW,   // device ports
};
inline constexpr int kDeviceKinds = static_cast<int>(DeviceKind::PW) + 1;
inline bool is_port(DeviceKind kind) { return kind == DeviceKind::PB || kind == DeviceKind::PW; }
// Not among the devices of a program's state.
inline bool is_hidden(DeviceKind kind) {
  return kind == DeviceKind::HB || kind == DeviceKind::HW || is_port(kind);
}

struct Device {
  DeviceKind kind = DeviceKind::X;
  std::uint32_t number = 0;
  auto operator<=>(const Device&) const = default;
};
inline bool is_word(DeviceKind kind) { return kind >= DeviceKind::D; }
inline bool is_word(Device device) { return is_word(device.kind); }

// The name that a list's trace uses: upper case, no leading zeros, in the number base of the
// dialect; the high word of a 32-bit counter is `CN200:h`. Where a program may have names of its
// own, ask device_name(device, program).
std::string device_name(Device device, Dialect dialect);

}  // namespace rung
