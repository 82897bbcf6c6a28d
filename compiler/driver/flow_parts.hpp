// SPDX-License-Identifier: Apache-2.0
// Parts of compile_flow.cpp: what is checked of a flowchart, its hidden devices, its tables.
#pragma once

#include <functional>
#include <set>
#include <vector>

#include "driver/passes.hpp"
#include "flowchart/flowchart.hpp"
#include "image/flow.hpp"

namespace rung::flow_parts {

// Errors where the chart has more than the task hardware; throws std::logic_error for indices that
// lead nowhere.
void check_chart(const flowchart::Flowchart& chart, const CompileOptions& options,
                 Diagnostics& diagnostics);

// Devices of flowchart.hpp, common to all routines. The lowering's own have numbers below and above
// (lower/context.cpp).
bool is_flow_device(Device device);
// Devices of one routine that no other one sees.
inline bool is_private(Device device) {
  return is_hidden(device.kind) && !is_port(device.kind) && !is_flow_device(device);
}

// What lowering makes of a step runs again only after other routines have used its hidden devices:
// every one is written before it is read, and there are no ticks and no tables of constants, which
// only LDmicro programs have. Empty, or what is wrong.
std::string remembers(const core::Program& program);

// Puts instructions in front that count the milliseconds and tenths that steps wait by, from the
// ticks that the controller writes before each scan.
void count_time(core::Program& ladder, const std::set<Device>& used);

// All of the chart's rungs as one program, the ladder's first: for names, source lines and counts.
Program whole_program(const flowchart::Flowchart& chart);

// Tables of the chart, without what the routines' places are: `address` gives that of a device.
image::FlowImage tables(const flowchart::Flowchart& chart,
                        const std::function<int(Device)>& address);

// Word devices of all transfers, and those through which steps and the task hardware speak.
std::set<Device> table_devices(const flowchart::Flowchart& chart);

}  // namespace rung::flow_parts
