// SPDX-License-Identifier: Apache-2.0
#include "agree/vm_run.hpp"

#include <map>

#include "bytecode/vm_engine.hpp"
#include "rungs/ports.hpp"

namespace rung::tb {
namespace {

bool has_port(const VmEngine& engine, Device port) {
  rung_vm_device place;
  const auto space = static_cast<std::uint8_t>(is_word(port) ? RUNG_SPACE_WORD : RUNG_SPACE_BIT);
  return rung_vm_port(&engine.vm(), space, static_cast<std::uint8_t>(port.number), &place) != 0;
}

}  // namespace

Behaviour run_as_bytecode(const Case& one) {
  VmEngine engine(one.program, one.tick_us);
  Behaviour behaviour;
  // Ports as they were given: where an element can never do anything (behind OPEN), byte code does
  // not have its ports.
  std::map<Device, std::int16_t> given;
  for (const auto& events : one.events) {
    for (const StimulusEvent& event : events) {
      given[event.device] = event.value;
      if (event.device == port::uart_rx_data) given[port::uart_rx_full] = 1;
    }
    engine.apply(events);
    engine.scan();
    std::vector<std::int16_t>& state = behaviour.states.emplace_back();
    for (const Device device : one.devices) {
      const bool left_out = is_port(device.kind) && !has_port(engine, device);
      state.push_back(left_out ? given[device] : engine.value(device));
    }
    behaviour.sent.push_back(engine.sent());
    behaviour.errors.push_back(engine.error());
  }
  return behaviour;
}

}  // namespace rung::tb
