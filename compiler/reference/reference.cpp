// SPDX-License-Identifier: Apache-2.0
#include "reference/reference.hpp"

#include <algorithm>

#include "rungs/ports.hpp"

namespace rung {
namespace {

// No device has a number as high, those of flow tasks (flowchart/flowchart.hpp) included; memory
// ends here whatever a program names.
constexpr std::uint32_t kDevicesOfAKind = 0x20000;

std::vector<Device> named_of_role(SpecialRole role, Dialect dialect,
                                  const std::vector<Device>& named) {
  std::vector<Device> devices = devices_of_role(role, dialect);
  std::erase_if(devices, [&](Device device) {
    return !std::binary_search(named.begin(), named.end(), device);
  });
  return devices;
}

}  // namespace

Reference::Reference(const Program& program, std::int64_t tick_us)
    : program_(program),
      windows_(index_windows(program)),
      begins_network_(program.instructions.size()),
      devices_(std::make_shared<Devices>()),
      memory_(program.instructions.size()),
      time_{-1, tick_us} {
  const std::vector<Device> named = named_devices(program);
  errors_ = named_of_role(SpecialRole::Error, program.dialect, named);
  zero_ = named_of_role(SpecialRole::Zero, program.dialect, named);
  borrow_ = named_of_role(SpecialRole::Borrow, program.dialect, named);
  carry_ = named_of_role(SpecialRole::Carry, program.dialect, named);
  for (const Network& network : program.networks) begins_network_.at(network.first) = true;
  for (std::size_t i = 0; i < program.instructions.size(); ++i) {
    const Instruction& each = program.instructions[i];
    if (each.op == Op::FormattedString) messages_[i].steps = string_steps(each.table);
  }
}

Reference::Reference(const Program& program, const Reference& other)
    : Reference(program, other.time_.tick_us) {
  devices_ = other.devices_;
  drives_ = false;
}

void Reference::set(Device device, std::int16_t value) {
  if (device.number >= kDevicesOfAKind) return;
  if (!is_word(device)) value = value != 0 ? 1 : 0;
  // A byte that arrives is one that waits.
  if (device == port::uart_rx_data) set(port::uart_rx_full, 1);
  auto& devices = devices_->at(static_cast<std::size_t>(device.kind));
  if (device.number >= devices.size()) devices.resize(device.number + 1);
  devices[device.number] = value;
}

std::int16_t Reference::get(Device device) const {
  const auto& devices = devices_->at(static_cast<std::size_t>(device.kind));
  return device.number < devices.size() ? devices[device.number] : std::int16_t{0};
}

void Reference::run_scan() {
  begin_scan();
  while (step()) {
  }
}

void Reference::begin_scan() {
  ++time_.scan;
  for (const SpecialRange& special : special_ranges()) {
    if (!drives_ || special.dialect != program_.dialect || !is_driven(special.role)) continue;
    for (std::uint32_t n = special.first; n <= special.last; ++n) {
      set({special.kind, n}, driven_value(special, time_) ? 1 : 0);
    }
  }
  next_ = 0;
  now_ = {};
  callers_.clear();
  loops_.clear();
  writes_.clear();
  error_ = false;
  relay_ = true;
  forks_.clear();
  sent_.clear();
  if (seen_ != nullptr) seen_->assign(program_.instructions.size(), {});
}

bool Reference::step() {
  if (next_ >= program_.instructions.size()) return false;
  current_ = next_++;
  if (begins_network_[current_]) {
    now_.blocks.clear();
    now_.branches.clear();
  }
  if (seen_ == nullptr) {
    execute(program_.instructions[current_]);
  } else {
    execute_seen(program_.instructions[current_]);
  }
  return true;
}

void Reference::execute_seen(const Instruction& instruction) {
  const bool rail = power();
  const bool result = now_.result;  // an output keeps it; behind a CALL it is the subroutine's
  execute(instruction);
  const Op op = instruction.op;
  const bool conducts = op == Op::Stl    ? now_.state_power
                        : is_contact(op) ? closed_
                        : is_output(op)  ? result
                                         : now_.result;
  seen_->at(current_) = {true, rail, conducts};
}

void Reference::execute(const Instruction& instruction) {
  const Op op = instruction.op;
  if (op <= Op::Label) return;
  if (op <= Op::OrCompare) return execute_contact(instruction);
  if (op <= Op::Mpp) return execute_block(op);
  if (op <= Op::Ret) return execute_zone(instruction);
  if (op >= Op::Rung) return execute_element(instruction);
  if (op >= Op::Cj) return execute_flow(instruction);
  switch (op) {
    case Op::OutT:
      return out_timer(instruction);
    case Op::OutC:
      return out_counter(instruction);
    case Op::Out:
    case Op::Outi:
    case Op::Pls:
    case Op::Plf:
      return execute_coil(instruction);
    case Op::Rst:
      return reset(instruction);
    default:
      break;
  }
  if (!executes(instruction)) return;
  if (std::none_of(instruction.operands.begin(), instruction.operands.end(),
                   [](const Operand& operand) { return operand.index.has_value(); })) {
    return execute_located(instruction);
  }
  const std::optional<Instruction> located = locate(instruction);
  if (!located) return fail();
  execute_located(*located);
}

void Reference::execute_located(const Instruction& instruction) {
  if (instruction.op < Op::Mov) return execute_bits(instruction);
  execute_word(instruction);
}

bool Reference::power() const {
  return now_.state_power && std::all_of(now_.masters.begin(), now_.masters.end(),
                                         [](const Master& master) { return master.power; });
}

bool Reference::executes(const Instruction& instruction) {
  const bool on = condition();
  return instruction.pulse ? !exchange_memory(on) && on : on;
}

bool Reference::exchange_memory(bool value) {
  const bool before = memory_[current_];
  memory_[current_] = value;
  return before;
}

void Reference::write(Device device, std::int16_t value) {
  set(device, value);
  writes_.push_back({device, value, current_});
}

void Reference::change(Device device, std::int16_t value) {
  if (get(device) != value) write(device, value);
}

}  // namespace rung
