// SPDX-License-Identifier: Apache-2.0
// How an instruction is shown: its sign, its words, and the devices whose values stand with it.
#pragma once

#include <string>
#include <vector>

#include "rungs/program.hpp"

namespace rung::view {

enum class Sign : std::uint8_t {
  Contact,
  ContactNot,
  ContactUp,    // on a rising edge
  ContactDown,  // on a falling edge
  Compare,
  Invert,
  EdgeUp,  // of the result so far
  EdgeDown,
  Coil,
  CoilNot,
  CoilSet,
  CoilReset,
  CoilUp,  // PLS
  CoilDown,
  CoilToggle,
  Box,   // anything else with a condition
  Mark,  // what stands between networks: labels, ends of zones
  Short,
  Open,
};
// As the page calls it: "contact", "contact-not", ...
std::string_view sign_name(Sign sign);

struct Symbol {
  Sign sign = Sign::Box;
  std::string text;             // a box's instruction; a compare's; of a contact or coil its device
  std::vector<Device> devices;  // in the order of the operands
};

Symbol symbol_of(const Instruction& instruction, const Program& program);

// The devices that it writes; flags are not among them.
std::vector<Device> written_devices(const Instruction& instruction, Dialect dialect);

}  // namespace rung::view
