// SPDX-License-Identifier: Apache-2.0
// What a hard-wired program has outside: which bit of which port of its module is which device.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "logic/logic.hpp"
#include "rungs/program.hpp"
#include "rungs/special.hpp"

namespace rung::hardwired {

// Where a device's value at the start of a scan comes from.
struct Start {
  enum class Kind : std::uint8_t {
    Register,  // what the last scan, or the host, has left there
    Given,     // `text` is it in the scan's first clock, and not behind it
    Fixed,     // `text` is it for ever
  };
  Kind kind = Kind::Register;
  std::string text;
};

// Each list is a port, from its bit 0 up: a bit device takes one bit, a word 16.
struct Interface {
  std::vector<Device> inputs;        // in_i: X that the program does not write itself
  std::vector<Device> outputs;       // out_o: Y
  std::vector<Device> clocks;        // clocks_i: clock relays, for example M8013
  std::vector<std::int64_t> ticks;   // ticks_i: the base of each word of ticks, in microseconds
  std::vector<Device> state;         // state_i, state_o: what the program names, and device ports
  std::map<Device, int> state_bits;  // where each of them begins
  int state_width = 0;

  Interface(const Program& source, const core::Program& program, const logic::Logic& logic);

  const Start& start(Device device) const;
  bool first_scan() const { return first_scan_; }  // somebody reads whether it is

 private:
  void drive(Device device, const SpecialRange& special, bool written);

  std::map<Device, Start> starts_;  // but registers
  bool first_scan_ = false;
};

// "16'hFFFE", "1'b0"
std::string literal(Device device, std::int16_t value);

// A name for each device that no other one has and that is Verilog whatever is put behind it.
class Names {
 public:
  explicit Names(const Program& source) : source_(source) {}
  const std::string& of(Device device);

 private:
  const Program& source_;
  std::map<Device, std::string> names_;
  std::map<std::string, int> used_;
};

}  // namespace rung::hardwired
