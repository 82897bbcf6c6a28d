// SPDX-License-Identifier: Apache-2.0
#include "backends/c_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rungs/devices.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

std::vector<Device> used_ports(const Program& program) {
  std::set<Device> ports;
  for (const Instruction& instruction : program.instructions) {
    switch (instruction.op) {
      case Op::ReadAdc:
        ports.insert(port::at(port::adc, instruction.operand(1).value));
        break;
      case Op::SetPwm:
        ports.insert({port::pwm_duty, port::pwm_hz_low, port::pwm_hz_high});
        break;
      case Op::Persist:
        ports.insert({port::persist_ready, port::persist_index,
                      port::at(port::persist_value, instruction.operand(1).value)});
        break;
      case Op::UartSend:
      case Op::FormattedString:
        ports.insert({port::uart_tx_ready, port::uart_tx_data});
        break;
      case Op::UartRecv:
        ports.insert({port::uart_rx_full, port::uart_rx_data});
        break;
      default:
        break;
    }
  }
  return {ports.begin(), ports.end()};
}

}  // namespace

CLayout::CLayout(const Program& program)
    : program_(program),
      dialect_(program.dialect),
      devices_(named_devices(program)),
      ports_(used_ports(program)),
      named_(devices_.begin(), devices_.end()),
      windows_(index_windows(program)) {
  const auto reach = [&](DeviceKind kind, std::uint32_t last) {
    std::uint32_t& size = sizes_[static_cast<std::size_t>(kind)];
    size = std::max(size, last + 1);
  };
  if (dialect_ == Dialect::Ldmicro) return;
  for (const Device device : devices_) {
    if (!special(device)) reach(device.kind, device.number);
  }
  for (const IndexWindow& window : windows_) reach(window.kind, window.last);
}

std::vector<Device> CLayout::reachable() const {
  std::set<Device> devices = named_;
  for (const IndexWindow& window : windows_) {
    for (std::uint32_t n = window.first; n <= window.last; ++n) devices.insert({window.kind, n});
  }
  return {devices.begin(), devices.end()};
}

bool CLayout::special(Device device) const { return find_special(device, dialect_) != nullptr; }

bool CLayout::has_port(Device port) const {
  return std::binary_search(ports_.begin(), ports_.end(), port);
}

int CLayout::ports_from(Device first, int count) const {
  while (count > 0 && !has_port(port::at(first, count - 1))) --count;
  return count;
}

std::string CLayout::name(Device device) const {
  const std::string name = device_name(device, program_);
  return name.substr(0, name.find(':'));
}

std::string CLayout::port_place(Device port) {
  const auto among = [&](Device first, int count) {
    return port >= first && port < port::at(first, count);
  };
  if (among(port::adc, port::adc_count)) {
    return fmt::format("@.adc[{}]", port.number - port::adc.number);
  }
  if (among(port::persist_value, port::persist_value_count)) {
    return fmt::format("@.persist_value[{}]", port.number - port::persist_value.number);
  }
  return "@." + port::name(port);
}

std::string CLayout::array(DeviceKind kind) {
  return kind == DeviceKind::CNH ? "CNH" : std::string(kind_letters(kind));
}

std::string CLayout::number(Device device) const {
  const DeviceRange* const range = find_device_range(device.kind, dialect_);
  switch (range == nullptr ? 10 : range->base) {
    case 8:
      return fmt::format("{}{:o}", device.number > 7 ? "0" : "", device.number);
    case 16:
      return fmt::format("{}{:X}", device.number > 9 ? "0x" : "", device.number);
    default:
      return fmt::to_string(device.number);
  }
}

std::string CLayout::place(Device device) const {
  if (is_port(device.kind)) return port_place(device);
  if (dialect_ == Dialect::Ldmicro) {
    return fmt::format("@.{}_{}", is_word(device) ? 'w' : 'b', name(device));
  }
  if (special(device)) return fmt::format("@.{}{}", array(device.kind), device.number);
  return fmt::format("@.{}[{}]", array(device.kind), number(device));
}

const IndexWindow& CLayout::window(DeviceKind kind) const {
  return *std::find_if(windows_.begin(), windows_.end(),
                       [&](const IndexWindow& window) { return window.kind == kind; });
}

std::vector<Device> CLayout::of_role(SpecialRole role) const {
  std::vector<Device> found;
  for (const Device device : devices_of_role(role, dialect_)) {
    if (names(device)) found.push_back(device);
  }
  return found;
}

}  // namespace rung
