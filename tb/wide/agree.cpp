// SPDX-License-Identifier: Apache-2.0
#include "wide/agree.hpp"

#include <map>
#include <sstream>
#include <utility>

#include "driver/compile.hpp"
#include "lockstep/lockstep.hpp"
#include "lockstep/wide_machine.hpp"

namespace rung::tb {

WideProcessor& wide_processor(int slots, bool rtl) {
  static std::map<std::pair<int, bool>, std::unique_ptr<WideProcessor>> all;
  auto& one = all[{slots, rtl}];
  if (!one) one = rtl ? make_wide_processor(slots) : make_wide_simulator(slots);
  return *one;
}

std::string wide_difference(const Program& program, const Stimulus& stimulus, const WideHow& how,
                            std::int64_t* clocks) {
  CompileOptions options;
  options.mpu = isa::Mpu::Mpu4;
  options.slots = how.slots;
  options.merge = how.merge;
  options.search.tries = 4;
  Diagnostics diagnostics;
  const auto compiled = compile(program, options, diagnostics);
  if (!compiled) {
    std::ostringstream text;
    diagnostics.print(text);
    return "refused: " + text.str();
  }
  if (clocks != nullptr) *clocks = compiled->image.clocks;
  WideMachine machine(compiled->image, wide_processor(how.slots, how.rtl), how.tick_us);
  Lockstep lockstep(program, machine);
  for (std::uint64_t i = 0; i < stimulus.scans(); ++i) {
    auto difference = lockstep.scan(stimulus.events(i));
    if (!difference) difference = lockstep.compare_state();
    if (difference) return describe(*difference);
  }
  return {};
}

}  // namespace rung::tb
