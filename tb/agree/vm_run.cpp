// SPDX-License-Identifier: Apache-2.0
#include "agree/vm_run.hpp"

#include "bytecode/vm_engine.hpp"

namespace rung::tb {

Behaviour run_as_bytecode(const Case& one) {
  VmEngine engine(one.program, one.tick_us);
  Behaviour behaviour;
  for (const auto& events : one.events) {
    engine.apply(events);
    engine.scan();
    std::vector<std::int16_t>& state = behaviour.states.emplace_back();
    for (const Device device : one.devices) state.push_back(engine.value(device));
    behaviour.sent.push_back(engine.sent());
  }
  return behaviour;
}

}  // namespace rung::tb
