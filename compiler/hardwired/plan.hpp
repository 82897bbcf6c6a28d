// SPDX-License-Identifier: Apache-2.0
// In which clock of a scan each action of a hard-wired program happens.
//
// A program of bits is one clock, however long its paths are. One with words gets as many clocks as
// keep the estimated path between two registers below `Options::step_ns`; MUL and DIV pass through
// one pipelined unit of each kind, in a clock each and some clocks later. The count depends on the
// program alone.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "hardwired/interface.hpp"
#include "logic/logic.hpp"

namespace rung::hardwired {

inline constexpr double kDefaultStepNs = 8.0;

// The units that all MUL, DIV, ... of a program share: clocks from the one in which an action's
// operands are taken to the one in which its result is there.
struct Unit {
  core::Op op;
  const char* name;
  int latency;
};
inline constexpr std::array<Unit, 4> kUnits{{{core::Op::Mul, "mul16", 2},
                                             {core::Op::Mul32, "mul32", 3},
                                             {core::Op::Div, "div16", 11},
                                             {core::Op::Div32, "div32", 35}}};
const Unit* unit_of(core::Op op);

struct Plan {
  // By action. An action that nobody needs has no clock, -1.
  std::vector<std::int32_t> issue;      // in which it reads its operands
  std::vector<std::int32_t> clock;      // in which its value is there, and at whose end it is kept
  std::vector<std::vector<bool>> live;  // by target: whether somebody needs that value
  std::map<Device, std::vector<logic::Version>> versions;  // those that somebody needs, in order
  std::int32_t clocks = 1;

  // The first clock in which a value can be read; -1: before all clocks.
  std::int32_t made(Device device, logic::Version version, const Interface& interface) const;
  // The last clock in which the device's register holds the value; logic::kNever: the scan's end.
  std::int32_t kept(Device device, logic::Version version) const;
  bool is_live(Device device, logic::Version version) const;
};

Plan plan(const logic::Logic& logic, const Interface& interface, double step_ns);

}  // namespace rung::hardwired
