// SPDX-License-Identifier: Apache-2.0
#include "bytecode/layout.hpp"

#include <set>

#include "rungs/footprint.hpp"

namespace rung::bytecode {

Layout::Layout(const Program& source, const core::Program& program) {
  std::set<Device> all;
  for (const Device device : visible_devices(source)) all.insert(device);
  for (const Device device : core::devices(program)) all.insert(device);
  for (const auto& window : program.windows) all.insert(window.begin(), window.end());
  for (const core::TickWord& word : program.ticks) all.insert(word.device);
  for (const core::ConstantWord& word : program.constants) all.erase(word.device);
  // Hidden kinds stand last among the bits and among the words.
  for (const Device device : all) devices_[device] = is_word(device) ? words_++ : bits_++;

  // Tables are read by an index: each in one piece.
  for (const core::ConstantWord& word : program.constants) {
    devices_[word.device] = words();
    constants_.push_back(word.value);
  }
  for (const core::Instruction& instruction : program.instructions) {
    // The number of a bit stands in the instruction itself.
    if (instruction.op == core::Op::Tb) continue;
    for (const core::WordSource& operand : instruction.sources) {
      if (!operand.constant) continue;
      const auto [place, fresh] = constant_numbers_.try_emplace(operand.value, words());
      if (fresh) constants_.push_back(operand.value);
    }
  }
}

int Layout::number(const core::WordSource& source) const {
  return source.constant ? constant_numbers_.at(source.value) : number(source.device);
}

}  // namespace rung::bytecode
