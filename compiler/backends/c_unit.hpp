// SPDX-License-Identifier: Apache-2.0
// What the parts of the C back end share while they write one program.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "backends/c_helpers.hpp"
#include "backends/c_layout.hpp"
#include "backends/c_source.hpp"
#include "backends/c_writer.hpp"
#include "rungs/program.hpp"

namespace rung {

struct CUnit {
  CUnit(const Program& source_program, const COptions& c_options)
      : program(source_program),
        options(c_options),
        layout(source_program),
        helpers(options.bare),
        body(options.prefix) {}

  const Program& program;
  const COptions& options;
  CLayout layout;
  CHelpers helpers;
  CSource body;  // the program's functions

  // Edge memories, by the index of their instruction: a subroutine may be written in two functions
  // where a program enters it at two labels, and they share them.
  std::map<std::size_t, std::size_t> edges;
  std::set<std::int64_t> tick_bases;  // of timers, us
  std::set<Device> timers;            // contacts of timers that have an OUT
  // Kinds of contacts whose timers or counters need a state.
  std::set<DeviceKind> stateful;
  int strings = 0;       // FORMATTED_STRINGs, each of which has memories
  bool has_tof = false;  // which asks whether it is the first scan

  bool is_ldmicro() const { return program.dialect == Dialect::Ldmicro; }
  bool hooks() const { return is_ldmicro() && options.hooks && !options.bare; }
  bool knows_first_scan() const { return !is_ldmicro() || has_tof; }

  std::string edge(const Instruction& instruction) {
    const auto index = static_cast<std::size_t>(&instruction - program.instructions.data());
    return fmt::format("@.edge[{}]", edges.try_emplace(index, edges.size()).first->second);
  }
};

// `ticks_100ms`, `phase_5us`: what a program keeps for a base or a period of time.
std::string time_name(std::string_view what, std::int64_t us);

}  // namespace rung
