// SPDX-License-Identifier: Apache-2.0
#include "rungs/program.hpp"

#include <set>

#include "rungs/footprint.hpp"

namespace rung {

bool is_load(Op op) {
  switch (op) {
    case Op::Ld:
    case Op::Ldi:
    case Op::LdP:
    case Op::LdF:
    case Op::LdCompare:
      return true;
    default:
      return false;
  }
}

bool is_output(Op op) { return op == Op::Mc || (op >= Op::Out && op <= Op::Call); }

ProgramCounts count(const Program& program) {
  ProgramCounts counts;
  counts.networks = static_cast<int>(program.networks.size());
  bool in_run = false;
  for (const Instruction& instruction : program.instructions) {
    if (instruction.op == Op::Label || is_frame(instruction.op)) continue;
    ++counts.instructions;
    const bool contact = is_contact(instruction.op);
    if (contact) {
      if (!in_run || is_load(instruction.op)) counts.run_lengths.push_back(0);
      ++counts.run_lengths.back();
      ++counts.contacts;
    }
    in_run = contact;
  }
  return counts;
}

std::string device_name(Device device, const Program& program) {
  const auto name = program.names.find(device);
  return name == program.names.end() ? device_name(device, program.dialect) : name->second;
}

std::vector<Device> named_devices(const Program& program) {
  std::set<Device> devices;
  for (const Instruction& instruction : program.instructions) {
    for (const Device device : footprint(instruction, program.dialect)) devices.insert(device);
  }
  return {devices.begin(), devices.end()};
}

}  // namespace rung
