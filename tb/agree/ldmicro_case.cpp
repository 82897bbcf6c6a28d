// SPDX-License-Identifier: Apache-2.0
#include "agree/ldmicro_case.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <utility>

#include "ldmicro/ldmicro.hpp"
#include "programs/ldmicro_stimulus.hpp"
#include "programs/random_ldmicro.hpp"
#include "programs/random_source.hpp"

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

std::vector<std::vector<StimulusEvent>> events_left(const Case& original, const Program& program) {
  std::map<Identity, Device> left;
  for (const auto& [device, name] : program.names) left[identity(program, device)] = device;
  std::vector<std::vector<StimulusEvent>> events;
  for (const auto& scan : original.events) {
    auto& now = events.emplace_back();
    for (const StimulusEvent& event : scan) {
      if (!original.program.names.contains(event.device)) {
        now.push_back(event);  // a received byte
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
  }
  return behaviour;
}

}  // namespace rung::tb
