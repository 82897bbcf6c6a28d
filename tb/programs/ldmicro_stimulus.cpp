// SPDX-License-Identifier: Apache-2.0
#include "programs/ldmicro_stimulus.hpp"

#include <algorithm>
#include <iterator>

#include "programs/random_source.hpp"
#include "rungs/ports.hpp"

namespace rung {
namespace {

constexpr std::int16_t kCorners[] = {1,    -1,    2,     9,      10,    99,    100,   255,
                                     1023, -1234, 32767, -32768, 32766, -9999, 12345, -32767};

std::int16_t word_value(RandomSource& random) {
  const int which = random.below(100);
  if (which < 40) return kCorners[random.below(static_cast<int>(std::size(kCorners)))];
  if (which < 80) return static_cast<std::int16_t>(random.below(12) - 3);
  return static_cast<std::int16_t>(random.bits() & 0xFFFF);
}

// An input, a preset or a sample: how often in a hundred scans, and what.
int chance_of(Device device, bool first, int calm) {
  if (device.kind == DeviceKind::PW) return 25;
  if (is_input(device)) return 50 >> calm;
  if (is_word(device)) return first ? 40 : 2;
  return first ? 10 : 1;
}

std::int16_t value_of(RandomSource& random, Device device) {
  if (device.kind == DeviceKind::PW && random.percent(80)) {
    return static_cast<std::int16_t>(random.below(1024));
  }
  return is_word(device) ? word_value(random) : static_cast<std::int16_t>(random.below(2));
}

int uses(const Program& program, Op op) {
  return static_cast<int>(
      std::count_if(program.instructions.begin(), program.instructions.end(),
                    [&](const Instruction& instruction) { return instruction.op == op; }));
}

}  // namespace

std::vector<std::vector<StimulusEvent>> ldmicro_stimulus(std::uint64_t seed, const Program& program,
                                                         int scans) {
  RandomSource random(seed ^ 0x7374696D);
  std::vector<std::vector<StimulusEvent>> events(static_cast<std::size_t>(scans));
  const bool receives = uses(program, Op::UartRecv) > 0;
  const int kept = uses(program, Op::Persist);
  const int calm = random.below(3);  // how long inputs stay as they are
  const int arrivals = random.below(60);
  // The lasting memory is never ready, as in LDmicro's simulator, or now and then.
  const int ready = kept > 0 && random.percent(70) ? 5 + random.below(60) : 0;
  for (int i = 0; i < kept && ready > 0; ++i) {
    events[0].push_back({port::at(port::persist_value, i), word_value(random)});
  }
  for (int scan = 0; scan < scans; ++scan) {
    auto& now = events[static_cast<std::size_t>(scan)];
    for (const auto& [device, name] : program.names) {
      if (!random.percent(chance_of(device, scan == 0, calm))) continue;
      now.push_back({device, value_of(random, device)});
    }
    if (receives && random.percent(arrivals)) {
      now.push_back({port::uart_rx_data, static_cast<std::int16_t>(random.below(256))});
    }
    if (ready > 0 && random.percent(ready)) now.push_back({port::persist_ready, 1});
  }
  return events;
}

}  // namespace rung
