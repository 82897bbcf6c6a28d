// SPDX-License-Identifier: Apache-2.0
#include "ldmicro/symbols.hpp"

#include <algorithm>

#include "rungs/ports.hpp"

namespace rung {
namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool is_ld_name(std::string_view text) {
  return !text.empty() && is_letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

Device LdSymbols::next(std::map<std::string, Device>& devices, const std::string& name,
                       DeviceKind kind) {
  const auto [found, is_new] = devices.try_emplace(name, Device{kind, used_[kind]});
  if (is_new) ++used_[kind];
  return found->second;
}

Device LdSymbols::bit(const std::string& name) {
  const DeviceKind kind = name.front() == 'X'   ? DeviceKind::X
                          : name.front() == 'Y' ? DeviceKind::Y
                                                : DeviceKind::M;
  return next(bits_, name, kind);
}

Device LdSymbols::variable(const std::string& name) {
  return next(variables_, name, DeviceKind::D);
}

Device LdSymbols::channel(const std::string& name) {
  const auto found = channels_.find(name);
  if (found != channels_.end()) return found->second;
  return channels_.emplace(name, port::at(port::adc, channels())).first->second;
}

std::map<Device, std::string> LdSymbols::names() const {
  std::map<Device, std::string> names;
  const auto trace_name = [&](const std::string& name) {
    return bits_.count(name) != 0 ? name + ":w" : name;
  };
  for (const auto& [name, device] : bits_) names[device] = name;
  for (const auto& [name, device] : variables_) names[device] = trace_name(name);
  for (const auto& [name, device] : channels_) names[device] = trace_name(name);
  return names;
}

}  // namespace rung
