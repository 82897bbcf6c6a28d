// SPDX-License-Identifier: Apache-2.0
// The condition under which an output instruction is executed.
#pragma once

#include <vector>

#include "lower/context.hpp"

namespace rung::lower {

// What has to hold beside the result for an instruction to be executed: all of these bits.
struct Requirements {
  std::vector<Device> valid;
};

// From begin() to end() core instructions run under the condition of the current source
// instruction: result, power and live, that it just came on for a pulse form, and its requirements,
// whose failure sets the error relays. After end() the result is what it was.
class Execution {
 public:
  Execution(Context& context, const Requirements& requirements);
  void end();

 private:
  Context& context_;
  bool branched_ = false;
  std::optional<Device> memory_;  // of a pulse form
};

// memory <- result, which has been gated, where live; leaves a result that is as good after gates.
void remember(Context& context, Device memory);

// bit <- value, under the current result: an exclusive choice of SET and RST.
void copy_bit(Context& context, Device bit, Device value, bool quiet = false);

// Sets the error relays that the program names if `inside` is 0, whatever the result.
void set_errors_beside(Context& context, Device inside);

}  // namespace rung::lower
