// SPDX-License-Identifier: Apache-2.0
// Where byte code has its devices: bits and words numbered from 0, constants behind the words.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/program.hpp"
#include "rungs/program.hpp"

namespace rung::bytecode {

class Layout {
 public:
  // Devices that the program shows first, the lowering's own and ports behind them, each by kind
  // and number: so the devices of a window lie together, in order.
  Layout(const Program& source, const core::Program& program);

  int number(Device device) const { return devices_.at(device); }
  // A word operand, a constant too.
  int number(const core::WordSource& source) const;
  const std::map<Device, int>& devices() const { return devices_; }

  int bits() const { return bits_; }
  int first_constant() const { return words_; }
  const std::vector<std::int16_t>& constants() const { return constants_; }
  int words() const { return words_ + static_cast<int>(constants_.size()); }

 private:
  std::map<Device, int> devices_;
  std::map<std::int16_t, int> constant_numbers_;
  std::vector<std::int16_t> constants_;
  int bits_ = 0;
  int words_ = 0;
};

}  // namespace rung::bytecode
