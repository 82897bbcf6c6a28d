// SPDX-License-Identifier: Apache-2.0
// Random operands of MELSEC instructions, as text.
#pragma once

#include <string>
#include <vector>

#include "programs/random_melsec.hpp"
#include "programs/random_source.hpp"

namespace rung {

class MelsecOperands {
 public:
  MelsecOperands(RandomSource& random, const RandomMelsecOptions& options)
      : random_(random), options_(options) {}

  // A bit that a contact reads, at times a bit of a word; with an index where one is `indexable`.
  std::string contact(bool indexable);
  // A bit that an output writes; with a bit of a word or an index if `any_form`.
  std::string coil(bool any_form);
  // The first of `count` bits that follow each other, to read or to write.
  std::string source_bits(int count);
  std::string target_bits(int count);

  // Words of 16 or 32 bits.
  std::string source(int width);
  std::string target(int width);
  // A register to write with `count` words from it on; an index where `indexed` allows one.
  std::string registers(int count, bool indexed);
  std::string constant(int width);
  // A group KnXm of n digits.
  std::string digits(int n, bool written);

  std::string timer();
  std::string retentive_timer();
  // `wide`: one that counts in 32 bits (fx).
  std::string counter(bool wide);
  std::string timer_preset();
  std::string counter_preset(bool wide);
  std::string state();
  // Two operands of ZRST.
  std::string range();

  bool fx() const { return options_.dialect == Dialect::Fx; }
  bool chance(Family family) { return random_.percent(options_.weight(family)); }
  bool has(Family family) const { return options_.weight(family) > 0; }

 private:
  std::string name(DeviceKind kind, int number) const;
  std::string any(DeviceKind kind, int count) { return name(kind, random_.below(count)); }
  std::string index();
  std::string relay(int first_beyond);
  std::string read_special();
  std::string written_special();
  std::string word_bit();

  RandomSource& random_;
  const RandomMelsecOptions& options_;
};

}  // namespace rung
