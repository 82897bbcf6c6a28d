// SPDX-License-Identifier: Apache-2.0
#include "agree/ldmicro_case.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "ldmicro/ldmicro.hpp"
#include "programs/ldmicro_stimulus.hpp"
#include "programs/random_ldmicro.hpp"
#include "programs/random_source.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

constexpr int kLeastScans = 16;
constexpr int kMostScans = 30;

// What stays the same when other elements go: numbers follow from the order in the file, and the
// mark of a variable from whether there is a bit of its name.
using Identity = std::pair<DeviceKind, std::string>;
Identity identity(const Program& program, Device device) {
  std::string name = device_name(device, program);
  if (name.ends_with(":w")) name.resize(name.size() - 2);
  return {device.kind, std::move(name)};
}

// The device ports through which elements that no trace shows are seen.
std::set<Device> ports_of(const Program& program) {
  std::set<Device> ports;
  for (const Instruction& instruction : program.instructions) {
    if (instruction.op == Op::UartRecv) ports.insert(port::uart_rx_full);
    if (instruction.op == Op::SetPwm) {
      ports.insert({port::pwm_duty, port::pwm_hz_low, port::pwm_hz_high});
    }
    if (instruction.op == Op::Persist) {
      ports.insert({port::persist_ready, port::persist_index,
                    port::at(port::persist_value, instruction.operand(1).value)});
    }
  }
  return ports;
}

std::vector<std::vector<StimulusEvent>> events_left(const Case& original, const Program& program) {
  std::map<Identity, Device> left;
  for (const auto& [device, name] : program.names) left[identity(program, device)] = device;
  const std::set<Device> ports = ports_of(program);
  std::vector<std::vector<StimulusEvent>> events;
  for (const auto& scan : original.events) {
    auto& now = events.emplace_back();
    for (const StimulusEvent& event : scan) {
      if (!original.program.names.contains(event.device)) {
        if (event.device == port::uart_rx_data || ports.contains(event.device)) {
          now.push_back(event);
        }
        continue;
      }
      const auto found = left.find(identity(original.program, event.device));
      if (found != left.end()) now.push_back({found->second, event.value});
    }
  }
  return events;
}

}  // namespace

std::string ldmicro_text_of(std::uint64_t seed) {
  return random_ldmicro(seed, ldmicro_options(seed));
}

std::optional<Case> make_ldmicro_case(std::uint64_t seed, const std::string& text,
                                      std::string& messages, const Case* original) {
  Diagnostics diagnostics;
  const auto source = decode_ldmicro(text, fmt::format("random-{}.ld", seed), diagnostics);
  std::optional<Program> program;
  if (source) program = parse_ldmicro(*source, diagnostics);
  if (!program) {
    std::ostringstream out;
    diagnostics.print(out);
    messages = out.str();
    return std::nullopt;
  }
  Case one{seed, text, std::move(*program), {}, 0, {}};
  one.tick_us = one.program.ldmicro->cycle_us;
  for (const auto& [device, name] : one.program.names) {
    if (!is_hidden(device.kind)) one.devices.push_back(device);
  }
  for (const Device port : ports_of(one.program)) one.devices.push_back(port);
  if (original != nullptr) {
    one.events = events_left(*original, one.program);
    return one;
  }
  RandomSource random(seed ^ 0x7363616E);
  const int scans = kLeastScans + random.below(kMostScans - kLeastScans + 1);
  one.events = ldmicro_stimulus(seed, one.program, scans);
  return one;
}

Behaviour run_ldmicro_reference(const Case& one, LdmicroCoverage* coverage) {
  Reference reference(one.program, one.tick_us);
  Behaviour behaviour;
  if (coverage != nullptr) coverage->count_shape(one.program);
  for (const auto& events : one.events) {
    for (const StimulusEvent& event : events) reference.set(event.device, event.value);
    if (coverage != nullptr) {
      coverage->run_scan(one.program, reference);
    } else {
      reference.run_scan();
    }
    std::vector<std::int16_t>& state = behaviour.states.emplace_back();
    for (const Device device : one.devices) state.push_back(reference.get(device));
    behaviour.sent.push_back(reference.sent());
    behaviour.errors.push_back(reference.error());
  }
  return behaviour;
}

}  // namespace rung::tb
