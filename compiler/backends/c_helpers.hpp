// SPDX-License-Identifier: Apache-2.0
// Small C functions that the code of instructions calls; only those that a program needs are
// written, as compilers warn of others.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "backends/c_source.hpp"

namespace rung {

// In the order in which they are written.
enum class CHelper : std::uint8_t {
  Word,           // int16_t word(uint32_t bits): the low 16 bits as a signed word
  Long,           // int32_t long(uint32_t bits)
  Pair,           // int32_t pair(int16_t low, int16_t high)
  Compare,        // int compare(int32_t a, int32_t b): -1, 0, 1
  Digits,         // uint32_t digits(const uint8_t *bits, count)
  SetDigits,      // void set_digits(uint8_t *bits, count, uint32_t value)
  ToBcd,          // uint32_t to_bcd(uint32_t value)
  FromBcd,        // uint32_t from_bcd(uint32_t digits), 0xFFFFFFFF where one is above 9
  RiseBits,       // void rise_bits(uint8_t *target, const uint8_t *source, length, count): SFTL
  FallBits,       // SFTR
  RiseWords,      // the same for words: WSFL
  FallWords,      // WSFR
  Ticks,          // uint16_t ticks(uint32_t elapsed, uint32_t *rest, uint32_t base)
  Timer,          // void timer(contact, value, state, cond, preset, ticks, retentive)
  Counter,        // void counter(contact, value, state, cond, preset)
  DoubleCounter,  // void double_counter(contact, low, high, state, cond, preset, down)
  Rise,           // unsigned rise(uint8_t *edge, unsigned s): whether s goes on
  Ton,            // unsigned ton(int16_t *value, unsigned s, int16_t count)
  Tof,            // unsigned tof(int16_t *value, unsigned s, int16_t count)
  Rto,            // unsigned rto(int16_t *value, unsigned s, int16_t count)
  LookUp,         // int16_t look_up(rows, count, index, target): the target's new value
  LookUpOwn,      // int16_t look_up_own(rows, count, index): the same where the target is the index
  Piecewise,      // int16_t piecewise(points, count, index, target, own)
  Digit,          // uint8_t digit(int16_t *kept, uint8_t *seen, int16_t power, unsigned last)
  Fault,          // void fault(void): error relays
};

class CHelpers {
 public:
  // Shared by several programs in one file: they are `plc_word` in each, and written once a file.
  explicit CHelpers(bool shared) : shared_(shared) {}

  // Its name, `@_word`; from now on it is needed.
  std::string use(CHelper helper);
  bool used(CHelper helper) const { return used_.contains(helper); }
  // All but Fault, which knows the program's devices and is written with them.
  void write(CSource& source) const;

 private:
  bool shared_;
  std::set<CHelper> used_;
};

}  // namespace rung
