// SPDX-License-Identifier: Apache-2.0
// Random elements of LDmicro files, as text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "programs/random_ldmicro.hpp"
#include "programs/random_source.hpp"

namespace rung {

class LdmicroElements {
 public:
  LdmicroElements(RandomSource& random, const RandomLdmicroOptions& options);

  std::string contact();
  std::string coil();
  // Any element but those: of the families, by their weights.
  std::string other();

 private:
  bool has(LdmicroFamily family) const { return options_.weight(family) > 0; }
  std::string numbered(std::string_view letters, int count);
  std::string bit();
  // Any variable: a general one, a timer's, a counter's, one that is a bit's name too.
  std::string variable();
  // A variable that a timer or counter has mostly for itself.
  std::string own(char letter);
  int literal();
  // A literal or a variable.
  std::string value();
  // Points, values or limits that programs come near.
  int small();

  std::string timer();
  std::string counter();
  std::string compare();
  std::string move();
  std::string arithmetic();
  std::string shift_register();
  std::string look_up_table();
  std::string piecewise_linear();
  std::string formatted_string();
  std::string pulse_width();
  std::string characters(int most);

  RandomSource& random_;
  const RandomLdmicroOptions& options_;
  std::vector<int> weights_;  // of the families that are elements
};

}  // namespace rung
