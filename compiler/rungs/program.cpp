// SPDX-License-Identifier: Apache-2.0
#include "rungs/program.hpp"

#include <fmt/format.h>

#include <set>

#include "rungs/devices.hpp"

namespace rung {

std::string_view dialect_name(Dialect dialect) {
  switch (dialect) {
    case Dialect::Paper:
      return "paper";
    case Dialect::Fx:
      return "fx";
    case Dialect::Q:
      break;
  }
  return "q";
}

std::string device_name(Device device, Dialect dialect) {
  const char letter = "XYMD"[static_cast<std::size_t>(device.kind)];
  switch (device_range(device.kind, dialect).base) {
    case 8:
      return fmt::format("{}{:o}", letter, device.number);
    case 16:
      return fmt::format("{}{:X}", letter, device.number);
    default:
      return fmt::format("{}{}", letter, device.number);
  }
}

ProgramCounts count(const Program& program) {
  ProgramCounts counts;
  counts.networks = static_cast<int>(program.networks.size());
  counts.instructions = static_cast<int>(program.instructions.size());
  bool in_run = false;
  for (const Instruction& instruction : program.instructions) {
    const bool contact = is_contact(instruction.op);
    if (contact) {
      const bool loads = instruction.op == Op::Ld || instruction.op == Op::Ldi;
      if (!in_run || loads) counts.run_lengths.push_back(0);
      ++counts.run_lengths.back();
      ++counts.contacts;
    }
    in_run = contact;
  }
  return counts;
}

std::vector<Device> named_devices(const Program& program) {
  std::set<Device> devices;
  for (const Instruction& instruction : program.instructions) {
    if (instruction.op == Op::Nop || (instruction.op >= Op::Anb && instruction.op <= Op::Mpp)) {
      continue;
    }
    devices.insert(instruction.device);
    if (instruction.double_width) {
      devices.insert({instruction.device.kind, instruction.device.number + 1});
    }
    if (instruction.op < Op::Mov) continue;
    const int sources = instruction.op == Op::Mov ? 1 : 2;
    for (int i = 0; i < sources; ++i) {
      if (!instruction.sources[i].constant) devices.insert(instruction.sources[i].device);
    }
  }
  return {devices.begin(), devices.end()};
}

}  // namespace rung
