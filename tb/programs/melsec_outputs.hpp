// SPDX-License-Identifier: Apache-2.0
// Random output instructions of MELSEC lists, as text.
#pragma once

#include <string>
#include <vector>

#include "programs/melsec_operands.hpp"

namespace rung {

class MelsecOutputs {
 public:
  MelsecOutputs(RandomSource& random, const RandomMelsecOptions& options, MelsecOperands& operands);

  // One output instruction of any family but those that shape the program.
  std::string output();

 private:
  std::string bit();
  std::string edge();
  std::string timer();
  std::string counter();
  std::string word(Family family);

  RandomSource& random_;
  MelsecOperands& operands_;
  std::vector<int> weights_;  // of the families of outputs
};

}  // namespace rung
