// SPDX-License-Identifier: Apache-2.0
#include "io/subject.hpp"

#include <algorithm>

#include "rungs/devices.hpp"
#include "rungs/footprint.hpp"
#include "source/nearest.hpp"

namespace rung::io {

bool Subject::has(Device device) const {
  return std::any_of(devices.begin(), devices.end(),
                     [&](const SubjectDevice& each) { return each.device == device; });
}

std::string Subject::name(Device device) const {
  for (const SubjectDevice& each : devices) {
    if (each.device == device) return each.name;
  }
  return device_name(device, dialect);
}

std::optional<Device> Subject::find(std::string_view name, bool word) const {
  const auto wanted = [&](Device device) { return word ? value_of(device) : device; };
  if (dialect != Dialect::Ldmicro) {
    if (const auto device = parse_device_name(name, dialect)) return wanted(*device);
  }
  std::optional<Device> other;
  for (const SubjectDevice& each : devices) {
    if (is_port(each.device.kind)) continue;
    const bool own =
        dialect == Dialect::Ldmicro && (each.name == name || each.name == std::string(name) + ":w");
    if (!own && (each.comment.empty() || each.comment != name)) continue;
    if (each.name == name || is_word(each.device) == word) return each.device;
    if (!other) other = each.device;
  }
  return other;
}

std::optional<Device> Subject::find_channel(std::string_view name) const {
  for (const SubjectDevice& each : devices) {
    if (!is_port(each.device.kind)) continue;
    if (each.name == name || each.name == std::string(name) + ":w") return each.device;
  }
  return std::nullopt;
}

std::string Subject::near(std::string_view name) const {
  std::vector<std::string_view> names;
  for (const SubjectDevice& each : devices) {
    names.push_back(each.name);
    if (!each.comment.empty()) names.push_back(each.comment);
  }
  return std::string(nearest(name, names));
}

Subject subject_of(const Program& program, std::string_view config) {
  Subject subject;
  subject.file = program.file;
  subject.dialect = program.dialect;
  subject.config = config;
  const auto add = [&](Device device) {
    const auto comment = program.comments.find(device);
    subject.devices.push_back({device, device_name(device, program),
                               comment == program.comments.end() ? "" : comment->second});
  };
  for (const Device device : visible_devices(program)) {
    if (!is_hidden(device.kind)) add(device);
  }
  for (const auto& [device, name] : program.names) {
    if (is_port(device.kind)) add(device);
  }
  for (const Instruction& instruction : program.instructions) {
    subject.uart |= instruction.op == Op::UartSend || instruction.op == Op::UartRecv ||
                    instruction.op == Op::FormattedString;
    subject.pwm |= instruction.op == Op::SetPwm;
  }
  if (program.ldmicro) {
    subject.cycle_us = program.ldmicro->cycle_us;
    subject.own_pins = std::any_of(program.ldmicro->pins.begin(), program.ldmicro->pins.end(),
                                   [](const auto& pin) { return pin.pin != 0; });
  }
  return subject;
}

}  // namespace rung::io
