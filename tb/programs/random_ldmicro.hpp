// SPDX-License-Identifier: Apache-2.0
// Valid LDmicro files by rule with every element of compiler/LDMICRO.md: what the agreement tests
// run by the thousand. Text only: nothing here knows the reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace rung {

// What a program may be made of beside contacts and coils, which are always there.
enum class LdmicroFamily : std::uint8_t {
  Edges,   // OSR OSF
  Timers,  // TON TOF RTO RES
  Counters,
  Compares,
  Moves,
  Arithmetic,
  Registers,  // SHIFT_REGISTER
  Tables,     // LOOK_UP_TABLE PIECEWISE_LINEAR
  Serial,     // UART_SEND UART_RECV
  Strings,    // FORMATTED_STRING
  Analogue,   // READ_ADC SET_PWM
  Lasting,    // PERSIST
  Wires,      // SHORT OPEN
  Relay,      // MASTER_RELAY
  Shared,     // names that are a bit and a variable: chance in 100 of an operand
  Parallels,  // chance in 100 of an item
};
inline constexpr int kLdmicroFamilies = static_cast<int>(LdmicroFamily::Parallels) + 1;

// The fewer devices there are, the more often one element meets what another has written.
struct RandomLdmicroOptions {
  int rungs = 6;
  // Of each family: its weight among the elements, or the chance named above. 0: none at all.
  std::array<int, kLdmicroFamilies> weights{};
  // Devices of each kind, numbered from 0.
  int inputs = 4;
  int outputs = 3;
  int relays = 4;
  int variables = 4;
  std::int64_t cycle_us = 10000;

  int weight(LdmicroFamily family) const { return weights[static_cast<std::size_t>(family)]; }
  int& weight(LdmicroFamily family) { return weights[static_cast<std::size_t>(family)]; }
};

// The options of program number `seed`: each program has some families in plenty, some a little and
// some not at all, so that together they mix everything and each still does something.
RandomLdmicroOptions ldmicro_options(std::uint64_t seed);

// A file of format 0.1 with some 10 to 60 elements. The same seed and options give the same text
// everywhere.
std::string random_ldmicro(std::uint64_t seed, const RandomLdmicroOptions& options);

}  // namespace rung
