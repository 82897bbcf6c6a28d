// SPDX-License-Identifier: Apache-2.0
// The values of a hard-wired program as Verilog: how each is read in a given clock, and what each
// action makes of those it reads.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "hardwired/plan.hpp"

namespace rung::hardwired {

// A register that keeps a value which its device's own register has lost.
struct Hold {
  std::string name;
  std::int32_t clock = 0;  // in which it takes the value
  std::string value;       // as it is then
  bool word = false;
};

class Values {
 public:
  Values(const Program& source, const logic::Logic& logic, const Interface& interface,
         const Plan& plan);

  // The wires that action `i` needs, and those that it drives, one a line.
  std::string action(std::size_t i);
  // Operand 0 or 1 that action `i` gives to its unit, 16 or 32 bits wide.
  std::string unit_operand(std::size_t i, int which);
  // Whether a division by zero is executed in action `i`, in its clock.
  std::string zero_division(std::size_t i);

  // A device's value in a clock, as a name or a literal.
  std::string read(Device device, logic::Version version, std::int32_t clock);
  // A device's value as it is made in its clock.
  std::string wire(Device device, logic::Version version);
  std::string register_name(Device device) { return names_.of(device) + "_q"; }

  // Filled by all that was read so far.
  const std::set<Device>& registers() const { return registers_; }
  void need_register(Device device) { registers_.insert(device); }
  const std::vector<Hold>& holds() const { return holds_; }

 private:
  std::string operand(const logic::Operand& operand, std::int32_t clock);
  std::string pair(const logic::Action& action, std::size_t low, std::int32_t clock);
  std::string low_bits(const logic::Operand& word, std::int32_t clock, int bits,
                       const std::string& name, std::string& wires);
  std::string condition(std::size_t i, std::string& wires);
  std::string tree(logic::NodeId id, std::int32_t clock, std::string& wires);
  std::string make_tree(logic::NodeId id, std::int32_t clock, std::string& wires);
  // The new value of target `t`, if the action is executed; wires that all targets share.
  std::string result(std::size_t i, std::size_t t, std::string& wires);
  std::string comparison(const logic::Action& action, std::int32_t clock);
  std::string shared(std::size_t i, std::string& wires);

  const logic::Logic& logic_;
  const Interface& interface_;
  const Plan& plan_;
  Names names_;
  std::set<Device> registers_;
  std::vector<Hold> holds_;
  std::map<std::pair<Device, logic::Version>, std::size_t> held_;
  std::map<std::pair<logic::NodeId, std::int32_t>, std::string> trees_;
};

}  // namespace rung::hardwired
